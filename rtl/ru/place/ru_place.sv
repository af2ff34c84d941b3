// SPDX-License-Identifier: Apache-2.0
// ru_place: column and row of a region in its window, in regions.
//
// Idea    A region's number is {row of the part, column of the part, row in the part, column in the part}; a window of
//         one part has only the last two.
// Stream  region_i -> column_o, row_o. Combinational.
// Model   region_x, region_y in cpp_model/regions.hpp

module ru_place #(
  localparam int unsigned PlaceW = pipegs_pkg::RegionW / 2
) (
  input  logic [pipegs_pkg::RegionW-1:0] region_i,
  output logic [PlaceW-1:0]              column_o,
  output logic [PlaceW-1:0]              row_o
);

  localparam int unsigned InPartW = pipegs_pkg::MaskIndexW / 2;

  if (pipegs_pkg::Parts > 1) begin : gen_parts
    localparam int unsigned PartW = pipegs_pkg::PartW / 2;
    logic [PartW-1:0]   part_column, part_row;
    logic [InPartW-1:0] column, row;
    assign {part_row, part_column, row, column} = region_i;
    assign column_o = {part_column, column};
    assign row_o    = {part_row, row};
  end else begin : gen_whole
    assign {row_o, column_o} = region_i;
  end

endmodule
