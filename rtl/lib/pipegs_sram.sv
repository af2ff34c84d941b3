// SPDX-License-Identifier: Apache-2.0
// pipegs_sram: the only place where memory is made: one write port and one synchronous read port, or one for both.
//
// Idea    Everything that stores more than a handful of words instantiates this module, so that synthesis counts
//         the macros in one place and a technology replaces them in one place. A handful of words is flip-flops:
//         pipegs_fifo instead of pipegs_sram_fifo.
// Stream  write_i stores wdata_i at waddr_i. read_i fetches raddr_i; rdata_o shows it from the next cycle on and holds
//         it until the next read. What a read of the word shows that is written in the same cycle is not promised, nor
//         what a word holds that was never written, nor rdata_o before the first read. There is no reset.
//         With Ports 1 no cycle has both: the macro has one port, at waddr_i or raddr_i, and half the area. A write
//         leaves rdata_o as it is there, too.
// Pace    One write and one read per cycle; with Ports 1 one of them.
// Model   An array. In simulation what is not promised is noise, with the run's seed: words and registers start from it
//         (X where a simulator has four states), and a collision shows other noise each time.

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

  (* no_rw_check *)  // so Yosys builds nothing around a block RAM for the collision of which nothing is promised
  logic [DataW-1:0] words_q [Depth];
`ifndef SYNTHESIS
  // A linear congruential generator, which moves with each collision: nothing is computed in other cycles.
  localparam int unsigned Parts = (DataW + 31) / 32;
  logic [63:0] noise_q;
`endif

  always_ff @(posedge clk_i) begin
    if (read_i) rdata_o <= words_q[raddr_i];
    if (write_i) words_q[waddr_i] <= wdata_i;
`ifndef SYNTHESIS
    if (read_i && write_i && raddr_i == waddr_i) begin
      rdata_o <= DataW'({Parts{noise_q[63:32]}});
      noise_q <= noise_q * 64'd6364136223846793005 + 64'd1442695040888963407;
    end
`endif
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) assert (Ports == 2 || !(read_i && write_i));
`endif

endmodule
