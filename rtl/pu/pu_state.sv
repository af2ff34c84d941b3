// pu_state: what a Preprocessing Unit does in this cycle, in one of four words.
//
// Paper   Fig. 8 (bubbles); the counters behind it are rtl/perf.sv.
// Idea    The Row Units are the PU's largest part: while they compute it is busy. Otherwise a full buffer or a stalled
//         output explains the cycle, then work inside the front end, then external memory; else there is nothing to do.
// Stream  conditions in, state_o out: 0 busy, 1 starved, 2 blocked, 3 memory.
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
    if (rows_i) state_o = 2'd0;
    else if (blocked_i) state_o = 2'd2;
    else if (front_i) state_o = 2'd0;
    else if (memory_i || color_i) state_o = 2'd3;
    else state_o = 2'd1;
  end

endmodule
