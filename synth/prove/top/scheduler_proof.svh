// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pipegs_scheduler.sv in its proof: no frame is lost, none begins in the back before the one before it
// has ended, and it ends when every RU has completed all its windows, and not before.
//
// Idea    Windows that went into the back and windows completed are counted beside the module, the latter for any RU.
// Rule    No count of windows left goes below zero or above the frame's windows; no splat goes into the back unless it
//         has a frame with windows to come; the back's frame ends only when all is complete, idle and stored; the front
//         takes a frame only when its own has gone to the back, and the RUs are heard only then.
// Assumes Of the machine: nothing goes into the back while it is held. Of the RUs: none completes a window whose end
//         has not gone in, and none in the cycle of its restart.
// Not said  Cycles and overflowed lines are counted in PerfW bits: 40 last for 18 minutes at 1 GHz.

(* anyconst *) logic [$clog2(Units + 1)-1:0] unit;         // any RU
logic [CountW-1:0] total_q, entered_q, completed_q;        // windows of the frame; of these, gone in; completed
logic              was_back_q, could_end_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    total_q     <= '0;
    entered_q   <= '0;
    completed_q <= '0;
    was_back_q  <= 1'b0;
    could_end_q <= 1'b1;
  end else begin
    was_back_q  <= back_q;
    could_end_q <= complete == '1 && !back_busy_i && !storing_i && !back_restart_q;
    if (back_take_o) begin
      total_q     <= (CountW'(windows_i.last_x) + 1 - CountW'(windows_i.first_x)) *
                     (CountW'(windows_i.last_y) + 1 - CountW'(windows_i.first_y));
      entered_q   <= '0;
      completed_q <= '0;
    end else begin
      entered_q   <= entered_q + CountW'(end_i);
      completed_q <= completed_q + CountW'(window_done_i[unit]);
    end
  end
end

always_comb begin
  assume (32'(unit) < Units);
  assume (windows_i.first_x <= windows_i.last_x && windows_i.first_y <= windows_i.last_y);
  assume (!end_i || !hold_o);
  assume (!window_done_i[unit] || (!back_restart_o && completed_q < entered_q));
  if (rst_ni) begin
    assert (completed_q <= entered_q && entered_q <= total_q && total_q <= CountW'(1) << (2 * WindowW));
    assert (left_q[unit] == total_q - completed_q && enter_q == total_q - entered_q);
    assert (back_q || (hold_o && left_q[unit] == '0));
    assert (!was_back_q || back_q || could_end_q);
    assert (!front_restart_o || (front_q && ahead_q));
    assert (!back_restart_o || (back_q && !was_back_q));
    assert (!front_take_o || (!front_q && !ahead_q));
    assert (Overlaps || !front_take_o || !back_q);
    assert (!listen_o || (!ahead_q && !back_restart_o));
  end
end
