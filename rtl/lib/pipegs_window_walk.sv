// SPDX-License-Identifier: Apache-2.0
// pipegs_window_walk: the windows of a frame one after the other, row by row.
//
// Stream  start_i: the first window. advance_i: the next one.
// Pace    New values in the cycle after the pulse; next_*: what they become with it.
// Model   The loops over windows in cpp_model/golden.cpp.

module pipegs_window_walk (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic [pipegs_pkg::WindowW-1:0] first_x_i,
  input  logic [pipegs_pkg::WindowW-1:0] first_y_i,
  input  logic [pipegs_pkg::WindowW-1:0] last_x_i,

  input  logic                           start_i,
  input  logic                           advance_i,

  output logic [pipegs_pkg::WindowW-1:0] x_o,
  output logic [pipegs_pkg::WindowW-1:0] y_o,
  output logic [pipegs_pkg::WindowW-1:0] next_x_o,
  output logic [pipegs_pkg::WindowW-1:0] next_y_o,
  output logic                           row_ends_o  // the window is the last of its row
);

  assign row_ends_o = x_o == last_x_i;
  assign next_x_o   = start_i || row_ends_o ? first_x_i : x_o + 1'b1;
  assign next_y_o   = start_i ? first_y_i : row_ends_o ? y_o + 1'b1 : y_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      x_o <= '0;
      y_o <= '0;
    end else if (start_i || advance_i) begin
      x_o <= next_x_o;
      y_o <= next_y_o;
    end
  end

endmodule
