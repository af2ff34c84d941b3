// SPDX-License-Identifier: Apache-2.0
// pipegs_sleep: lets a unit's clock stop while everything in it waits for somebody else.
//
// Paper   Sec. 4.1 (a layer's results are double-buffered: a PU that is too far ahead has to wait).
// Idea    A unit full of work that cannot move, because nobody takes what it makes, need not be clocked. None of its
//         stages works for more than Patience cycles without a beat moving on some stream, so after that many quiet
//         cycles nothing inside can change before something comes from outside: asleep_o stops the clock, wake_i starts
//         it at once.
// Stream  moved_i: a beat moved, or memory was asked, in this cycle. wake_i: something came from outside.
// Pace    Falls asleep after Patience quiet cycles; awake in the cycle of wake_i, nothing is lost.
// Model   None: the streams are the same with and without it.

module pipegs_sleep #(
  parameter int unsigned Patience = 127
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic moved_i,
  input  logic wake_i,
  output logic asleep_o
);

  localparam int unsigned CountW = $clog2(Patience + 1);

  logic [CountW-1:0] quiet_q;  // cycles since the last beat moved

  assign asleep_o = quiet_q == CountW'(Patience) && !wake_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) quiet_q <= '0;
    else if (moved_i || wake_i) quiet_q <= '0;
    else if (quiet_q != CountW'(Patience)) quiet_q <= quiet_q + 1'b1;
  end

endmodule
