// SPDX-License-Identifier: Apache-2.0
// sram_unknown: rtl/lib/pipegs_sram.sv for a simulator of four states: what is not promised is X.
//
// Idea    A read of the word that is written in the same cycle shows X, a read whose enable or address is X as well; a
//         write whose enable or address is X leaves no word known. Everything starts X. unknown_bench, in which it
//         stands, is told of an enable, or an address in use, that is X behind the reset.

module pipegs_sram #(
  parameter DataW = 32,
  parameter Depth = 64,
  parameter Ports = 2,
  parameter AddrW = Depth > 1 ? $clog2(Depth) : 1
) (
  input                  clk_i,

  input                  write_i,
  input      [AddrW-1:0] waddr_i,
  input      [DataW-1:0] wdata_i,

  input                  read_i,
  input      [AddrW-1:0] raddr_i,
  output reg [DataW-1:0] rdata_o
);

  reg [DataW-1:0] words_q [0:Depth-1];
  integer i;

  task fault(input [8*24-1:0] what);
    begin
      $display("%m: X in %0s", what);
      unknown_bench.fault("X at a memory");
    end
  endtask

  always @(posedge clk_i) begin
    if (unknown_bench.core_rst_n === 1'b1) begin
      if (^{read_i, write_i} === 1'bx) fault("an enable");
      if (read_i === 1'b1 && ^raddr_i === 1'bx) fault("the address of a read");
      if (write_i === 1'b1 && ^waddr_i === 1'bx) fault("the address of a write");
    end
    if (read_i === 1'b1 && (write_i === 1'b0 || (raddr_i == waddr_i) === 1'b0)) rdata_o <= words_q[raddr_i];
    else if (read_i !== 1'b0) rdata_o <= {DataW{1'bx}};
    if (write_i === 1'b1 && ^waddr_i !== 1'bx) words_q[waddr_i] <= wdata_i;
    else if (write_i !== 1'b0) for (i = 0; i < Depth; i = i + 1) words_q[i] <= {DataW{1'bx}};
  end

endmodule
