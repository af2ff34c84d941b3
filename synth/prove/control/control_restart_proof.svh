// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_restart.sv in its proof: what a reset of the core alone promises.
//
// Rule    A give-up while the core runs resets it in the next cycle. The reset ends only behind a turn of the epoch, or
//         behind a reset of the machine. The epoch turns only in the cycle behind one in which drained_i was up, and
//         while the core is in reset, before it and after. A frame may be taken only by a core that runs and is not
//         given up. Only drained_i is waited for: when it was up, the epoch has turned, and then the core runs.

logic past_q, ran_q, gave_up_q, drained_q, epoch_was_q, turned_q, turn, done_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign turn = past_q && epoch_o != epoch_was_q;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    past_q <= 1'b0;
    done_q <= 1'b1;
  end else begin
    past_q <= 1'b1;
    done_q <= core_rst_no ? !give_up_i : done_q || turn;  // nothing is left to be given up
  end
end
always_ff @(posedge clk_i) begin
  ran_q       <= core_rst_no;
  gave_up_q   <= give_up_i;
  drained_q   <= drained_i;
  epoch_was_q <= epoch_o;
  turned_q    <= turn;
end

always_comb begin
  assert (!(core_rst_no && !rst_ni));
  assert (!ready_o || (core_rst_no && !give_up_i));
  if (rst_ni) begin
    if (past_q) begin
      assert (!(ran_q && gave_up_q) || !core_rst_no);
      assert (!(ran_q && !gave_up_q) || core_rst_no);
      assert (!turn || (drained_q && !ran_q && !core_rst_no));
      assert (!core_rst_no || done_q);
      assert (!(drained_q && !ran_q && !done_q) || turn);
      assert (!turned_q || core_rst_no);
    end else begin
      assert (!core_rst_no && !epoch_o);
    end
    // invariants
    assert (core_rst_no == (state_q == StateRun));
    assert (done_q || turn == (state_q == StateTurned));
    assert (state_q == StateRun || state_q == StateStop || state_q == StateTurned);
  end
end
