// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/pu_turns.sv in its proof: one record in, one turn, one record out, none lost.
//
// Idea    Records that moved inside are counted at the ports; two places, so never more than two.
// Rule    A record is taken only in a turn that it saw begin; a Gaussian leaves only after all eight phases of its turn
//         and up to Out of the next; a record that is shown stays, and none is written over it.
// Assumes The source keeps what it shows.
// Invariant  Behind phase Out a turn goes on with a Gaussian inside, and with nothing else.

logic [1:0] held_q;   // moved inside, did not leave the stage
logic       since_q;  // the record at the input was there in phase 0
logic       data_q;   // the record inside is a Gaussian
logic       whole_q;  // and has had all phases of its turn

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.Assumed(1'b1)) u_hold_in (
  .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_o), .beat_i(in_data_i)
);
proof_hold u_hold_out (.clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i(1'b0));
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    held_q  <= '0;
    since_q <= 1'b0;
    data_q  <= 1'b0;
    whole_q <= 1'b0;
  end else begin
    held_q <= held_q + 2'(in_valid_i && in_ready_o) - 2'(out_valid_o && out_ready_i);
    if (phase_o[0]) since_q <= in_valid_i;
    if (move_o) data_q <= in_valid_i && in_ready_o && in_data_i;
    if (move_o) whole_q <= 1'b0;
    else if (phase_o[7]) whole_q <= 1'b1;
  end
end

always_comb begin
  if (rst_ni) begin
    assert (!in_ready_o || (in_valid_i && since_q));
    assert (!leave_o || !out_valid_o || out_ready_i);
    assert (!(leave_o && data_q) || whole_q);
    assert (busy_o || held_q == '0);
    // invariants
    assert (held_q == 2'(inside_q) + 2'(out_valid_q));
    assert (phase_q != '0 && (phase_q & (phase_q - 8'b1)) == '0);
    assert (phase_q[Out:1] == '0 || since_q == fresh_q);
    assert (phase_q[Out:1] == '0 || !fresh_q || in_valid_i);
    assert (phase_q[7:Out+1] == '0 || (inside_q && data_q && !whole_q));
    assert (!(inside_q && data_q && phase_q[Out:0] != '0) || whole_q);
    assert (inside_q || !data_q);
  end
end
