// SPDX-License-Identifier: Apache-2.0
// pu_four_extent: pu_extent in four cycles: the half extents of the box of pixels that a Gaussian can reach.
//
// Paper   the bounding box before the tile test (Sec. 4.2).
// Idea    On the box's side the power is -budget:  extent^2 = 2 ln(2) variance (log2(AlphaCut) - opacity).
//         t = budget * 2 ln(2) here, variance * t in pu_conic's multiplier, the roots here, two bits per cycle.
// Stream  Follows the cycles of pu_four_conic: t for cycles 3 and 4, product_i in 4 (t times the smaller variance) and
//         5 (the larger one), extents in cycle 14. Two sets of roots, for one record and the next.
// Pace    One record in four cycles.
// Model   cpp_model/pu/conic/pu_extent.hpp

module pu_four_extent #(
  localparam int unsigned MantissaW = pipegs_pkg::MantissaW,
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW,
  localparam int unsigned OpacityW  = pipegs_pkg::OpacityW,
  localparam int unsigned ExtentW   = pipegs_pkg::ExtentW
) (
  input  logic                          clk_i,

  input  logic                          step_i,
  input  logic [1:0]                    phase_i,     // cycles 0 and 1

  input  logic [OpacityW-1:0]           opacity_i,
  output logic [OpacityW-1:0]           t_o,

  input  logic [1:0]                    load_i,      // cycles 4 and 5
  input  logic                          load_set_i,
  input  logic [MantissaW+OpacityW-1:0] product_i,
  input  logic signed [FloatEW-1:0]     less_e_i,    // exponents of the variances
  input  logic signed [FloatEW-1:0]     more_e_i,

  input  logic [1:0]                    give_i,      // cycles 12 and 13
  input  logic                          give_set_i,
  input  logic                          swap_i,      // x has the larger variance
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
  always_ff @(posedge clk_i) if (step_i) begin
    if (phase_i[0]) t_q <= OpacityW'(scaled >> MarginF) + OpacityW'(1);
    if (phase_i[1]) begin
      t_left_q <= t_q << lead;
      lead_q   <= lead;
    end
  end

  // --- the roots: of the smaller and of the larger variance, in each set ---------------------------------------------
  logic signed [SumW-1:0]    exponent, half, half_q [4];
  logic signed [FloatEW-1:0] variance_e;
  logic [RadicandW-1:0]      radicand;
  logic [RootW-1:0]          roots [4], root;
  logic [ExtentW-1:0]        pixels, pixels_q [2], pixels_x, pixels_y;

  assign variance_e = load_i[0] ? less_e_i : more_e_i;
  assign exponent   = SumW'(variance_e) - SumW'($signed({1'b0, lead_q})) + SumW'(8) + SumW'(Cut) - SumW'(OpacityF);
  assign radicand = exponent[0] ? RadicandW'(product_i >> (Cut + 1)) : RadicandW'(product_i >> Cut);

  for (genvar k = 0; k < 2; k += 1) begin : gen_set
    for (genvar i = 0; i < 2; i += 1) begin : gen_root
      logic load;
      assign load = load_i[i] && load_set_i == (k == 1);
      pu_root u_root (
        .clk_i,
        .load_i(load && step_i),
        .step_i,
        .radicand_i(radicand),
        .root_o(roots[2*k+i])
      );
      always_ff @(posedge clk_i) begin
        if (load && step_i) half_q[2*k+i] <= (exponent + $signed(SumW'(exponent[0]))) >>> 1;
      end
    end
  end

  // (root + 1) * 2^half, in 1/16 pixel.
  localparam int unsigned ByW = 5;
  logic [RootW:0]         up;
  logic [SumW-1:0]        minus_half;
  logic [ExtentW+RootW:0] raised;
  assign root       = roots[{give_set_i, give_i[1]}];
  assign half       = half_q[{give_set_i, give_i[1]}];
  assign up         = (RootW + 1)'(root) + (RootW + 1)'(1);
  assign minus_half = -half;
  assign raised     = (ExtentW + RootW + 1)'(up) << half[ByW-1:0];
  always_comb begin
    if (half >= $signed(SumW'(ExtentW))) pixels = '1;
    else if (half >= 0) pixels = raised[ExtentW+RootW:ExtentW] != '0 ? '1 : raised[ExtentW-1:0];
    else pixels = minus_half[SumW-1:ByW] != '0 ? '0 : ExtentW'(up) >> minus_half[ByW-1:0];
  end
  always_ff @(posedge clk_i) if (step_i) begin
    for (int unsigned i = 0; i < 2; i += 1) if (give_i[i]) pixels_q[i] <= pixels;
  end
  assign pixels_x = pixels_q[swap_i];
  assign pixels_y = pixels_q[!swap_i];

  localparam int unsigned FarShift = MantissaW - 4;
  logic [ExtentW:0] extent_x, extent_y;
  assign extent_x   = (ExtentW + 1)'(pixels_x) + ((ExtentW + 1)'(pixels_y) >> FarShift) + (ExtentW + 1)'(2);
  assign extent_y   = (ExtentW + 1)'(pixels_y) + ((ExtentW + 1)'(pixels_x) >> FarShift) + (ExtentW + 1)'(2);
  assign extent_x_o = extent_x[ExtentW] ? '1 : extent_x[ExtentW-1:0];
  assign extent_y_o = extent_y[ExtentW] ? '1 : extent_y[ExtentW-1:0];

endmodule
