// SPDX-License-Identifier: Apache-2.0
// pu_front: the part of a PU that fetches the Gaussians of its chunks and culls them.
//
// Paper   Fig. 7 (PU), Sec. 4.2.1.
// Idea    fetch -> decode (Coded) -> cull -> reach (TightCull). One Gaussian a cycle goes in, and of those that leave
//         pu_deal gives each PU one in Pace cycles, so PuFronts of the PUs can feed all of them. Only wiring here.
// Stream  chunk in; visible out, to pu_deal; a port to external memory for geometry.
// Pace    One Gaussian per cycle.
// Model   preprocess() in cpp_model/golden.cpp

module pu_front #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned BurstW   = pipegs_pkg::BurstW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  pipegs_pkg::rotation_t    rotation_i,
  input  pipegs_pkg::lens_t        lens_i,
  input  pipegs_pkg::windows_t     windows_i,
  input  pipegs_pkg::open_t        open_i,
  input  pipegs_pkg::span_t        gaussians_i,  // the geometry

  input  logic                     chunk_valid_i,
  output logic                     chunk_ready_o,
  input  pipegs_pkg::chunk_t       chunk_i,

  output logic                     geometry_valid_o,
  input  logic                     geometry_ready_i,
  output logic [AddressW-1:0]      geometry_address_o,
  output logic [BurstW-1:0]        geometry_lines_o,  // less one
  input  logic                     geometry_rsp_valid_i,
  input  logic [MemoryW-1:0]       rsp_data_i,

  output logic                     visible_valid_o,
  input  logic                     visible_ready_i,
  output pipegs_pkg::visible_t     visible_o,

  output logic                     bad_o,      // see pu_fetch
  output logic [AddressW-1:0]      bad_line_o,
  output logic                     moved_o,    // a Gaussian was fetched
  output logic                     waiting_o,  // the next Gaussian waits for the memory
  output logic                     culls_o,    // Gaussians are in the cull, or before it in pu_decode
  output logic                     idle_o      // no chunk is inside
);

  localparam int unsigned ArrivedW = pipegs_pkg::Coded ? pipegs_pkg::CodedBits : pipegs_pkg::FetchedBits;
  logic                 arrived_valid, arrived_ready, fetched_valid, fetched_ready, survivor_valid, survivor_ready;
  logic                 decode_busy, cull_busy, reach_busy;
  logic [ArrivedW-1:0]  arrived;   // from memory
  pipegs_pkg::fetched_t fetched;
  pipegs_pkg::visible_t survivor;  // of the cull
  pipegs_pkg::gap_t     gap;

  pu_fetch u_fetch (
    .clk_i,
    .rst_ni,
    .gaussians_i,
    .chunk_valid_i,
    .chunk_ready_o,
    .chunk_i,
    .mem_valid_o(geometry_valid_o),
    .mem_ready_i(geometry_ready_i),
    .mem_address_o(geometry_address_o),
    .mem_lines_o(geometry_lines_o),
    .rsp_valid_i(geometry_rsp_valid_i),
    .rsp_data_i,
    .fetched_valid_o(arrived_valid),
    .fetched_ready_i(arrived_ready),
    .fetched_o(arrived),
    .bad_o,
    .bad_line_o,
    .waiting_memory_o(waiting_o),
    .idle_o
  );

  if (pipegs_pkg::Coded) begin : gen_decode
    pu_decode u_decode (
      .clk_i,
      .rst_ni,
      .coded_valid_i(arrived_valid),
      .coded_ready_o(arrived_ready),
      .coded_i(arrived),
      .fetched_valid_o(fetched_valid),
      .fetched_ready_i(fetched_ready),
      .fetched_o(fetched),
      .busy_o(decode_busy)
    );
  end else begin : gen_whole
    assign fetched_valid = arrived_valid;
    assign arrived_ready = fetched_ready;
    assign fetched       = arrived;
    assign decode_busy   = 1'b0;
  end

  pu_cull u_cull (
    .clk_i,
    .rst_ni,
    .rotation_i,
    .lens_i,
    .windows_i,
    .open_i,
    .fetched_valid_i(fetched_valid),
    .fetched_ready_o(fetched_ready),
    .fetched_i(fetched),
    .visible_valid_o(survivor_valid),
    .visible_ready_i(survivor_ready),
    .visible_o(survivor),
    .gap_o(gap),
    .busy_o(cull_busy)
  );

  if (pipegs_pkg::TightCull != 0) begin : gen_reach
    pu_reach u_reach (
      .clk_i,
      .rst_ni,
      .rotation_i,
      .lens_i,
      .culled_valid_i(survivor_valid),
      .culled_ready_o(survivor_ready),
      .culled_i({gap, survivor}),
      .visible_valid_o,
      .visible_ready_i,
      .visible_o,
      .busy_o(reach_busy)
    );
  end else begin : gen_no_reach
    logic unused_gap;
    assign visible_valid_o = survivor_valid;
    assign survivor_ready  = visible_ready_i;
    assign visible_o       = survivor;
    assign reach_busy      = 1'b0;
    assign unused_gap      = &{1'b0, gap};
  end

  assign moved_o = arrived_valid && arrived_ready;
  assign culls_o = decode_busy || cull_busy || reach_busy;

endmodule
