// SPDX-License-Identifier: Apache-2.0
// pipegs_clock_gate: the clock of one unit, stopped while the unit has nothing to do.
//
// Idea    A latch holds the enable while the clock is high, so the gated clock has no glitch. In silicon it saves the
//         unit's clock power; in Verilator a unit whose clock does not tick costs nothing. An FPGA has no latch that
//         could stand before its clock trees: with ClockGates = 0 the clock passes as it is.
// Stream  enable_i of the low phase before an edge decides whether that edge reaches clk_o. In reset and while
//         scan_en_i is high (patterns of the scan test shift) every edge does, with ClockGates = 0 always.
// Pace    No delay: an enable that rises in a cycle already passes that cycle's closing edge.
// Model   None needed: gating never changes what a unit computes.

module pipegs_clock_gate (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic scan_en_i,
  input  logic enable_i,
  output logic clk_o
);

  if (pipegs_pkg::ClockGates != 0) begin : gen_gate
    logic enable_q;
    always_latch begin
      if (!clk_i) enable_q = enable_i || scan_en_i || !rst_ni;
    end
    assign clk_o = clk_i & enable_q;
  end else begin : gen_wire
    assign clk_o = clk_i;
    logic unused;
    assign unused = &{1'b0, rst_ni, scan_en_i, enable_i};
  end

endmodule
