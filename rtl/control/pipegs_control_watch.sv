// SPDX-License-Identifier: Apache-2.0
// pipegs_control_watch: tells that memory is silent: it owes answers, and none comes for a number of cycles.
//
// Idea    A count that begins anew with everything that moves, and at its end, so silence is told again and again while
//         it lasts: whoever waits for a frame that was begun in it learns of it, too. A new limit counts from the next
//         movement on, or from now where there was none.
// Stream  limit_i: cycles, 0: none. waits_i: something is owed; moves_i: something is taken or answered in this cycle.
//         tell_o: pulse. silent_o: from the first pulse on until something moves or nothing is owed.
// Pace    Both are registers: tell_o is up limit_i + 1 cycles after the cycle of the last movement, then every limit_i.
// Model   cpp_model/control/control_watch.hpp

module pipegs_control_watch (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  logic [31:0] limit_i,
  input  logic        waits_i,
  input  logic        moves_i,
  output logic        tell_o,
  output logic        silent_o
);

  logic [31:0] left_q;  // cycles of silence until it is told; 0: none were counted
  logic        tell_q, silent_q, still, due;

  assign still = waits_i && !moves_i && limit_i != '0;
  assign due   = still && left_q == 32'd1;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      left_q   <= '0;
      tell_q   <= 1'b0;
      silent_q <= 1'b0;
    end else begin
      left_q   <= still && left_q > 32'd1 ? left_q - 32'd1 : limit_i;
      tell_q   <= due;
      silent_q <= still && (silent_q || due);
    end
  end

  assign tell_o   = tell_q;
  assign silent_o = silent_q;

endmodule
