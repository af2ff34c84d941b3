// SPDX-License-Identifier: Apache-2.0
// open_sram: stands for rtl/lib/pipegs_sram.sv in proofs of small stores that look at every word of it.
//
// Idea    The same memory as one register, `words`, which its user's proof sees by a (* hierconn *) wire. A read of the
//         word that is written shows anything, as the real one's may.

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
  logic [Depth*DataW-1:0] words;

  always_ff @(posedge clk_i) begin
    if (read_i) rdata_o <= write_i && waddr_i == raddr_i ? any : words[raddr_i*DataW +: DataW];
    if (write_i) words[waddr_i*DataW +: DataW] <= wdata_i;
  end

endmodule
