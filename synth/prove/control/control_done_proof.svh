// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_done.sv in its proof: each frame is told once, behind the answers to its
// writes.
//
// Rule    A frame of the solver's choice is not told before all writes that were unanswered at its end are answered.
//         The frames told and those that wait are those that ended since the last give-up: none is lost, none is told
//         twice. When no write is unanswered, one that waits is told in this cycle; given up, none is.
// Assumes writes_i counts what was accepted and not answered; only that is answered; fewer frames wait than the counter
//         holds.
// Invariant  The frame that was chosen stands in one of the two groups, which waits for its writes at least.

(* anyseq *) logic accepts, pick;
logic [FramesW:0]   waiting_q;         // frames
logic [WritesW-1:0] open_q;            // writes
logic               picked_q, tells, takes;
logic [FramesW:0]   place_q;           // frames that wait up to the chosen one, itself too
logic [WritesW-1:0] need_q;            // writes that it waits for

assign tells = picked_q && done_o && place_q == (FramesW+1)'(1);
assign takes = pick && core_done_i && (!picked_q || tells);
proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    waiting_q <= '0;
    open_q    <= '0;
    picked_q  <= 1'b0;
    place_q   <= '0;
    need_q    <= '0;
  end else begin
    open_q    <= open_q + WritesW'(accepts) - WritesW'(answered_i);
    waiting_q <= give_up_i ? '0 : waiting_q + (FramesW+1)'(core_done_i) - (FramesW+1)'(done_o);
    picked_q  <= !give_up_i && (takes || (picked_q && !tells));
    if (takes) begin
      place_q <= waiting_q + (FramesW+1)'(1) - (FramesW+1)'(done_o);
      need_q  <= open_q - WritesW'(answered_i);
    end else begin
      place_q <= place_q - (FramesW+1)'(done_o);
      if (answered_i && need_q != '0) need_q <= need_q - 1'b1;
    end
  end
end

always_comb begin
  assume (writes_i == open_q);
  assume (!accepts || open_q != WritesW'(Writes));
  assume (!answered_i || open_q != '0);
  assume (!core_done_i || later_q != '1);
  if (rst_ni) begin
    assert (!tells || need_q == '0);
    assert (!done_o || (waiting_q != '0 && !give_up_i));
    assert (waiting_o == (waiting_q != '0));
    assert (!(waiting_o && open_q == '0 && !give_up_i) || done_o);
    // invariants
    assert (waiting_q == (FramesW+1)'(frames_q) + (FramesW+1)'(later_q));
    assert (frames_q != '0 || later_q == '0);
    assert (open_q <= WritesW'(Writes));
    assert (frames_q == '0 || left_q <= open_q);
    assert (later_q == '0 || later_left_q <= open_q);
    if (picked_q) begin
      assert (place_q != '0 && place_q <= waiting_q);
      assert (need_q <= (place_q <= (FramesW+1)'(frames_q) ? left_q : later_left_q));
    end
  end
end
