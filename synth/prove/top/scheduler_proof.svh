// SPDX-License-Identifier: Apache-2.0
// The end of rtl/scheduler.sv in its proof: a frame ends when every RU has completed all its windows, and not before.
//
// Idea    Windows completed are counted beside the module, for each RU.
// Rule    No count of windows left goes below zero or above the frame's windows; the restart is one cycle long, the
//         first one of a frame; busy falls only when all is complete, written and idle.
// Assumes Of the RUs: none completes more windows than the frame has, and none between frames.
// Not said  Cycles and overflowed lines are counted in PerfW bits: 40 last for 18 minutes at 1 GHz.

(* anyconst *) logic [$clog2(Units + 1)-1:0] unit;  // any RU
logic [CountW-1:0] total_q, completed_q;            // windows of the frame; of these, completed by this RU
logic              was_busy_q, could_end_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    total_q     <= '0;
    completed_q <= '0;
    was_busy_q  <= 1'b0;
    could_end_q <= 1'b1;
  end else begin
    was_busy_q  <= busy_q;
    could_end_q <= idle_i && (complete == '1) && !restart_q;
    if (start_i && !busy_q) begin
      total_q     <= (CountW'(windows_i.last_x) + 1 - CountW'(windows_i.first_x)) *
                     (CountW'(windows_i.last_y) + 1 - CountW'(windows_i.first_y));
      completed_q <= '0;
    end else begin
      completed_q <= completed_q + CountW'(window_done_i[unit]);
    end
  end
end

always_comb begin
  assume (32'(unit) < Units);
  assume (windows_i.first_x <= windows_i.last_x && windows_i.first_y <= windows_i.last_y);
  assume (!window_done_i[unit] || (busy_o && !restart_o && completed_q < total_q));
  if (rst_ni) begin
    assert (completed_q <= total_q && total_q <= CountW'(1) << (2 * WindowW));
    assert (left_q[unit] == total_q - completed_q);
    assert (restart_o == (busy_o && !was_busy_q));
    assert (!was_busy_q || busy_o || (could_end_q && completed_q == total_q));
    assert (busy_o || left_q[unit] == '0);
  end
end
