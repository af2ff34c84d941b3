// SPDX-License-Identifier: Apache-2.0
// pipegs_perf: how one unit spent its cycles: busy, starved, blocked, waiting for memory.
//
// Idea    A unit says in every cycle which of four things it does; one of four counters goes up. While the frame runs
//         exactly one does, so the four sum to the frame's cycles.
// Stream  state_i: 0 busy, 1 starved, 2 blocked, 3 memory. counts_o: the four counters, busy lowest.
// Pace    One count per cycle, one cycle later: a state is known late in its cycle. Cleared by restart_i. Runs on the
//         free clock: a gated unit's state holds.
// Model   None: the harness checks the sum.

module pipegs_perf (
  input  logic clk_i,
  input  logic rst_ni,

  input  logic       restart_i,
  input  logic       running_i,
  input  logic [1:0] state_i,
  output logic [4*pipegs_pkg::PerfW-1:0] counts_o
);

  logic [pipegs_pkg::PerfW-1:0] counts_q [4];
  logic       restart_q, running_q;
  logic [1:0] state_q;

  assign counts_o = {counts_q[3], counts_q[2], counts_q[1], counts_q[0]};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) {restart_q, running_q} <= '0;
    else {restart_q, running_q} <= {restart_i, running_i};
  end
  always_ff @(posedge clk_i) state_q <= state_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      for (int unsigned i = 0; i < 4; i += 1) counts_q[i] <= '0;
    end else if (restart_q) begin
      for (int unsigned i = 0; i < 4; i += 1) counts_q[i] <= '0;
    end else if (running_q) begin
      counts_q[state_q] <= counts_q[state_q] + 1'b1;
    end
  end

endmodule
