// SPDX-License-Identifier: Apache-2.0
// pu_regions: from a Gaussian's conic in a part of a window to its coefficients and regions, and the payload that
//         waited beside it.
//
// Paper   Eq. 3, and the tile test of Sec. 4.2.
// Idea    coeff -> queue -> intersect. The queue evens out pu_intersect, which takes 2 to 64 cycles where the others
//         take 8 or 4. The payload comes from where it is known, before the conic does. It waits in a queue until
//         pu_intersect takes or drops its Gaussian, then in pu_payload until the regions are known. Only wiring here.
// Stream  conic in; payload in, one for each Gaussian, in order, not refused; tiles out and beside them their payload,
//         zero beside an end. Gaussians without a region vanish, ends pass.
// Pace    One Gaussian per Pace cycles, 8 or 4, or per region of its box.
// Model   intersect() in cpp_model/golden.cpp

module pu_regions #(
  parameter int unsigned PayloadW = 32
) (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                payload_valid_i,
  input  logic [PayloadW-1:0] payload_i,

  input  logic                conic_valid_i,
  output logic                conic_ready_o,
  input  pipegs_pkg::conic_t  conic_i,

  output logic                tiles_valid_o,
  input  logic                tiles_ready_i,
  output pipegs_pkg::tiles_t  tiles_o,
  output logic [PayloadW-1:0] payload_o,

  output logic                moved_o,  // a beat moved inside or out
  output logic                busy_o    // a record is inside
);

  localparam int unsigned WalkDepth = pipegs_pkg::WalkDepth;
  localparam int unsigned Waiting   = pipegs_pkg::PayloadDepth;

  logic                           coeff_valid, coeff_ready, walk_valid, walk_ready, coeff_busy, intersect_busy;
  logic                           drop, go, leave, waiting_room, waiting_held;
  logic [PayloadW-1:0]            waiting, payload;
  logic [$clog2(Waiting+1)-1:0]   waiting_count;
  logic [$clog2(WalkDepth+1)-1:0] walk_count;
  pipegs_pkg::coeff_t             coeff, walk;

  assign moved_o   = (coeff_valid && coeff_ready) || (walk_valid && walk_ready) || (tiles_valid_o && tiles_ready_i);
  assign busy_o    = coeff_busy || walk_count != '0 || intersect_busy;
  assign payload_o = tiles_o.kind == pipegs_pkg::KindData ? payload : '0;

  if (pipegs_pkg::Pace == 4) begin : gen_four_coeff
    pu_four_coeff u_coeff (
      .clk_i,
      .rst_ni,
      .conic_valid_i,
      .conic_ready_o,
      .conic_i,
      .coeff_valid_o(coeff_valid),
      .coeff_ready_i(coeff_ready),
      .coeff_o(coeff),
      .busy_o(coeff_busy)
    );
  end else begin : gen_coeff
    pu_coeff u_coeff (
      .clk_i,
      .rst_ni,
      .conic_valid_i,
      .conic_ready_o,
      .conic_i,
      .coeff_valid_o(coeff_valid),
      .coeff_ready_i(coeff_ready),
      .coeff_o(coeff),
      .busy_o(coeff_busy)
    );
  end

  pipegs_sram_fifo #(.DataW(pipegs_pkg::CoeffBits), .Depth(WalkDepth)) u_walks (
    .clk_i,
    .rst_ni,
    .in_valid_i(coeff_valid),
    .in_ready_o(coeff_ready),
    .in_i(coeff),
    .out_valid_o(walk_valid),
    .out_ready_i(walk_ready),
    .out_o(walk),
    .count_o(walk_count)
  );

  pu_intersect u_intersect (
    .clk_i,
    .rst_ni,
    .coeff_valid_i(walk_valid),
    .coeff_ready_o(walk_ready),
    .coeff_i(walk),
    .tiles_valid_o,
    .tiles_ready_i,
    .tiles_o,
    .drop_o(drop),
    .walk_o(go),
    .leave_o(leave),
    .busy_o(intersect_busy)
  );

  pipegs_sram_fifo #(.DataW(PayloadW), .Depth(Waiting)) u_waiting (
    .clk_i,
    .rst_ni,
    .in_valid_i(payload_valid_i),
    .in_ready_o(waiting_room),
    .in_i(payload_i),
    .out_valid_o(waiting_held),
    .out_ready_i(drop || go),
    .out_o(waiting),
    .count_o(waiting_count)
  );

  pu_payload #(.DataW(PayloadW)) u_payload (
    .clk_i,
    .rst_ni,
    .walk_i(go),
    .payload_i(waiting),
    .leave_i(leave),
    .payload_o(payload)
  );

  logic unused;
  assign unused = &{1'b0, waiting_room, waiting_held, waiting_count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!payload_valid_i || waiting_room)
    else $error("more Gaussians than places for their payloads");
  always_ff @(posedge clk_i) if (rst_ni) assert (!(drop || go) || waiting_held)
    else $error("a payload is not there in time");
`endif

endmodule
