// SPDX-License-Identifier: Apache-2.0
// pu_row_init: where row Dy of a region starts.
//
// Paper   Eq. 3, step 2 of Fig. 5a.
// Idea    P_init(dy) = power + slope_y dy + curve_y dy^2;   beta(dy) = slope_x + twist dy.
//         The first difference along the row is P(1) - P(0) = beta + curve_x. Dy is a constant: shifts and adds.
// Numbers Exact; PowerW and GradientW hold the result for any coefficients (docs/units/pu.md), so nothing wraps.
// Stream  None: combinational, between the registers of pu_region and of pu_row_unit.
// Model   cpp_model/pu/rows/pu_row_init.hpp

module pu_row_init #(
  parameter int unsigned Dy = 7
) (
  input  logic signed [pipegs_pkg::PowerW-1:0]    power_i,
  input  logic signed [pipegs_pkg::GradientW-1:0] slope_x_i,
  input  logic signed [pipegs_pkg::GradientW-1:0] slope_y_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]    curve_x_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]    curve_y_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]    twist_i,

  output logic signed [pipegs_pkg::PowerW-1:0]    power_o,  // of the row's first pixel
  output logic signed [pipegs_pkg::GradientW-1:0] slope_o   // of the next pixel minus the first
);

  localparam int unsigned PowerW    = pipegs_pkg::PowerW;
  localparam int unsigned GradientW = pipegs_pkg::GradientW;

  assign power_o = power_i + PowerW'(slope_y_i) * PowerW'(Dy) + PowerW'(curve_y_i) * PowerW'(Dy * Dy);
  assign slope_o = slope_x_i + GradientW'(twist_i) * GradientW'(Dy) + GradientW'(curve_x_i);

endmodule
