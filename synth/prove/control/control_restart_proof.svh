// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_restart.sv in its proof: what a reset of the core alone promises.
//
// Rule    A give-up while the core is not kept apart puts it apart in the next cycle, and nothing else does. It is in
//         reset only while it is apart, from the cycle before on, for Cycles at least; as many pass behind the reset
//         before it is not apart any more. The epoch turns only in the cycle behind one in which drained_i was up,
//         while the core is in reset, before it and after. A core that is not apart has had its turn since it was given
//         up. Only drained_i is waited for: no other state lasts beyond its count. In the scan test the reset is
//         rst_ni.

logic           past_q, apart_was_q, low_was_q, gave_up_q, drained_q, stopped_q, epoch_was_q, turn, done_q;
logic [LeftW:0] low_q, high_q;  // cycles in a row until now in reset, and out of it, as far as they count

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign turn = past_q && epoch_o != epoch_was_q;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    past_q <= 1'b0;
    done_q <= 1'b1;
    low_q  <= '0;
    high_q <= '0;
  end else begin
    past_q <= 1'b1;
    done_q <= apart_o ? done_q || turn : !give_up_i;
    low_q  <= core_rst_nq ? '0 : low_q + (LeftW+1)'(low_q != '1);
    high_q <= core_rst_nq ? high_q + (LeftW+1)'(high_q != '1) : '0;
  end
end
always_ff @(posedge clk_i) begin
  apart_was_q <= apart_o;
  low_was_q   <= !core_rst_nq;
  gave_up_q   <= give_up_i;
  drained_q   <= drained_i;
  stopped_q   <= state_q == StateStop;
  epoch_was_q <= epoch_o;
end

always_comb begin
  assert (!(core_rst_no && !rst_ni));
  assert (!test_mode_i || core_rst_no == rst_ni);
  assert (test_mode_i || core_rst_no == core_rst_nq);
  assert (!ready_o || (!apart_o && !give_up_i));
  if (rst_ni) begin
    assert (apart_o || (core_rst_nq && done_q));
    if (past_q) begin
      assert (apart_was_q || apart_o == gave_up_q);
      assert (core_rst_nq || low_was_q || apart_was_q);
      assert (!(core_rst_nq && low_was_q) || low_q >= (LeftW+1)'(Cycles));
      assert (apart_o || !apart_was_q || high_q >= (LeftW+1)'(Cycles));
      assert (!turn || (drained_q && low_was_q && !core_rst_nq));
      assert (!(stopped_q && drained_q) || turn);
    end else begin
      assert (!core_rst_nq && apart_o && !epoch_o);
    end
    // invariants
    assert (apart_q == (state_q != StateRun) && core_rst_nq == (state_q != StateStop && state_q != StateTurned));
    assert (done_q || turn == (state_q == StateTurned));
    assert (state_q != StateTurned || done_q || turn);
    assert (state_q != StateFree || done_q);
    assert (!(done_q || turn) || (state_q != StateApart && state_q != StateStop));
    assert (left_q <= LeftW'(Cycles - 1));
    assert (state_q != StateTurned || (LeftW+2)'(low_q) + (LeftW+2)'(left_q) >= (LeftW+2)'(Cycles - 1));
    assert (state_q != StateFree || (LeftW+2)'(high_q) + (LeftW+2)'(left_q) >= (LeftW+2)'(Cycles - 1));
    assert (state_q <= StateFree);
  end
end
