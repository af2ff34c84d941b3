// SPDX-License-Identifier: Apache-2.0
// pu_edge: does a region's box of pixel centres hold a point with P = power - cut >= 0 ?
//
// Paper   the test behind the 4-bit bitmap of a tile (Sec. 4.2).
// Idea    P is concave, so its maximum over the box is at the mean or on the edges that face it. Keep the region if
//           the mean lies in its box, or P >= 0 at one of its four corners, or
//           on a facing edge the gradient g is > 0 at the first end, < 0 at the other, and  P + g^2 / (4 |curve|) >= 0
//         where the last is tested as g^2 >= 4 |curve| (-P), with g rounded up and -P rounded down.
//         By concavity at most one facing edge rises where two meet; both (by rounding) keep the region.
//         TileTest 0: yes, at the same pace; 2: what pu_touch says of the oriented box.
// Stream  P and its gradients at the region's first pixel in; three cycles later the verdict. hold_i stops all.
// Pace    One region per cycle, latency 3: differences | corners, edge | products | compare.
// Model   cpp_model/pu/conic/pu_edge.hpp

module pu_edge #(
  localparam int unsigned RegionW = pipegs_pkg::MaskIndexW,
  localparam int unsigned AxisW   = RegionW / 2,
  localparam int unsigned MeanW   = pipegs_pkg::MeanW,
  localparam int unsigned DefW    = pipegs_pkg::DefW,
  localparam int unsigned GradW   = pipegs_pkg::BcW + 1,
  localparam int unsigned PowerW  = pipegs_pkg::AW + 4
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     hold_i,
  input  logic                     valid_i,
  input  logic                     last_i,     // of its Gaussian
  input  logic [AxisW-1:0]         column_i,
  input  logic [AxisW-1:0]         row_i,

  input  logic signed [MeanW-1:0]  mean_x_i,   // of the Gaussian
  input  logic signed [MeanW-1:0]  mean_y_i,
  input  logic signed [DefW-1:0]   d_i,
  input  logic signed [DefW-1:0]   e_i,
  input  logic signed [DefW-1:0]   f_i,

  input  logic signed [PowerW-1:0] power_i,    // P at the region's first pixel
  input  logic signed [GradW-1:0]  gx_i,       // gradients there
  input  logic signed [GradW-1:0]  gy_i,

  input  logic                     touches_i,  // by the oriented box

  output logic                     keep_o,
  output logic [RegionW-1:0]       region_o,
  output logic                     last_o
);

  logic verdict;  // on the region of three cycles ago
  if (pipegs_pkg::TileTest == 1) begin : gen_test
    localparam int unsigned MeanF     = pipegs_pkg::MeanF;
    localparam int unsigned CoeffF    = pipegs_pkg::CoeffF;
    localparam int unsigned EightW    = 3;                           // log2 of a region's side
    localparam int unsigned RoundW    = MeanW - MeanF - EightW + 1;  // column of any mean
    localparam int unsigned GradientF = (CoeffF + 10) / 2;
    localparam int unsigned GradientW = GradientF + 7;               // u7.GradientF: an edge bends by at most 14 * 8
    localparam int unsigned DeficitF  = 2 * GradientF + 2 - CoeffF;  // so that the two products have the same unit
    localparam int unsigned DeficitW  = DeficitF + 9;                // u9: a peak rises by at most 49 * 8
    localparam int unsigned SquareW   = 2 * GradientW;
    localparam int unsigned NeedW     = DefW + DeficitW;

    // On which side of the region the mean lies.
    localparam logic [MeanF+EightW-1:0] LastPixel = (MeanF + EightW)'(7 << MeanF);
    logic signed [RoundW-1:0] mean_column, mean_row, column, row;
    logic                     left, right, above, below;
    assign column      = RoundW'($signed({1'b0, column_i}));
    assign row         = RoundW'($signed({1'b0, row_i}));
    assign mean_column = RoundW'(mean_x_i >>> (MeanF + EightW));
    assign mean_row    = RoundW'(mean_y_i >>> (MeanF + EightW));
    assign left        = mean_column < column;
    assign above       = mean_row < row;
    assign right       = mean_column > column || (mean_column == column && mean_x_i[MeanF+EightW-1:0] > LastPixel);
    assign below       = mean_row > row || (mean_row == row && mean_y_i[MeanF+EightW-1:0] > LastPixel);

    // --- 1: differences across the region; gradients along the facing edges, at both ends ----------------------------
    logic signed [PowerW-1:0] power_1_q, across_1_q, down_1_q;
    logic signed [GradW-1:0]  gx, gy, gx_1_q, gy_1_q, gx_end_1_q, gy_end_1_q;
    logic signed [DefW-1:0]   d_1_q, e_1_q, f_1_q;
    logic                     vertical_1_q, horizontal_1_q, right_1_q, below_1_q;
    assign gx = gx_i + (below ? GradW'(f_i) * GradW'(7) : GradW'(0));
    assign gy = gy_i + (right ? GradW'(f_i) * GradW'(7) : GradW'(0));
    always_ff @(posedge clk_i) begin
      if (!hold_i) begin
        power_1_q      <= power_i;
        across_1_q     <= PowerW'(gx_i) * PowerW'(7) + PowerW'(d_i) * PowerW'(49);
        down_1_q       <= PowerW'(gy_i) * PowerW'(7) + PowerW'(e_i) * PowerW'(49);
        gx_1_q         <= gx;
        gy_1_q         <= gy;
        gx_end_1_q     <= gx + GradW'(d_i) * GradW'(14);
        gy_end_1_q     <= gy + GradW'(e_i) * GradW'(14);
        vertical_1_q   <= left || right;
        horizontal_1_q <= above || below;
        right_1_q      <= right;
        below_1_q      <= below;
        d_1_q          <= d_i;
        e_1_q          <= e_i;
        f_1_q          <= f_i;
      end
    end

    // --- 2: the corners; which edge bends ----------------------------------------------------------------------------
    logic signed [PowerW-1:0] power_x, power_y, power_xy, power_edge;
    logic signed [GradW-1:0]  grad_edge;
    logic signed [DefW-1:0]   curve_edge;
    logic                     bends_x, bends_y;
    assign power_x    = power_1_q + across_1_q;
    assign power_y    = power_1_q + down_1_q;
    assign power_xy   = power_1_q + across_1_q + down_1_q + PowerW'(f_1_q) * PowerW'(49);
    assign bends_x    = horizontal_1_q && gx_1_q > 0 && gx_end_1_q < 0;
    assign bends_y    = vertical_1_q && gy_1_q > 0 && gy_end_1_q < 0;
    assign power_edge = bends_x ? (below_1_q ? power_y : power_1_q) : (right_1_q ? power_x : power_1_q);
    assign grad_edge  = bends_x ? gx_1_q : gy_1_q;
    assign curve_edge = bends_x ? d_1_q : e_1_q;

    logic signed [PowerW-1:0] deficit;
    logic                     sure_2_q, maybe_2_q;
    logic [GradientW-1:0]     gradient_2_q;
    logic [DefW-1:0]          curve_2_q;
    logic [DeficitW-1:0]      deficit_2_q;
    assign deficit = ~power_edge >>> (CoeffF - DeficitF);
    always_ff @(posedge clk_i) begin
      if (!hold_i) begin
        sure_2_q     <= (!vertical_1_q && !horizontal_1_q) || (bends_x && bends_y) ||
                        !power_1_q[PowerW-1] || !power_x[PowerW-1] || !power_y[PowerW-1] || !power_xy[PowerW-1];
        maybe_2_q    <= (bends_x || bends_y) && deficit[PowerW-1:DeficitW] == '0;
        gradient_2_q <= GradientW'(grad_edge >>> (CoeffF - GradientF)) + GradientW'(1);
        curve_2_q    <= DefW'(0) - DefW'(curve_edge);
        deficit_2_q  <= deficit[DeficitW-1:0];
      end
    end

    // --- 3: products; then the comparison ----------------------------------------------------------------------------
    localparam int unsigned CompareW = SquareW > NeedW ? SquareW : NeedW;
    logic [SquareW-1:0] square_3_q;
    logic [NeedW-1:0]   need_3_q;
    logic               sure_3_q, maybe_3_q;
    always_ff @(posedge clk_i) begin
      if (!hold_i) begin
        sure_3_q   <= sure_2_q;
        maybe_3_q  <= maybe_2_q;
        square_3_q <= SquareW'(gradient_2_q) * SquareW'(gradient_2_q);
        need_3_q   <= NeedW'(curve_2_q) * NeedW'(deficit_2_q);
      end
    end
    assign verdict = sure_3_q || (maybe_3_q && CompareW'(square_3_q) >= CompareW'(need_3_q));
    logic unused_touches;
    assign unused_touches = touches_i;
  end else begin : gen_box
    if (pipegs_pkg::Oriented) begin : gen_oriented
      logic [2:0] touches_q;
      always_ff @(posedge clk_i) if (!hold_i) touches_q <= {touches_q[1:0], touches_i};
      assign verdict = touches_q[2];
    end else begin : gen_all
      assign verdict = 1'b1;
      logic unused_touches;
      assign unused_touches = touches_i;
    end
    logic unused_test;
    assign unused_test = &{1'b0, mean_x_i, mean_y_i, d_i, e_i, f_i, power_i, gx_i, gy_i};
  end

  logic [2:0]         valid_q, last_q;
  logic [RegionW-1:0] region_1_q, region_2_q, region_3_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= '0;
      last_q  <= '0;
    end else if (!hold_i) begin
      valid_q <= {valid_q[1:0], valid_i};
      last_q  <= {last_q[1:0], valid_i && last_i};
    end
  end
  always_ff @(posedge clk_i) begin
    if (!hold_i) begin
      region_1_q <= {row_i, column_i};
      region_2_q <= region_1_q;
      region_3_q <= region_2_q;
    end
  end

  assign keep_o   = valid_q[2] && verdict;
  assign region_o = region_3_q;
  assign last_o   = last_q[2];

endmodule
