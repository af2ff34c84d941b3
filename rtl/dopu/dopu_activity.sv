// SPDX-License-Identifier: Apache-2.0
// dopu_activity: until when the DOPU is busy, when it needs a clock, and what it does in each cycle.
//
// Idea    The frame is done when the end of its last window has been taken by every PU. Nothing inside lasts 127 cycles
//         without a move, so after as many without one the unit waits for its surroundings, and needs a clock only when
//         these move (pipegs_sleep).
// Stream  Pulses of the unit in; busy_o, active_o, perf_o.
// Pace    Combinational, but for busy_o.
// Model   None: the streams are the same with and without it.

module dopu_activity #(
  localparam int unsigned Units = pipegs_pkg::Units
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             start_i,

  input  logic             moved_i,       // inside
  input  logic             memory_i,      // a line was asked for, or came
  input  logic             news_i,        // the RUs' feedback changes something, or planes are made again for it
  input  logic             waits_i,       // for memory
  input  logic             origin_i,      // something is in dopu_origin, where it takes its cycles in any case
  input  logic             chunk_valid_i,  // before dopu_emit
  input  logic             last_end_i,    // the end of the last window is taken there
  input  logic [Units-1:0] out_valid_i,   // behind it
  input  logic [Units-1:0] out_ready_i,
  input  logic [Units-1:0] out_room_i,    // for a chunk that is not behind it yet

  output logic             busy_o,        // until the last end is taken
  output logic             active_o,      // needs a clock in this cycle
  output logic [1:0]       perf_o
);

  logic busy_q, last_q;  // last_q: the last end stands at the output
  logic blocked, woken, asleep;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      last_q <= 1'b0;
    end else if (start_i) begin
      busy_q <= 1'b1;
      last_q <= 1'b0;
    end else begin
      if (last_end_i) last_q <= 1'b1;
      if (last_q && (out_valid_i & ~out_ready_i) == '0) busy_q <= 1'b0;
    end
  end

  assign blocked = chunk_valid_i || out_valid_i != '0;
  assign woken   = start_i || memory_i || news_i ||
                   (out_valid_i != '0 ? out_ready_i != '0 : chunk_valid_i && out_room_i != '0);
  pipegs_sleep #(.Patience(127)) u_sleep (
    .clk_i,
    .rst_ni,
    .moved_i,
    .wake_i(woken),
    .asleep_o(asleep)
  );

  assign busy_o   = busy_q;
  assign active_o = start_i || news_i || (busy_q && (moved_i || !asleep));
  assign perf_o   = moved_i ? pipegs_pkg::PerfBusy : waits_i ? pipegs_pkg::PerfMemory :
                    blocked ? pipegs_pkg::PerfBlocked : origin_i ? pipegs_pkg::PerfBusy : pipegs_pkg::PerfStarved;

endmodule
