// SPDX-License-Identifier: Apache-2.0
// pu_step: P = power - cut and its gradients at the first pixel of a region, stepped through the regions of a box.
//
// Paper   the tile test (Sec. 4.2); differences as in the Row Units (Eq. 3).
// Idea    Of every Stride-th column of regions, row by row, with x and y in regions:
//           P += 8 gx x + 64 D x^2,  gx += 16 D x,  gy += 8 F x        x = Stride
//           P += 8 gy + 64 E,        gx += 8 F,     gy += 16 E         to the next row, from the row's first region
// Stream  load_i: the first region's values; step_i: to the next one, down_i: to the first one of the next row.
// Pace    One region per cycle.
// Model   the steps of pu_intersect in cpp_model/pu/conic/pu_intersect.cpp

module pu_step #(
  parameter int unsigned Stride = 1,  // 1 or 2
  localparam int unsigned DefW   = pipegs_pkg::DefW,
  localparam int unsigned GradW  = pipegs_pkg::BcW + 1,  // gradients in the part, s13.CoeffF
  localparam int unsigned PowerW = pipegs_pkg::AW + 4    // P in the part, s20.CoeffF
) (
  input  logic                     clk_i,

  input  logic                     load_i,
  input  logic signed [PowerW-1:0] power_i,
  input  logic signed [GradW-1:0]  gx_i,
  input  logic signed [GradW-1:0]  gy_i,

  input  logic                     step_i,
  input  logic                     down_i,
  input  logic signed [DefW-1:0]   d_i,  // of the record that walks
  input  logic signed [DefW-1:0]   e_i,
  input  logic signed [DefW-1:0]   f_i,

  output logic signed [PowerW-1:0] power_o,
  output logic signed [GradW-1:0]  gx_o,
  output logic signed [GradW-1:0]  gy_o
);

  localparam int unsigned EightW = 3;                       // log2 of a region's side
  localparam int unsigned RightW = EightW + $clog2(Stride);  // of a step to the right

  logic signed [PowerW-1:0] power_q, power_row_q, power_from, power_next, rise, bend;
  logic signed [GradW-1:0]  gx_q, gy_q, gx_row_q, gy_row_q, gx_from, gy_from, gx_next, gy_next;

  // Down from the row's first region, or to the right.
  assign power_from = down_i ? power_row_q : power_q;
  assign gx_from    = down_i ? gx_row_q : gx_q;
  assign gy_from    = down_i ? gy_row_q : gy_q;
  assign rise       = down_i ? PowerW'(gy_row_q) <<< EightW : PowerW'(gx_q) <<< RightW;
  assign bend       = down_i ? PowerW'(e_i) <<< (2 * EightW) : PowerW'(d_i) <<< (2 * RightW);
  assign power_next = power_from + rise + bend;
  assign gx_next    = gx_from + (down_i ? GradW'(f_i) <<< EightW : GradW'(d_i) <<< (RightW + 1));
  assign gy_next    = gy_from + (down_i ? GradW'(e_i) <<< (EightW + 1) : GradW'(f_i) <<< RightW);

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      power_q     <= power_i;
      power_row_q <= power_i;
      gx_q        <= gx_i;
      gx_row_q    <= gx_i;
      gy_q        <= gy_i;
      gy_row_q    <= gy_i;
    end else if (step_i) begin
      power_q <= power_next;
      gx_q    <= gx_next;
      gy_q    <= gy_next;
      if (down_i) begin
        power_row_q <= power_next;
        gx_row_q    <= gx_next;
        gy_row_q    <= gy_next;
      end
    end
  end

  assign power_o = power_q;
  assign gx_o    = gx_q;
  assign gy_o    = gy_q;

endmodule
