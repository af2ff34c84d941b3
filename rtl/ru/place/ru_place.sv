// SPDX-License-Identifier: Apache-2.0
// ru_place: column and row of a region in its window, in regions.
//
// Idea    A region's number is {eye, row of the square, column of the square, row in the square, column in the square};
//         a window of one square has only the last two, and one eye has no number.
// Stream  region_i -> column_o, row_o. Combinational.
// Model   region_x, region_y in cpp_model/regions.hpp

module ru_place #(
  localparam int unsigned PlaceW = pipegs_pkg::PlacesW
) (
  input  logic [pipegs_pkg::RegionW-1:0] region_i,
  output logic [PlaceW-1:0]              column_o,
  output logic [PlaceW-1:0]              row_o
);

  localparam int unsigned InPartW = pipegs_pkg::MaskIndexW / 2;

  if (pipegs_pkg::Squares > 1) begin : gen_squares
    localparam int unsigned SquareW = pipegs_pkg::SquareW / 2;
    logic [SquareW-1:0] square_column, square_row;
    logic [InPartW-1:0] column, row;
    assign {square_row, square_column, row, column} = region_i[2*PlaceW-1:0];
    assign column_o = {square_column, column};
    assign row_o    = {square_row, row};
  end else begin : gen_whole
    assign {row_o, column_o} = region_i[2*PlaceW-1:0];
  end
  logic unused_eye;
  assign unused_eye = ^region_i;

endmodule
