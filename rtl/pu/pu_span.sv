// SPDX-License-Identifier: Apache-2.0
// pu_span: the columns (or rows) of squares that a Gaussian's box touches along one axis.
//
// Idea    The box mean +- extent holds pixels low .. high; without their lower bits these are columns of squares, here
//         windows of the frame or parts of a window. A nearly endless extent counts as endless.
// Stream  mean, extent, the last square -> first and last one that the box touches; none_o, it touches none.
//         Combinational.
// Model   cpp_model/pu/pu_span.hpp

module pu_span #(
  parameter int unsigned SideF  = 6,  // log2 of a square's side in pixels
  parameter int unsigned IndexW = pipegs_pkg::WindowW,
  localparam int unsigned MeanW   = pipegs_pkg::MeanW,
  localparam int unsigned ExtentW = pipegs_pkg::ExtentW
) (
  input  logic signed [MeanW-1:0] mean_i,    // relative to the first pixel of square 0, .MeanF
  input  logic [ExtentW-1:0]      extent_i,  // u18.4
  input  logic [IndexW-1:0]       most_i,    // the last square
  output logic [IndexW-1:0]       first_o,
  output logic [IndexW-1:0]       last_o,
  output logic                    none_o
);

  localparam int unsigned MeanF   = pipegs_pkg::MeanF;
  localparam int unsigned ExtentF = 4;
  localparam int unsigned NearlyW = 10;  // an extent within 2^NearlyW of its largest is endless
  localparam int unsigned HalfW   = ExtentW + MeanF - ExtentF + 1;
  localparam int unsigned BoxW    = (HalfW > MeanW ? HalfW : MeanW) + 2;

  logic signed [BoxW-1:0] half, low, high, first, last, limit;
  logic                   endless;

  assign half    = BoxW'(extent_i) << (MeanF - ExtentF);
  assign low     = (BoxW'(mean_i) - half + $signed(BoxW'((1 << MeanF) - 1))) >>> MeanF;  // pixels
  assign high    = (BoxW'(mean_i) + half) >>> MeanF;
  assign first   = low >>> SideF;
  assign last    = high >>> SideF;
  assign limit   = $signed(BoxW'(most_i));
  assign endless = &extent_i[ExtentW-1:NearlyW];
  assign first_o = endless || first < 0 ? '0 : IndexW'(first);
  assign last_o  = endless || last > limit ? most_i : IndexW'(last);
  assign none_o  = !endless && (low > high || first > limit || last < 0);

endmodule
