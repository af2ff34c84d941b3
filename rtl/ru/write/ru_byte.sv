// SPDX-License-Identifier: Apache-2.0
// ru_byte: a colour of 10 bits in 8.
//
// Idea    round(255 c / 1023): 4.0118 codes of 10 bits are one of 8. So it is a fourth of c, of which one less is taken
//         from each third of the range on: thirds of c - 1, c and c + 1 round to the nearest byte, all of them.
// Stream  code_i, 0 .. 1023 -> byte_o, 0 .. 255. Combinational.
// Model   ru_byte in cpp_model/ru/ru_raster.hpp

module ru_byte (
  input  logic [9:0] code_i,
  output logic [7:0] byte_o
);

  localparam logic [9:0] Second = 10'd343;  // codes from which on the second and the last third reach
  localparam logic [9:0] Third  = 10'd684;

  logic [9:0] shifted;
  assign shifted = code_i >= Third ? code_i - 1'b1 : code_i >= Second ? code_i : code_i + 1'b1;
  assign byte_o  = shifted[9:2];

  logic unused_low;
  assign unused_low = ^shifted[1:0];

endmodule
