// SPDX-License-Identifier: Apache-2.0
// The end of rtl/lib/pipegs_sram.sv in its proof: the rule of proof_memory holds.
//
// Invariant  Once the remembered word is written, the memory holds its bit.

logic             kept, written, written_bit;
logic [AddrW-1:0] word;
logic [DataW-1:0] stored;
logic [(DataW > 1 ? $clog2(DataW) : 1)-1:0] place;

proof_memory #(.DataW(DataW), .Depth(Depth)) u_proof (
  .clk_i, .write_i, .waddr_i, .wdata_i, .read_i, .raddr_i, .rdata_i(rdata_o), .kept_o(kept),
  .word_o(word), .place_o(place), .written_o(written), .bit_o(written_bit), .shown_o(), .shown_bit_o()
);

assign stored = words_q[word];
always_comb begin
  assert (kept);
  assert (!written || stored[place] == written_bit);
end
