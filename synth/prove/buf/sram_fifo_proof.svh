// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_sram_fifo.sv in its proofs: a queue of Depth words in an SRAM, visible two cycles later.
//
// Rule    proof_stream; ready exactly while fewer than Depth words are held, count_o is their number; a word that is
//         held shows in this cycle or the next.
// Invariant  Pointers stay inside the ring and apart by the words in the memory; the remembered word, which is one that
//         goes to the word of the SRAM that proof_memory watches, lies there, or in the SRAM's output register once it
//         is the head.

(* hierconn *) logic [PtrW-1:0] \u_words.u_proof.word_o ;
(* hierconn *) logic [(DataW > 1 ? $clog2(DataW) : 1)-1:0] \u_words.u_proof.place_o ;
(* hierconn *) logic \u_words.u_proof.written_o ;
(* hierconn *) logic \u_words.u_proof.bit_o ;
(* hierconn *) logic \u_words.u_proof.shown_o ;
(* hierconn *) logic \u_words.u_proof.shown_bit_o ;

(* anyseq *) logic pick;
logic              tracked, kept_bit, empty_q;
logic [CountW-1:0] ahead, held;
logic [PtrW:0]     place;
logic [(DataW > 1 ? $clog2(DataW) : 1)-1:0] bit_place;

function automatic logic [PtrW:0] proof_wrap(input logic [PtrW+1:0] sum);
  proof_wrap = sum >= (PtrW+2)'(Depth) ? (PtrW+1)'(sum - (PtrW+2)'(Depth)) : (PtrW+1)'(sum);
endfunction

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_stream #(.DataW(DataW), .Capacity(Depth)) u_proof (
  .clk_i, .rst_ni, .in_valid_i, .in_ready_i(in_ready_o), .in_i, .out_valid_i(out_valid_o), .out_ready_i, .out_i(out_o),
  .pick_i(pick && tail_q == \u_words.u_proof.word_o ),
  .tracked_o(tracked), .ahead_o(ahead), .place_o(bit_place), .bit_o(kept_bit), .held_o(held)
);

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) empty_q <= 1'b1;
  else empty_q <= held == '0 || out_valid_o;
end

// Of the word, if it is in the memory.
assign place = proof_wrap((PtrW+2)'(head_q) + (PtrW+2)'(ahead - CountW'(out_valid_q)));
always_comb begin
  assume (bit_place == \u_words.u_proof.place_o );
  if (rst_ni) begin
    assert (in_ready_o == (held != CountW'(Depth)));
    assert (count_o == held);
    assert (empty_q || out_valid_o);
    assert (stored_q <= CountW'(Depth) - CountW'(out_valid_q));
    assert ((PtrW+1)'(head_q) < (PtrW+1)'(Depth));
    assert ((PtrW+1)'(tail_q) == proof_wrap((PtrW+2)'(head_q) + (PtrW+2)'(stored_q)));
    if (tracked && ahead == '0 && out_valid_q) begin
      assert (\u_words.u_proof.shown_o && \u_words.u_proof.shown_bit_o == kept_bit);
    end else if (tracked) begin
      assert (place[PtrW-1:0] == \u_words.u_proof.word_o );
      assert (\u_words.u_proof.written_o && \u_words.u_proof.bit_o == kept_bit);
    end
  end
end
