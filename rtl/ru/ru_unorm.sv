// SPDX-License-Identifier: Apache-2.0
// ru_unorm: a colour in 10 bits, as A2B10G10R10 has it.
//
// Idea    round(1023 c), half up: 1024 c - c, and half a unit; what is above one is 1023.
// Stream  color_i, u2.(RgbW-2) -> code_o. Combinational.
// Model   ru_unorm in cpp_model/ru/ru_resolve.hpp

module ru_unorm #(
  localparam int unsigned RgbW  = pipegs_pkg::RgbW,
  localparam int unsigned CodeW = 10
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
