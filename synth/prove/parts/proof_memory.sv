// SPDX-License-Identifier: Apache-2.0
// proof_memory: what an SRAM promises, kept for one bit of one word, both of the solver's choice.
//
// Rule    A read of the word shows in the next cycle what was written to it last, or anything if it is written in the
//         cycle of the read; and the output stays until the next read.
// Use     In `sram` the rule is proven (sram_proof.svh). In free_sram it is assumed, and users of any size are proven
//         with that one in the SRAM's place; they see the ports here by (* hierconn *) wires of the same hierarchical
//         name.

module proof_memory #(
  parameter int unsigned DataW = 1,
  parameter int unsigned Depth = 2,
  localparam int unsigned AddrW = Depth > 1 ? $clog2(Depth) : 1,
  localparam int unsigned BitW = DataW > 1 ? $clog2(DataW) : 1
) (
  input  logic             clk_i,
  input  logic             write_i,
  input  logic [AddrW-1:0] waddr_i,
  input  logic [DataW-1:0] wdata_i,
  input  logic             read_i,
  input  logic [AddrW-1:0] raddr_i,
  input  logic [DataW-1:0] rdata_i,

  output logic             kept_o,     // the rule
  output logic [AddrW-1:0] word_o,     // which word
  output logic [BitW-1:0]  place_o,    // which bit of it
  output logic             written_o,  // it was written
  output logic             bit_o,      // its value
  output logic             shown_o,    // the output has to show
  output logic             shown_bit_o // this value
);

  (* anyconst *) logic [AddrW-1:0] word;
  (* anyconst *) logic [BitW-1:0]  place;
  logic             written_q = 1'b0, shown_q = 1'b0, held_q = 1'b0, bit_q, shown_bit_q;
  logic [DataW-1:0] before_q;

  always_ff @(posedge clk_i) begin
    if (write_i && waddr_i == word) begin
      written_q <= 1'b1;
      bit_q     <= wdata_i[place];
    end
    if (read_i) begin
      shown_q     <= raddr_i == word && written_q && !(write_i && waddr_i == word);
      shown_bit_q <= bit_q;
    end
    held_q   <= !read_i;
    before_q <= rdata_i;
  end

  always_comb begin
    assume ({1'b0, word} < (AddrW+1)'(Depth));
    assume ({1'b0, place} < (BitW+1)'(DataW));
  end
  assign word_o      = word;
  assign place_o     = place;
  assign written_o   = written_q;
  assign bit_o       = bit_q;
  assign shown_o     = shown_q;
  assign shown_bit_o = shown_bit_q;
  assign kept_o      = (!shown_q || rdata_i[place] == shown_bit_q) && (!held_q || rdata_i == before_q);

endmodule
