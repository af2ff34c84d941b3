// SPDX-License-Identifier: Apache-2.0
// ru_offset: where a word of pixels, two rows of a region, lies in its window's part of external memory.
//
// Paper   None: it says nothing of how pixels leave.
// Idea    By windows the regions follow one another, so a word's place is its number. In raster order a row of the
//         picture has stride lines, and a row of a region is half of one of them; words and rows below the picture are
//         left out, for what follows the picture in memory is not ours.
// Stream  A region and which of its four words -> lines from the window's first one, and what of the word is written.
//         Combinational.
// Model   ru_pixel_line in cpp_model/ru/ru_resolve.hpp, ru_raster_line in cpp_model/ru/ru_raster.hpp

module ru_offset #(
  localparam int unsigned PlaceW  = pipegs_pkg::PlacesW,
  localparam int unsigned StrideW = pipegs_pkg::StrideW,
  localparam int unsigned RowW    = PlaceW + 3,  // of a window's rows
  localparam int unsigned OffsetW = StrideW + RowW
) (
  input  logic                                 raster_i,   // else by windows
  input  logic [StrideW-1:0]                   stride_i,   // lines
  input  logic [$clog2(pipegs_pkg::Window):0]  columns_i,  // pixel columns and rows of the window inside the image
  input  logic [$clog2(pipegs_pkg::Window):0]  rows_i,
  input  logic [pipegs_pkg::RegionW-1:0]       region_i,   // it, or the one with which it shares lines, is inside
  input  logic [1:0]                           quarter_i,

  output logic [OffsetW-1:0]                   offset_o,   // of the first row
  output logic                                 half_o,     // a row's half of its line, in raster order
  output logic                                 wide_o,     // the other half of the line is in the picture, too
  output logic                                 shown_o,    // the word is written
  output logic                                 two_o,      // in two requests, else in one
  output logic                                 more_o      // so is the next word of the region, if there is one
);

  localparam int unsigned SideW  = $clog2(pipegs_pkg::Window) + 1;
  localparam int unsigned Double = pipegs_pkg::PixelW == 64 ? 1 : 0;  // by windows: a word is two lines

  logic [PlaceW-1:0] column, region_row, pair;  // pair: of regions that share lines
  logic [RowW-1:0]   row;
  logic [SideW:0]    rows, first, right;  // right: first column of the right one of the two regions

  ru_place u_place (
    .region_i,
    .column_o(column),
    .row_o(region_row)
  );
  assign pair  = column >> 1;
  assign row   = {region_row, quarter_i, 1'b0};
  assign rows  = {1'b0, rows_i};
  assign first = (SideW + 1)'(row);
  assign right = (SideW + 1)'({pair, 4'd8});

  always_comb begin
    if (raster_i) begin
      offset_o = OffsetW'(row) * OffsetW'(stride_i) + OffsetW'(pair);
      half_o   = column[0];
      wide_o   = right < {1'b0, columns_i};
      shown_o  = first < rows;
      two_o    = first + 1'b1 < rows;
      more_o   = first + (SideW + 1)'(2) < rows;
    end else begin
      offset_o = OffsetW'({region_i[2*PlaceW-1:0], quarter_i}) << Double;  // of an eye's picture
      half_o   = 1'b0;
      wide_o   = 1'b0;
      shown_o  = 1'b1;
      two_o    = Double != 0;
      more_o   = 1'b1;
    end
  end

endmodule
