// SPDX-License-Identifier: Apache-2.0
// ru_dispatch: deals the sorted splats to the RUs that own a region of them.
//
// Paper   Fig. 7 (SUs feed the RUs).
// Idea    One register holds the splat and one bit per RU that has not taken it yet. The whole mask goes along,
//         because a region's line is found by counting the mask's lower bits. Each RU has a queue at its input, so
//         RUs may drift apart; a full queue stalls the dispatch. End beats go to all RUs.
// Stream  sorted_t in; the same sorted_t to each RU whose regions it covers. Splats that cover nothing vanish.
// Pace    One splat per cycle.
// Model   ru_own_mask in cpp_model/ru/ru_walk.hpp

module ru_dispatch (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         in_valid_i,
  output logic                         in_ready_o,
  input  pipegs_pkg::sorted_t          in_i,

  output logic [pipegs_pkg::Units-1:0] out_valid_o,
  input  logic [pipegs_pkg::Units-1:0] out_ready_i,
  output pipegs_pkg::sorted_t          out_o,        // one record for all

  output logic                         active_o
);

  localparam int unsigned Units = pipegs_pkg::Units;

  logic [Units-1:0]    waiting_q;  // RUs that have not taken the splat yet
  logic [Units-1:0]    covers;
  pipegs_pkg::sorted_t out_q;

  for (genvar i = 0; i < Units; i += 1) begin : gen_unit
    logic [pipegs_pkg::MaskW-1:0] own;
    ru_own u_own (
      .unit_i(pipegs_pkg::UnitW'(i)),
      .own_o(own)
    );
    assign covers[i] = in_i.kind != pipegs_pkg::KindData || (in_i.mask & own) != '0;
  end

  assign out_valid_o = waiting_q;
  assign out_o       = out_q;
  assign in_ready_o  = (waiting_q & ~out_ready_i) == '0;
  assign active_o    = in_valid_i || waiting_q != '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) waiting_q <= '0;
    else if (!in_ready_o) waiting_q <= waiting_q & ~out_ready_i;
    else waiting_q <= in_valid_i ? covers : '0;
  end

  always_ff @(posedge clk_i) begin
    if (in_valid_i && in_ready_o) out_q <= in_i;
  end

`ifndef SYNTHESIS
  pipegs_stream_check #(.Ports(pipegs_pkg::Units), .Shared(1), .DataW($bits(out_o))) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
`endif

endmodule
