// SPDX-License-Identifier: Apache-2.0
// pu_align: a product of mantissas shifted to CoeffF fraction bits, rounded to nearest.
//
// Paper   the coefficients of Eq. 3 in fixed point.
// Idea    aligned = floor(product * 2^(Guard - shift) + 1/2). A coefficient in range is always shifted right, so a
//         shift of 0 or less is out of range, like a result that does not fit.
// Stream  enable_i takes a product and its shift; the result stands from the next cycle to the next enable_i.
// Pace    One per cycle: shift | round and check.
// Model   cpp_model/pu/conic/pu_align.hpp

module pu_align #(
  parameter int unsigned DataW  = 66,
  parameter int unsigned Guard  = 0,
  parameter int unsigned ShiftW = 13,
  localparam int unsigned AW    = pipegs_pkg::AW
) (
  input  logic                     clk_i,

  input  logic                     enable_i,
  input  logic signed [DataW-1:0]  product_i,
  input  logic signed [ShiftW-1:0] shift_i,    // shift - 1
  output logic signed [AW-1:0]     floor_o,    // if it fits, aligned = floor_o + up_o: the sum is the user's
  output logic                     up_o,
  output logic                     fits_a_o,   // in the width of A, of B and C, of D, E and F
  output logic                     fits_bc_o,
  output logic                     fits_def_o
);

  localparam int unsigned BcW  = pipegs_pkg::BcW;
  localparam int unsigned DefW = pipegs_pkg::DefW;
  localparam int unsigned OutW = DataW + Guard;
  localparam int unsigned ByW  = 7;  // 127 shifts everything out

  logic [ByW-1:0]         by;
  logic signed [OutW-1:0] product, halves_q, floor;
  logic                   right_q;
  assign by        = shift_i[ShiftW-2:ByW] != '0 ? '1 : shift_i[ByW-1:0];
  assign product   = OutW'(product_i) <<< Guard;
  always_ff @(posedge clk_i) if (enable_i) begin
    halves_q <= product >>> by;
    right_q  <= !shift_i[ShiftW-1];
  end
  assign floor   = halves_q >>> 1;
  assign floor_o = AW'(floor);
  assign up_o    = halves_q[0];

  // It fits if all bits from the sign on are equal and rounding up does not run over.
  assign fits_a_o   = right_q && floor[OutW-1:AW-1] == {(OutW - AW + 1){floor[OutW-1]}} &&
                      !(up_o && !floor[OutW-1] && &floor[AW-2:0]);
  assign fits_bc_o  = right_q && floor[OutW-1:BcW-1] == {(OutW - BcW + 1){floor[OutW-1]}} &&
                      !(up_o && !floor[OutW-1] && &floor[BcW-2:0]);
  assign fits_def_o = right_q && floor[OutW-1:DefW-1] == {(OutW - DefW + 1){floor[OutW-1]}} &&
                      !(up_o && !floor[OutW-1] && &floor[DefW-2:0]);

endmodule
