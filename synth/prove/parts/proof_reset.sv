// SPDX-License-Identifier: Apache-2.0
// proof_reset: every trace begins in reset; later the reset may come at any time.
//
// Idea    Registers start with free values, as in silicon. The one initialised register of a proof is here; an
//         induction step, which starts anywhere, is not bound by it.

module proof_reset (
  input logic clk_i,
  input logic rst_ni
);

  logic started_q = 1'b0;

  always_ff @(posedge clk_i) started_q <= 1'b1;
  always_comb if (!started_q) assume (!rst_ni);

endmodule
