// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_slot_pool.sv in its proof: a slot is handed out again only after it came back.
//
// Idea    Any one slot, of the solver's choice, is followed: never used, in use, or waiting in the queue.
// Rule    A slot in use is not handed out; used_o tells the number of slots in use; the queue takes every slot back;
//         the slot shown stays until taken.
// Assumes Only a slot in use comes back. renew_i: none is in use and none taken, until the queue is empty.
// Invariant  Slots used once are in use or in the queue, each in one of the two places; but while they are renewed.

(* hierconn *) logic [SlotW-1:0] \u_back.value ;
(* hierconn *) logic [$clog2(Slots+1)-1:0] \u_back.held_q ;
(* hierconn *) logic [$clog2(Slots+1)-1:0] \u_back.watched_q ;
logic in_use_q, gives, returns, seen, renew_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(SlotW)) u_hold (
  .clk_i, .rst_ni(rst_ni && !renew_i), .valid_i(slot_valid_o), .ready_i(slot_ready_i), .beat_i(slot_o)
);

assign gives   = take && slot_o == \u_back.value ;
assign returns = free_i && free_slot_i == \u_back.value ;
assign seen    = (SlotW+1)'(\u_back.value ) < fresh_q;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) renew_q <= 1'b0;
  else renew_q <= renew_i;
end
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) in_use_q <= 1'b0;
  else in_use_q <= gives || (in_use_q && !returns);
end

always_comb begin
  assume (!free_i || returns || used_q > (SlotW+1)'(in_use_q));
  assume (!returns || in_use_q);
  assume (!renew_i || (used_q == '0 && !slot_ready_i && !free_i));
  assume (!renew_q || renew_i || \u_back.held_q == '0);
  if (rst_ni) begin
    assert (!gives || !in_use_q);
    assert (!free_i || unused_ready);
    assert (fresh_q <= (SlotW+1)'(Slots) && used_q <= (SlotW+1)'(Slots) && used_o == used_q);
    // invariants
    assert (!renew_q || (fresh_q == '0 && used_q == '0));
    assert (renew_q || (SlotW+2)'(used_q) + (SlotW+2)'(\u_back.held_q ) == (SlotW+2)'(fresh_q));
    assert (renew_q || \u_back.watched_q == ((seen && !in_use_q) ? ($clog2(Slots+1))'(1) : '0));
    assert (!in_use_q || (seen && used_q != '0));
  end
end
