// SPDX-License-Identifier: Apache-2.0
// pipegs_reset_sync: a reset that comes at any time and goes at a clock edge.
//
// Idea    All registers of the core are reset asynchronously: they need no clock to begin, but must be let go in one
//         cycle, far enough from an edge. Two flip-flops, both reset by rst_ni, pass a one on: the first may be
//         metastable when rst_ni rises beside an edge and has a cycle to settle, the second lets go. In the scan test
//         (test_mode_i) the tester drives the reset, since the flip-flops hold its patterns.
// Stream  rst_ni may change at any time. rst_no falls with it, without a clock; it rises behind an edge of clk_i.
// Pace    Rises with the second rising edge of clk_i behind rst_ni, the third if the first flip-flop missed one.
// Model   Two flags in the test.

module pipegs_reset_sync (
  input  logic clk_i,
  input  logic rst_ni,     // low: reset; from outside, without a clock
  input  logic test_mode_i,  // scan test of the silicon, else 0
  output logic rst_no      // low: reset; of the clock clk_i
);

  (* async_reg = "true", keep *) logic [1:0] release_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) release_q <= '0;
    else release_q <= {release_q[0], 1'b1};
  end

  assign rst_no = test_mode_i ? rst_ni : release_q[1];

endmodule
