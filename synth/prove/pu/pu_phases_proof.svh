// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/pu_phases.sv in its proof: one record in, eight phases, one record out, none lost.
//
// Idea    Records inside are counted at the ports; two places, so never more than two.
// Rule    A record leaves for each that came; a record shown stays; the output register is claimed only when free, once
//         for each record, and no finished record is overwritten; every level handles a record's phases in order.
// Invariant  A level in use holds the phase issued as many steps ago; past the claim the records in the levels are one
//         at most.

logic [1:0] held_q;     // records that came and did not leave
logic [1:0] claimed_q;  // of these, those that have claimed the output register

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold u_hold (.clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i(1'b0));
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    held_q    <= '0;
    claimed_q <= '0;
  end else begin
    held_q    <= held_q + 2'(take_o) - 2'(out_valid_o && out_ready_i);
    claimed_q <= claimed_q + 2'(claim_o) - 2'(out_valid_o && out_ready_i);
  end
end

// The phases of the record before, still in the levels.
logic [Depth:1] tail, level_valid;
logic [PhaseW-1:0] level_phase [Depth + 1];
logic any_tail;
assign any_tail = tail != '0;
assign level_phase[0] = phase_q;
for (genvar i = 1; i <= Depth; i += 1) begin : gen_level
  assign level_valid[i] = levels_q[(i-1)*SlotW+PhaseW];
  assign level_phase[i] = levels_q[(i-1)*SlotW +: PhaseW];
  assign tail[i] = level_valid[i] && !(valid_q && phase_q >= PhaseW'(i));
  if (i > 1) begin : gen_before
    always_comb if (rst_ni && tail[i]) assert (level_phase[i] == LastPhase || tail[i-1]);
  end else begin : gen_first
    always_comb if (rst_ni && tail[i]) assert (level_phase[i] == LastPhase);
  end
  if (i < Depth) begin : gen_next
    always_comb if (rst_ni && tail[i]) assert (tail[i+1] && level_phase[i+1] == level_phase[i] - 1'b1);
  end
  always_comb begin
    if (rst_ni) begin
      if (valid_q && phase_q >= PhaseW'(i)) assert (level_valid[i] && level_phase[i] == phase_q - PhaseW'(i));
      if (tail[i]) assert ({1'b0, level_phase[i]} >= SlotW'(8 - i) + {1'b0, phase_q});
    end
  end
end

always_comb begin
  if (rst_ni) begin
    assert (held_q <= 2'd2 && claimed_q <= 2'd1);
    assert (!out_valid_o || held_q != '0);
    assert (!claim_o || claimed_q == '0 || (out_valid_o && out_ready_i));
    assert (!(finish && out_valid_q));
    assert (busy_o == (held_q != '0));
    // invariants
    assert (valid_q || phase_q == '0);
    assert (phase_o == 8'b1 << phase_q);
    assert (!out_valid_q || !(any_tail || (valid_q && phase_q > PhaseW'(Claim))));
    assert (claimed_q == 2'(out_valid_q || any_tail || (valid_q && phase_q > PhaseW'(Claim))));
    assert (held_q == 2'(valid_q) + 2'(out_valid_q || any_tail));
  end
end
