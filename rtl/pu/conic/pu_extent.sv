// SPDX-License-Identifier: Apache-2.0
// pu_extent: the half extents of the box of pixels that a Gaussian can reach.
//
// Paper   the bounding box before the tile test (Sec. 4.2).
// Idea    On the box's side the power is -budget:  extent^2 = 2 ln(2) variance (log2(AlphaCut) - opacity).
//         t = budget * 2 ln(2) here, variance * t in pu_conic's multiplier, the roots here, two bits per cycle.
// Stream  Follows the turns of pu_conic: t for cycles 2 and 3, product_i in 3 (a t) and 4 (c t), extents in cycle 5 of
//         the next turn.
// Pace    One record in eight cycles.
// Model   cpp_model/pu/conic/pu_extent.hpp

module pu_extent #(
  localparam int unsigned MantissaW = pipegs_pkg::MantissaW,
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW,
  localparam int unsigned OpacityW  = pipegs_pkg::OpacityW,
  localparam int unsigned ExtentW   = pipegs_pkg::ExtentW
) (
  input  logic                          clk_i,

  input  logic [7:0]                    phase_i,
  input  logic                          advance_i,  // the phase moves on

  input  logic [OpacityW-1:0]           opacity_i,
  input  logic signed [FloatEW-1:0]     a_e_i,      // exponents of the variances
  input  logic signed [FloatEW-1:0]     c_e_i,
  output logic [OpacityW-1:0]           t_o,
  input  logic [MantissaW+OpacityW-1:0] product_i,

  output logic [ExtentW-1:0]            extent_x_o,
  output logic [ExtentW-1:0]            extent_y_o
);

  localparam int unsigned OpacityF  = pipegs_pkg::OpacityF;
  localparam int unsigned RadicandW = 28;  // of pu_root
  localparam int unsigned RootW     = RadicandW / 2;
  localparam int unsigned SumW      = FloatEW + 4;  // sums of exponents
  localparam int unsigned LengthW   = $clog2(OpacityW + 1);
  localparam int unsigned Cut       = MantissaW + OpacityW - RadicandW;

  localparam logic [OpacityW-1:0] Budget = OpacityW'(pipegs_pkg::CutBudget);
  // 2 ln(2) (1 + 1/64) * 2^8, rounded up.
  localparam int unsigned MarginF = 8;
  localparam int unsigned MarginW = 9;
  localparam logic [MarginW-1:0] Margin = MarginW'(361);

  // --- the budget of the box: cycle 0 the value, cycle 1 shifted to the left end -----------------------------------
  logic [OpacityW-1:0]         budget;
  logic [OpacityW+MarginW-1:0] scaled;
  logic [OpacityW-1:0]         t_q, t_left_q;
  logic [LengthW-1:0]          t_length;
  logic [FloatEW-1:0]          lead, lead_q;
  assign budget = Budget > opacity_i ? Budget - opacity_i : '0;
  assign scaled = (OpacityW + MarginW)'(budget) * (OpacityW + MarginW)'(Margin);

  pipegs_bit_length #(.DataW(OpacityW)) u_length (
    .in_i(t_q),
    .length_o(t_length)
  );
  assign lead = FloatEW'(OpacityW) - FloatEW'(t_length);
  assign t_o  = t_left_q;
  always_ff @(posedge clk_i) begin
    if (phase_i[0]) t_q <= OpacityW'(scaled >> MarginF) + OpacityW'(1);
    if (phase_i[1]) begin
      t_left_q <= t_q << lead;
      lead_q   <= lead;
    end
  end

  // --- the two roots -----------------------------------------------------------------------------------------------
  logic signed [SumW-1:0] exponent, half, half_x_q, half_y_q;
  logic signed [FloatEW-1:0] variance_e;
  logic [RadicandW-1:0]   radicand;
  logic [RootW-1:0]       root_x, root_y, root;
  logic [ExtentW-1:0]     pixels, pixels_x_q, pixels_y_q;

  assign variance_e = phase_i[3] ? a_e_i : c_e_i;
  assign exponent   = SumW'(variance_e) - SumW'($signed({1'b0, lead_q})) + SumW'(8) + SumW'(Cut) - SumW'(OpacityF);
  assign radicand = exponent[0] ? RadicandW'(product_i >> (Cut + 1)) : RadicandW'(product_i >> Cut);

  pu_root u_root_x (
    .clk_i,
    .load_i(phase_i[3]),
    .step_i(advance_i),
    .radicand_i(radicand),
    .root_o(root_x)
  );
  pu_root u_root_y (
    .clk_i,
    .load_i(phase_i[4]),
    .step_i(advance_i),
    .radicand_i(radicand),
    .root_o(root_y)
  );

  // (root + 1) * 2^half, in 1/16 pixel.
  localparam int unsigned ByW = 5;
  logic [RootW:0]         up;
  logic [SumW-1:0]        minus_half;
  logic [ExtentW+RootW:0] raised;
  assign root       = phase_i[3] ? root_x : root_y;
  assign half       = phase_i[3] ? half_x_q : half_y_q;
  assign up         = (RootW + 1)'(root) + (RootW + 1)'(1);
  assign minus_half = -half;
  assign raised     = (ExtentW + RootW + 1)'(up) << half[ByW-1:0];
  always_comb begin
    if (half >= $signed(SumW'(ExtentW))) pixels = '1;
    else if (half >= 0) pixels = raised[ExtentW+RootW:ExtentW] != '0 ? '1 : raised[ExtentW-1:0];
    else pixels = minus_half[SumW-1:ByW] != '0 ? '0 : ExtentW'(up) >> minus_half[ByW-1:0];
  end
  always_ff @(posedge clk_i) begin
    if (phase_i[3]) begin
      half_x_q   <= (exponent + $signed(SumW'(exponent[0]))) >>> 1;
      pixels_x_q <= pixels;
    end
    if (phase_i[4]) begin
      half_y_q   <= (exponent + $signed(SumW'(exponent[0]))) >>> 1;
      pixels_y_q <= pixels;
    end
  end

  localparam int unsigned FarShift = MantissaW - 4;
  logic [ExtentW:0] extent_x, extent_y;
  assign extent_x   = (ExtentW + 1)'(pixels_x_q) + ((ExtentW + 1)'(pixels_y_q) >> FarShift) + (ExtentW + 1)'(2);
  assign extent_y   = (ExtentW + 1)'(pixels_y_q) + ((ExtentW + 1)'(pixels_x_q) >> FarShift) + (ExtentW + 1)'(2);
  assign extent_x_o = extent_x[ExtentW] ? '1 : extent_x[ExtentW-1:0];
  assign extent_y_o = extent_y[ExtentW] ? '1 : extent_y[ExtentW-1:0];

  wire unused_phase = &{1'b0, phase_i};

endmodule
