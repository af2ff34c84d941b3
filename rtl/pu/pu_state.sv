// SPDX-License-Identifier: Apache-2.0
// pu_state: what a Preprocessing Unit does in this cycle, in one of four words.
//
// Paper   Fig. 8 (bubbles); the counters behind it are rtl/pipegs_perf.sv.
// Idea    The Row Units are the PU's largest part: while they compute it is busy. Otherwise a full buffer or a stalled
//         output explains the cycle, then work inside the front end, then external memory; else there is nothing to do.
// Stream  conditions in, state_o out, a pipegs_pkg::Perf* word.
// Pace    Combinational.
// Model   None: the four states cover every cycle by construction.

module pu_state (
  input  logic       rows_i,     // a region is being computed
  input  logic       front_i,    // a Gaussian is between cull and intersect
  input  logic       color_i,    // a colour is being computed or fetched
  input  logic       memory_i,   // geometry, SH or the write of a line waits for external memory
  input  logic       blocked_i,  // the alpha store or the SU has no room
  output logic [1:0] state_o
);

  always_comb begin
    if (rows_i) state_o = pipegs_pkg::PerfBusy;
    else if (blocked_i) state_o = pipegs_pkg::PerfBlocked;
    else if (front_i) state_o = pipegs_pkg::PerfBusy;
    else if (memory_i || color_i) state_o = pipegs_pkg::PerfMemory;
    else state_o = pipegs_pkg::PerfStarved;
  end

endmodule
