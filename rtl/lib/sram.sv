// SPDX-License-Identifier: Apache-2.0
// sram: the only place where memory is made: one write port and one synchronous read port.
//
// Idea    Everything that stores more than a handful of words instantiates this module, so that synthesis counts
//         the macros in one place and a technology replaces them in one place. A handful of words is flip-flops:
//         fifo instead of sram_fifo.
// Stream  write_i stores wdata_i at waddr_i. read_i fetches raddr_i; rdata_o shows it from the next cycle on and holds
//         it until the next read. Reading the word that is written in the same cycle gives the old word. There is no
//         reset: a word that was never written, and rdata_o before the first read, are undefined.
// Pace    One write and one read per cycle.
// Model   An array.

module sram #(
  parameter int unsigned DataW = 32,
  parameter int unsigned Depth = 64,
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

  logic [DataW-1:0] words_q [Depth];

  always_ff @(posedge clk_i) begin
    if (read_i) rdata_o <= words_q[raddr_i];
    if (write_i) words_q[waddr_i] <= wdata_i;
  end

endmodule
