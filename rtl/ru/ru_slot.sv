// ru_slot: where a region lies among the regions that its RU owns.
//
// Idea    Owned regions in the order of their numbers; with powers of two that is a rearrangement of the region's bits,
//         the same for all RUs.
// Stream  region_i -> slot_o, 0 .. Regions/Units-1. Combinational.
// Model   ru_slot in cpp_model/ru/ru_walk.hpp

module ru_slot (
  input  logic [pipegs_pkg::RegionW-1:0] region_i,
  output logic [pipegs_pkg::RegionW-1:0] slot_o
);

  localparam int unsigned RegionW = pipegs_pkg::RegionW;
  localparam int unsigned ColumnW = $clog2(pipegs_pkg::RegionsX);

  if (pipegs_pkg::Units == 1) begin : gen_one
    assign slot_o = region_i;
  end else if (pipegs_pkg::Units == 2) begin : gen_two
    assign slot_o = region_i >> 1;
  end else begin : gen_four
    logic [RegionW-1:0] row, column;
    assign row    = region_i >> ColumnW;
    assign column = region_i & RegionW'(pipegs_pkg::RegionsX - 1);
    assign slot_o = ((row >> 1) << (ColumnW - 1)) | (column >> 1);
  end

endmodule
