// SPDX-License-Identifier: Apache-2.0
// dopu_axis: the principal axis of the view, along which the layers are stacked.
//
// Paper   Sec. 3.2, Sec. 4.1.
// Idea    The axis along which the camera's forward vector (third row of the rotation) is longest; ties: lowest axis.
// Stream  None: the frame's constants in, 0, 1 or 2 for x, y or z out.
// Pace    Combinational.
// Model   cpp_model/dopu/dopu_axis.hpp

module dopu_axis (
  input  logic signed [pipegs_pkg::RotW-1:0] forward_x_i,  // s1.24
  input  logic signed [pipegs_pkg::RotW-1:0] forward_y_i,
  input  logic signed [pipegs_pkg::RotW-1:0] forward_z_i,
  output logic        [1:0]                  axis_o
);

  localparam int unsigned RotW = pipegs_pkg::RotW;
  logic [RotW-1:0] x, y, z;  // magnitudes

  assign x = forward_x_i[RotW-1] ? -forward_x_i : forward_x_i;
  assign y = forward_y_i[RotW-1] ? -forward_y_i : forward_y_i;
  assign z = forward_z_i[RotW-1] ? -forward_z_i : forward_z_i;
  assign axis_o = x >= y && x >= z ? 2'd0 : y >= z ? 2'd1 : 2'd2;

endmodule
