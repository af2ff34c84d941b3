// SPDX-License-Identifier: Apache-2.0
// pipegs_control_done: a frame is done when its last pixel is in memory, not when the memory side has accepted it.
//
// Idea    Answers to writes come in their order. So when the core has given the last pixel away, the writes that are
//         unanswered then must be answered, and no others. There are two counts of them: one for the oldest frames
//         that wait, which does not change with what ends later, and one for all behind them, which wait for the
//         writes of the youngest. So a frame is reported however fast others follow.
// Stream  core_done_i: pulse, behind the last write. done_o: pulse for each frame. give_up_i: none of those that wait
//         is reported any more; it wins.
// Pace    One cycle more than the last answer takes, for a frame that waits alone or behind one other.
// Model   cpp_model/control/control_done.hpp

module pipegs_control_done #(
  localparam int unsigned Writes  = pipegs_pkg::BusWrites,
  localparam int unsigned WritesW = $clog2(Writes + 1),
  localparam int unsigned FramesW = WritesW + 1
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

  logic [FramesW-1:0] frames_q, later_q, later;            // that wait: the oldest ones, those behind them
  logic [WritesW-1:0] left_q, later_left_q, later_left;    // writes that the youngest of them waits for
  logic               free;                                // none of the oldest ones is left

  assign done_o    = frames_q != '0 && left_q == '0 && !give_up_i;
  assign waiting_o = frames_q != '0;
  assign free      = frames_q == '0 || (done_o && frames_q == FramesW'(1));
  assign later     = later_q + FramesW'(core_done_i);
  always_comb begin
    later_left = later_left_q;
    if (core_done_i) later_left = writes_i - WritesW'(answered_i);
    else if (answered_i && later_left_q != '0) later_left = later_left_q - 1'b1;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {frames_q, left_q, later_q, later_left_q} <= '0;
    end else if (give_up_i) begin
      {frames_q, left_q, later_q, later_left_q} <= '0;
    end else begin
      later_left_q <= later_left;
      if (free) begin
        frames_q <= later;
        left_q   <= later_left;
        later_q  <= '0;
      end else begin
        frames_q <= frames_q - FramesW'(done_o);
        later_q  <= later;
        if (answered_i && left_q != '0) left_q <= left_q - 1'b1;
      end
    end
  end

`ifndef SYNTHESIS
  // Each that waits for an answer has written a line, and no frame ends in the cycle behind another one: so there are
  // at most 2 Writes of them.
  always_ff @(posedge clk_i) if (rst_ni) begin
    assert (!core_done_i || later_q != '1) else $error("pipegs_control_done: too many frames wait");
  end
`endif

endmodule
