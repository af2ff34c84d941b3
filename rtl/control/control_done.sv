// SPDX-License-Identifier: Apache-2.0
// control_done: a frame is done when its last pixel is in memory, not when the memory side has accepted it.
//
// Idea    Answers to writes come in their order. So when the core has given the last pixel away, the writes that are
//         unanswered then must be answered, and no others. A frame that ends while one before it waits makes both wait
//         for its own writes: then both are told one after the other.
// Stream  core_done_i: pulse, behind the last write. done_o: pulse for each frame. give_up_i: none of those that wait is
//         told any more; it wins.
// Pace    One cycle more than the last answer takes.
// Model   cpp_model/control/control_done.hpp

module control_done #(
  localparam int unsigned Writes  = pipegs_pkg::BusWrites,
  localparam int unsigned WritesW = $clog2(Writes + 1)
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               core_done_i,
  input  logic               give_up_i,
  input  logic [WritesW-1:0] writes_i,     // accepted and not answered
  input  logic               answered_i,   // pulse: one of them is
  output logic               done_o,
  output logic               waiting_o     // a frame that has left the core waits
);

  logic [WritesW-1:0] left_q;     // that the youngest of them waits for
  logic [WritesW:0]   frames_q;   // that wait: each has written a line at least

  assign done_o    = frames_q != '0 && left_q == '0 && !give_up_i;
  assign waiting_o = frames_q != '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      left_q   <= '0;
      frames_q <= '0;
    end else if (give_up_i) begin
      left_q   <= '0;
      frames_q <= '0;
    end else begin
      frames_q <= frames_q + (WritesW+1)'(core_done_i) - (WritesW+1)'(done_o);
      if (core_done_i) left_q <= writes_i - WritesW'(answered_i);
      else if (answered_i && left_q != '0) left_q <= left_q - 1'b1;
    end
  end

endmodule
