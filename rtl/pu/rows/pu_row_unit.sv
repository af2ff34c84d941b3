// SPDX-License-Identifier: Apache-2.0
// pu_row_unit: walks one row of a region and gives the power of PixelsPerRow pixels per cycle.
//
// Paper   Eq. 3, step 3 of Fig. 5a.
// Idea    The power is quadratic along the row, so its second difference is constant:
//           power += slope;  slope += 2 curve          two adders per pixel, no multiplier
//         Two pixels at once: the odd one is power + slope, and both steps are taken together:
//           power += 2 slope + 2 curve;  slope += 4 curve
// Stream  load_i: the first pixel of a row; step_i: on to the next pixel (pair). power_o: pixel dx in the low bits.
// Pace    PixelsPerRow pixels per cycle; exact, so both forms give the same bits.
// Model   cpp_model/pu/rows/pu_row_unit.hpp

module pu_row_unit (
  input  logic                                                      clk_i,

  input  logic                                                      load_i,
  input  logic signed [pipegs_pkg::PowerW-1:0]                      power_i,
  input  logic signed [pipegs_pkg::GradientW-1:0]                   slope_i,
  input  logic                                                      step_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]                      curve_i,  // of the row that is walked
  output logic [pipegs_pkg::PixelsPerRow*pipegs_pkg::PowerW-1:0]    power_o
);

  localparam int unsigned PowerW    = pipegs_pkg::PowerW;
  localparam int unsigned GradientW = pipegs_pkg::GradientW;

  logic signed [PowerW-1:0]    power_q, power_next;
  logic signed [GradientW-1:0] slope_q, slope_next;

  if (pipegs_pkg::PixelsPerRow == 1) begin : gen_one
    assign power_next = power_q + PowerW'(slope_q);
    assign slope_next = slope_q + (GradientW'(curve_i) <<< 1);
    assign power_o    = power_q;
  end else begin : gen_two
    assign power_next = power_q + (PowerW'(slope_q) <<< 1) + (PowerW'(curve_i) <<< 1);
    assign slope_next = slope_q + (GradientW'(curve_i) <<< 2);
    assign power_o    = {power_q + PowerW'(slope_q), power_q};
  end

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      power_q <= power_i;
      slope_q <= slope_i;
    end else if (step_i) begin
      power_q <= power_next;
      slope_q <= slope_next;
    end
  end

endmodule
