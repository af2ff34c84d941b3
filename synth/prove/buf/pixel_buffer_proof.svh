// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_pixel_buffer.sv in its proofs: two halves that change roles, each side sees its own.
//
// Idea    Scoreboard of one word, any word, of which both sides have one: what the blender wrote to its own since the
//         last swap, and what it had written to the other one before. A swap hands the first over and makes a fresh
//         one.
// Rule    A read shows from the next cycle on, until the side's next read or a swap, whether the word was written, and
//         if so what was written last before the read. A write shows to the blender alone until the swap.
// Assumes No access in the cycle of a swap, no read of a word in the cycle in which it is written (the module's own
//         promises).
// Invariant  Flags and SRAM of each half agree with the scoreboard.

(* hierconn *) logic [AddrW-1:0] \u_half_0.u_proof.word_o ;
(* hierconn *) logic [$clog2(DataW)-1:0] \u_half_0.u_proof.place_o ;
(* hierconn *) logic \u_half_0.u_proof.written_o ;
(* hierconn *) logic \u_half_0.u_proof.bit_o ;
(* hierconn *) logic \u_half_0.u_proof.shown_o ;
(* hierconn *) logic \u_half_0.u_proof.shown_bit_o ;
(* hierconn *) logic [AddrW-1:0] \u_half_1.u_proof.word_o ;
(* hierconn *) logic [$clog2(DataW)-1:0] \u_half_1.u_proof.place_o ;
(* hierconn *) logic \u_half_1.u_proof.written_o ;
(* hierconn *) logic \u_half_1.u_proof.bit_o ;
(* hierconn *) logic \u_half_1.u_proof.shown_o ;
(* hierconn *) logic \u_half_1.u_proof.shown_bit_o ;

logic [AddrW-1:0] word;
logic [$clog2(DataW)-1:0] place;
logic blend_written_q, blend_bit_q, resolve_written_q, resolve_bit_q;  // the word on either side
// what either side shows: the word, written, its bit
logic blend_shows_q, blend_shows_written_q, blend_shows_bit_q;
logic resolve_shows_q, resolve_shows_written_q, resolve_shows_bit_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign word  = \u_half_0.u_proof.word_o ;
assign place = \u_half_0.u_proof.place_o ;

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    blend_written_q   <= 1'b0;
    resolve_written_q <= 1'b0;
    blend_shows_q     <= 1'b0;
    resolve_shows_q   <= 1'b0;
  end else begin
    if (blend_write_i && blend_waddr_i == word) blend_written_q <= 1'b1;
    if (blend_read_i) blend_shows_q <= blend_raddr_i == word;
    if (resolve_read_i) resolve_shows_q <= resolve_raddr_i == word;
    if (swap_i) begin
      blend_written_q   <= 1'b0;
      resolve_written_q <= blend_written_q;
      blend_shows_q     <= 1'b0;
      resolve_shows_q   <= 1'b0;
    end
  end
end
always_ff @(posedge clk_i) begin
  if (blend_write_i && blend_waddr_i == word) blend_bit_q <= blend_wdata_i[place];
  if (swap_i) resolve_bit_q <= blend_bit_q;
  if (blend_read_i) begin
    blend_shows_written_q <= blend_written_q;
    blend_shows_bit_q     <= blend_bit_q;
  end
  if (resolve_read_i) begin
    resolve_shows_written_q <= resolve_written_q;
    resolve_shows_bit_q     <= resolve_bit_q;
  end
end

always_comb begin
  assume (word == \u_half_1.u_proof.word_o && place == \u_half_1.u_proof.place_o );
  assume (!swap_i || (!blend_read_i && !blend_write_i && !resolve_read_i));
  assume (!(blend_read_i && blend_write_i) || blend_raddr_i != blend_waddr_i);
  if (rst_ni) begin
    assert (!blend_shows_q || blend_fresh_o == !blend_shows_written_q);
    assert (!resolve_shows_q || resolve_fresh_o == !resolve_shows_written_q);
    assert (!(blend_shows_q && blend_shows_written_q) || blend_rdata_o[place] == blend_shows_bit_q);
    assert (!(resolve_shows_q && resolve_shows_written_q) || resolve_rdata_o[place] == resolve_shows_bit_q);
    // invariants
    assert (blend_written_q == !(half_q ? fresh_1_q[word] : fresh_0_q[word]));
    assert (resolve_written_q == !(half_q ? fresh_0_q[word] : fresh_1_q[word]));
    if (blend_written_q && !half_q) assert (\u_half_0.u_proof.written_o && \u_half_0.u_proof.bit_o == blend_bit_q);
    if (blend_written_q && half_q) assert (\u_half_1.u_proof.written_o && \u_half_1.u_proof.bit_o == blend_bit_q);
    if (resolve_written_q && half_q) assert (\u_half_0.u_proof.written_o && \u_half_0.u_proof.bit_o == resolve_bit_q);
    if (resolve_written_q && !half_q) assert (\u_half_1.u_proof.written_o && \u_half_1.u_proof.bit_o == resolve_bit_q);
    if (blend_shows_q && blend_shows_written_q && !half_q) begin
      assert (\u_half_0.u_proof.shown_o && \u_half_0.u_proof.shown_bit_o == blend_shows_bit_q);
    end
    if (blend_shows_q && blend_shows_written_q && half_q) begin
      assert (\u_half_1.u_proof.shown_o && \u_half_1.u_proof.shown_bit_o == blend_shows_bit_q);
    end
    if (resolve_shows_q && resolve_shows_written_q && half_q) begin
      assert (\u_half_0.u_proof.shown_o && \u_half_0.u_proof.shown_bit_o == resolve_shows_bit_q);
    end
    if (resolve_shows_q && resolve_shows_written_q && !half_q) begin
      assert (\u_half_1.u_proof.shown_o && \u_half_1.u_proof.shown_bit_o == resolve_shows_bit_q);
    end
  end
end
