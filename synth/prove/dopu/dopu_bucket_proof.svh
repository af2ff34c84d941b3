// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/nearest/dopu_bucket.sv in its proof: a place holds one node at a time, and no count of places
// overflows.
//
// Idea    Any one place, of the solver's choice, is followed: never used, taken, or waiting in the pool's queue.
// Rule    A place that is taken is not given to another node; places used are taken or in the queue.
// Assumes A pop is of a list that holds a node, and what its chain names is a place that is taken (the module's own
//         promise: chains are compared with the model beat by beat).

(* hierconn *) logic [NodeW-1:0] \u_places.u_back.value ;
(* hierconn *) logic [$clog2(Nodes+1)-1:0] \u_places.u_back.held_q ;
(* hierconn *) logic [$clog2(Nodes+1)-1:0] \u_places.u_back.watched_q ;
(* hierconn *) logic [NodeW:0] \u_places.fresh_q ;
logic in_use_q, gives, returns, seen;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign gives   = take_insert && free_place == \u_places.u_back.value ;
assign returns = out_valid_o && place_q == \u_places.u_back.value ;
assign seen    = (NodeW+1)'(\u_places.u_back.value ) < \u_places.fresh_q ;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) in_use_q <= 1'b0;
  else in_use_q <= gives || (in_use_q && !returns);
end

always_comb begin
  assume (!out_valid_o || returns || taken > (NodeW+1)'(in_use_q));
  assume (!returns || (in_use_q && taken != '0));
  if (rst_ni) begin
    assert (!gives || !in_use_q);
    assert (!take_insert || place_valid);
    assert (\u_places.fresh_q <= (NodeW+1)'(Nodes) && taken <= (NodeW+1)'(Nodes));
    // invariants
    assert ((NodeW+2)'(taken) + (NodeW+2)'(\u_places.u_back.held_q ) == (NodeW+2)'(\u_places.fresh_q ));
    assert (\u_places.u_back.watched_q == ((seen && !in_use_q) ? ($clog2(Nodes+1))'(1) : '0));
    assert (!in_use_q || (seen && taken != '0));
  end
end
