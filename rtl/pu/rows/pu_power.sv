// SPDX-License-Identifier: Apache-2.0
// pu_power: one row of a region by the full quadratic form: what differential power computation (Eq. 3) replaces.
//
// Paper   Eq. 1, "the original per-pixel power computation requires 7 multiplications and 4 additions".
// Idea    Every pixel by itself, from its offset (x, Dy) to the region's first pixel:
//           power + slope_x x + slope_y Dy + curve_x x x + curve_y Dy Dy + twist x Dy
//         Offsets from the region instead of from the mean change no count, and give the bits of pu_row_init and
//         pu_row_unit.
// Stream  load_i takes a region; power_o holds PixelsPerRow pixels, the next ones after each step_i.
// Pace    PixelsPerRow pixels per cycle: eight multiplications and five additions each.
// Model   cpp_model/pu/rows/pu_row_init.hpp, pu_row_unit.hpp: the same numbers, exactly

module pu_power #(
  parameter int unsigned Dy = 7
) (
  input  logic                                    clk_i,

  input  logic                                    load_i,
  input  logic signed [pipegs_pkg::PowerW-1:0]    power_i,
  input  logic signed [pipegs_pkg::GradientW-1:0] slope_x_i,
  input  logic signed [pipegs_pkg::GradientW-1:0] slope_y_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]    curve_x_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]    curve_y_i,
  input  logic signed [pipegs_pkg::CurveW-1:0]    twist_i,
  input  logic                                    step_i,
  output logic [pipegs_pkg::PixelsPerRow*pipegs_pkg::PowerW-1:0] power_o
);

  localparam int unsigned PowerW = pipegs_pkg::PowerW;
  localparam int unsigned Pixels = pipegs_pkg::PixelsPerRow;
  localparam int unsigned ColumnW = 3;
  localparam logic signed [PowerW-1:0] Y = PowerW'(Dy);

  logic signed [PowerW-1:0] power_q, slope_x_q, slope_y_q, curve_x_q, curve_y_q, twist_q;
  logic [ColumnW-1:0]       column_q;  // of the first pixel at the output

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      power_q   <= power_i;
      slope_x_q <= PowerW'(slope_x_i);
      slope_y_q <= PowerW'(slope_y_i);
      curve_x_q <= PowerW'(curve_x_i);
      curve_y_q <= PowerW'(curve_y_i);
      twist_q   <= PowerW'(twist_i);
      column_q  <= '0;
    end else if (step_i) begin
      column_q <= column_q + ColumnW'(Pixels);
    end
  end

  for (genvar i = 0; i < Pixels; i += 1) begin : gen_pixel
    logic signed [PowerW-1:0] x;
    assign x = PowerW'({1'b0, column_q | ColumnW'(i)});  // column_q is a multiple of Pixels
    assign power_o[i*PowerW +: PowerW] =
      power_q + slope_x_q * x + slope_y_q * Y + curve_x_q * (x * x) + curve_y_q * Y * Y + twist_q * x * Y;
  end

endmodule
