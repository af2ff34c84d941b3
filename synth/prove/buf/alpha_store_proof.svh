// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_alpha_store.sv in its proof: every reader is taken, and answered two cycles later.
//
// Idea    The reader is any reader. That the answer is the line is the rule of alpha_slots_proof.svh.
// Rule    At most one reader is taken, always one if any asks; the answer goes to the reader taken two cycles before,
//         unless it skipped its line, and to no other; a slot is free in the cycle behind each of both. No reader that
//         asks waits more than Units - 1 cycles.
// Invariant  The cycles that the reader waits are the grants that pass it, which arbiter_proof.svh bounds.

(* hierconn *) logic [PortW-1:0] \u_arbiter.who ;
(* hierconn *) logic [$clog2(2*Units+1)-1:0] \u_arbiter.waits_q ;

(* anyconst *) logic [PortW-1:0] reader;
logic [$clog2(2*Units+1)-1:0] cycles_q;  // the reader waits
logic [Units-1:0]             taken_q, taken_2_q;
logic                         took_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    {taken_q, taken_2_q} <= '0;
    took_q   <= 1'b0;
    cycles_q <= '0;
  end else begin
    taken_q   <= read_valid_i & read_ready_o & ~read_skip_i;
    taken_2_q <= taken_q;
    took_q    <= (read_valid_i & read_ready_o) != '0;
    cycles_q  <= read_valid_i[reader] && !read_ready_o[reader] ? cycles_q + 1'b1 : '0;
  end
end

always_comb begin
  assume ((PortW+1)'(reader) < (PortW+1)'(Units) && reader == \u_arbiter.who );
  if (rst_ni) begin
    assert ((read_ready_o & (read_ready_o - 1'b1)) == '0);
    assert ((read_ready_o & ~read_valid_i) == '0);
    assert (read_valid_i == '0 || read_ready_o != '0);
    assert (32'(cycles_q) < Units);
    assert (cycles_q == \u_arbiter.waits_q );
    assert (answer_valid_o == taken_2_q);
    assert (free_o == took_q);
    assert (active_o || (!write_i && read_valid_i == '0 && answer_valid_o == '0 && !free_o));
    assert (asked_q == taken_q);  // invariant
  end
end
