// SPDX-License-Identifier: Apache-2.0
// ru_unorm: a colour in 10 bits, as A2B10G10R10 has it, or in 8, as RGBA8.
//
// Idea    round((2^CodeW - 1) c), half up: 2^CodeW c - c, and half a unit; what is above one is the largest code.
// Stream  color_i, u2.(RgbW-2) -> code_o. Combinational.
// Model   ru_unorm in cpp_model/ru/ru_resolve.hpp

module ru_unorm #(
  parameter int unsigned CodeW = 10,
  localparam int unsigned RgbW = pipegs_pkg::RgbW
) (
  input  logic [RgbW-1:0]  color_i,
  output logic [CodeW-1:0] code_o
);

  localparam int unsigned Fraction = RgbW - 2;
  localparam int unsigned WideW    = RgbW + CodeW;

  logic [WideW-1:0] wide;
  assign wide   = {color_i, CodeW'(0)} - WideW'(color_i) + (WideW'(1) << (Fraction - 1));
  assign code_o = wide[WideW-1:Fraction+CodeW] != '0 ? '1 : wide[Fraction +: CodeW];

  logic unused_fraction;
  assign unused_fraction = ^wide[Fraction-1:0];

endmodule
