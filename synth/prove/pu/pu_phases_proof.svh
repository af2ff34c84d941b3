// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/pu_phases.sv in its proof: one record in, its phases, one record out, none lost.
//
// Idea    Records inside are counted at the ports. One that is no longer held is where its last phase is in the levels.
// Rule    A record leaves for each that came; a record shown stays; the output register is claimed only when free, once
//         for each record, and no finished record is overwritten; every level handles a record's phases in order.
// Invariant  Beside a level are a record's next phase before and its last one behind it, so records are at least Phases
//         levels apart; past the claim there is one at most, and none while one is shown.

localparam int unsigned CountW = 4;
logic [CountW-1:0] held_q;     // records that came and did not leave
logic [CountW-1:0] claimed_q;  // of these, those that have claimed the output register

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold u_hold (.clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i(1'b0));
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    held_q    <= '0;
    claimed_q <= '0;
  end else begin
    held_q    <= held_q + CountW'(take_o) - CountW'(out_valid_o && out_ready_i);
    claimed_q <= claimed_q + CountW'(claim_o) - CountW'(out_valid_o && out_ready_i);
  end
end

logic [Depth:0] level_valid, behind, past;  // behind: a record that is not held any more; past: its claim is over
logic [PhaseW-1:0] level_phase [Depth + 1];
logic [CountW-1:0] records, claimed;
assign level_valid[0] = valid_q;
assign level_phase[0] = phase_q;
assign behind[0]      = 1'b0;
assign past[0]        = valid_q && {1'b0, phase_q} > SlotW'(Claim) && Claim < Phases;
for (genvar i = 1; i <= Depth; i += 1) begin : gen_level
  assign level_valid[i] = levels_q[(i-1)*SlotW+PhaseW];
  assign level_phase[i] = levels_q[(i-1)*SlotW +: PhaseW];
  assign behind[i]      = level_valid[i] && level_phase[i] == LastPhase;
  assign past[i]        = behind[i] && i + Phases > Claim + 1;
  always_comb begin
    if (rst_ni) begin
      if (level_valid[i] && level_phase[i] != LastPhase)
        assert (level_valid[i-1] && level_phase[i-1] == level_phase[i] + 1'b1);
      if (level_valid[i-1] && level_phase[i-1] != '0)
        assert (level_valid[i] && level_phase[i] == level_phase[i-1] - 1'b1);
      assert (level_phase[i] <= LastPhase);
    end
  end
end
always_comb begin
  records = CountW'(valid_q) + CountW'(out_valid_q);
  claimed = CountW'(out_valid_q);
  for (int unsigned i = 0; i <= Depth; i += 1) records += CountW'(behind[i]);
  for (int unsigned i = 0; i <= Depth; i += 1) claimed += CountW'(past[i]);
end

always_comb begin
  if (rst_ni) begin
    assert (held_q <= CountW'(2 + Claim / Phases) && claimed_q <= CountW'(1));
    assert (!claim_o || claimed_q == '0 || (out_valid_o && out_ready_i));
    assert (!(finish && step_o && out_valid_q && !out_ready_i));
    assert (busy_o == (held_q != '0));
    // invariants
    assert (phase_q <= LastPhase && (valid_q || phase_q == '0));
    assert (phase_o == Phases'(1) << phase_q);
    assert (claimed_q == claimed);
    assert (held_q == records);
  end
end
