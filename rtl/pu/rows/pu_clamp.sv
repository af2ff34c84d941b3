// SPDX-License-Identifier: Apache-2.0
// pu_clamp: from the power of a pixel to what its exponential is made of, and whether the pixel is visible.
//
// Paper   Eq. 1; the cut at 1/AlphaCut (255) is that of the reference renderer.
// Idea    power < -PowerCut is not visible: a compare, no exponential decides the cut. power > 0 counts as 0: rounding
//         may lift the peak just above 0, and it must not vanish.
// Stream  None: combinational.
// Model   cpp_model/pu/rows/pu_alpha.hpp

module pu_clamp (
  input  logic signed [pipegs_pkg::PowerW-1:0] power_i,    // s20.PowerF
  output pipegs_pkg::exponent_t                exponent_o
);

  localparam int unsigned PowerW = pipegs_pkg::PowerW;
  localparam int unsigned PowerF = pipegs_pkg::PowerF;

  logic positive;
  assign positive = !power_i[PowerW-1];
  // -1 - power < PowerCut
  assign exponent_o.visible  = positive | (PowerW'(~power_i) < PowerW'(pipegs_pkg::PowerCut));
  assign exponent_o.whole    = positive ? '0 : -power_i[PowerF +: pipegs_pkg::WholeW];
  assign exponent_o.fraction = positive ? '0 : power_i[PowerF-1 -: pipegs_pkg::ExpF];

endmodule
