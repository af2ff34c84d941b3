// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/pu_payload.sv in its proof: a Gaussian that leaves shows the payload with which it began to walk.
//
// Idea    One Gaussian of the solver's choice is followed from walk_i to leave_i, with the number of those ahead of
//         it; of its payload one bit is remembered. Once it has left, that bit shows until the next one leaves.
// Rule    payload_o is the payload of the Gaussian that left last.
// Assumes Of pu_intersect: no more than Places Gaussians walk, and none leaves that did not begin (the assertions of
//         the module).
// Invariant  The word lies as far behind the tail as Gaussians came after it, itself included: never more than the
//         ring.

localparam int unsigned HeldW = PtrW + 2;

(* anyconst *) logic [(DataW > 1 ? $clog2(DataW) : 1)-1:0] place;  // of the bit that is remembered
(* anyseq *) logic pick;
logic             tracked_q, shown_q, kept_bit_q, last;
logic [PtrW-1:0]  at_q;              // the word of the one that is followed
logic [DataW-1:0] word;
logic [HeldW-1:0] held_q, ahead_q;  // that walk; ahead of the one that is followed

function automatic logic [HeldW-1:0] proof_wrap(input logic [HeldW-1:0] sum);
  proof_wrap = sum >= HeldW'(Places) ? sum - HeldW'(Places) : sum;
endfunction

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign word = words_q[at_q];
assign last = tracked_q && leave_i && ahead_q == '0;  // the one that is followed leaves

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    tracked_q <= 1'b0;
    shown_q   <= 1'b0;
    held_q    <= '0;
  end else begin
    held_q <= held_q + HeldW'(walk_i) - HeldW'(leave_i);
    if (leave_i) shown_q <= last;
    if (last) tracked_q <= 1'b0;
    else if (!tracked_q && !shown_q && walk_i && pick) tracked_q <= 1'b1;
  end
end
always_ff @(posedge clk_i) begin
  ahead_q <= (tracked_q ? ahead_q : held_q) - HeldW'(leave_i);
  if (!tracked_q && !shown_q) begin
    kept_bit_q <= payload_i[place];
    at_q       <= tail_q;
  end
end

always_comb begin
  assume (held_q + HeldW'(walk_i) <= HeldW'(Places) + HeldW'(leave_i));
  assume (!leave_i || held_q != '0);
  if (rst_ni) begin
    assert (!shown_q || payload_o[place] == kept_bit_q);
    // invariants
    assert (HeldW'(tail_q) < HeldW'(Places) && HeldW'(head_q) < HeldW'(Places) && held_q <= HeldW'(Places));
    assert (HeldW'(tail_q) == proof_wrap(HeldW'(head_q) + held_q));
    assert (!(tracked_q && shown_q));
    if (tracked_q) begin
      assert (ahead_q < held_q);
      assert (HeldW'(at_q) == proof_wrap(HeldW'(head_q) + ahead_q));
      assert (word[place] == kept_bit_q);
    end
  end
end
