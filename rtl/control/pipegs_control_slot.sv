// SPDX-License-Identifier: Apache-2.0
// pipegs_control_slot: one value of up to 64 bits in two registers, the low word first.
//
// Idea    The value begins at bit Shift of the slot: an address is written in bytes and kept in lines of memory. Below
//         it the slot reads 0, above it the value's sign if it is Signed, else 0; there nothing is kept.
// Stream  write_i: pulse, looked at where the word is one of the two; write_mask_i: ones in the bytes that are written.
// Pace    A write shows in the next cycle; read_data_o follows read_word_i in the same cycle, 0 where it is not hit.
// Model   cpp_model/control/control_registers.hpp

module pipegs_control_slot #(
  parameter int unsigned WordW  = 10,
  parameter int unsigned Word   = 0,      // number of the low word, even
  parameter int unsigned Width  = 40,
  parameter int unsigned Shift  = 0,
  parameter bit          Signed = 1'b0
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             write_i,
  input  logic [WordW-1:0] write_word_i,
  input  logic [31:0]      write_data_i,
  input  logic [31:0]      write_mask_i,
  input  logic [WordW-1:0] read_word_i,
  output logic [31:0]      read_data_o,
  output logic [Width-1:0] value_o
);

  logic [Width-1:0] value_q;
  logic [63:0]      wide, shown, mask, next;
  logic             write_hit, read_hit, unused_next;

  assign write_hit = write_word_i[WordW-1:1] == (WordW-1)'(Word / 2);
  assign read_hit  = read_word_i[WordW-1:1] == (WordW-1)'(Word / 2);

  always_comb begin
    wide             = {64{Signed && value_q[Width-1]}};
    wide[0 +: Width] = value_q;
    shown            = wide << Shift;
  end

  assign mask        = write_word_i[0] ? {write_mask_i, 32'd0} : {32'd0, write_mask_i};
  assign next        = (shown & ~mask) | ({write_data_i, write_data_i} & mask);
  assign unused_next = &{1'b0, next};
  assign read_data_o = !read_hit ? '0 : read_word_i[0] ? shown[63:32] : shown[31:0];
  assign value_o     = value_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) value_q <= '0;
    else if (write_i && write_hit) value_q <= next[Shift +: Width];
  end

endmodule
