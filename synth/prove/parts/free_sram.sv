// SPDX-License-Identifier: Apache-2.0
// free_sram: stands for rtl/lib/pipegs_sram.sv in proofs of its users: any output that the rule of proof_memory allows.
//
// Idea    Nothing is stored but what proof_memory remembers, so a proof costs the same for any size. All that a real
//         SRAM does is allowed here (proof `sram`), so what holds with this module holds with that one. With
//         one port its user never reads and writes in one cycle.

module pipegs_sram #(
  parameter int unsigned DataW = 32,
  parameter int unsigned Depth = 64,
  parameter int unsigned Ports = 2,
  localparam int unsigned AddrW = Depth > 1 ? $clog2(Depth) : 1
) (
  input  logic             clk_i,

  input  logic             write_i,
  input  logic [AddrW-1:0] waddr_i,
  input  logic [DataW-1:0] wdata_i,

  input  logic             read_i,
  input  logic [AddrW-1:0] raddr_i,
  output logic [DataW-1:0] rdata_o
);

  (* anyseq *) logic [DataW-1:0] any;
  logic kept;

  assign rdata_o = any;
  proof_memory #(.DataW(DataW), .Depth(Depth)) u_proof (
    .clk_i, .write_i, .waddr_i, .wdata_i, .read_i, .raddr_i, .rdata_i(rdata_o), .kept_o(kept),
    .word_o(), .place_o(), .written_o(), .bit_o(), .shown_o(), .shown_bit_o()
  );
  always_comb assume (kept);
  always_comb assert (Ports == 2 || !(read_i && write_i));

endmodule
