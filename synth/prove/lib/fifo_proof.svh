// SPDX-License-Identifier: Apache-2.0
// The end of rtl/lib/pipegs_fifo.sv in its proof: a queue of Depth words, visible in the next cycle.
//
// Rule    proof_stream; ready exactly while a place is free, valid exactly while a word is held, count_o is their
//         number.
// Invariant  Pointers stay inside the ring and apart by the count; the remembered word lies `ahead` places behind the
//         head.

(* anyseq *) logic pick;
logic              tracked;  // by u_proof, see proof_stream
logic [CountW-1:0] ahead, held;
logic              kept_bit;
logic [(DataW > 1 ? $clog2(DataW) : 1)-1:0] bit_place;
logic [PtrW:0]     place;
logic [DataW-1:0]  kept_word;

function automatic logic [PtrW:0] proof_wrap(input logic [PtrW+1:0] sum);
  proof_wrap = sum >= (PtrW+2)'(Depth) ? (PtrW+1)'(sum - (PtrW+2)'(Depth)) : (PtrW+1)'(sum);
endfunction

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_stream #(.DataW(DataW), .Capacity(Depth)) u_proof (
  .clk_i, .rst_ni, .in_valid_i, .in_ready_i(in_ready_o), .in_i, .out_valid_i(out_valid_o), .out_ready_i, .out_i(out_o),
  .pick_i(pick), .tracked_o(tracked), .ahead_o(ahead), .place_o(bit_place), .bit_o(kept_bit), .held_o(held)
);

assign place = proof_wrap((PtrW+2)'(head_q) + (PtrW+2)'(ahead));
assign kept_word = words_q[place[PtrW-1:0]];
always_comb begin
  if (rst_ni) begin
    assert (in_ready_o == (held != CountW'(Depth)));
    assert (out_valid_o == (held != '0));
    assert (count_o == held);
    assert ((PtrW+1)'(head_q) < (PtrW+1)'(Depth));
    assert ((PtrW+1)'(tail_q) == proof_wrap((PtrW+2)'(head_q) + (PtrW+2)'(held)));
    assert (!tracked || kept_word[bit_place] == kept_bit);
  end
end
