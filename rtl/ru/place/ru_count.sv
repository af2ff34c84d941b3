// SPDX-License-Identifier: Apache-2.0
// ru_count: the number of set bits in a mask of regions.
//
// Idea    Neighbouring bits are added, then neighbouring pairs, then fours, ... inside one vector.
// Stream  mask_i -> count_o. Combinational.
// Model   std::popcount

module ru_count (
  input  logic [pipegs_pkg::Regions-1:0] mask_i,
  output logic [pipegs_pkg::RegionW:0]   count_o
);

  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned RegionW = pipegs_pkg::RegionW;

  for (genvar i = 0; i < RegionW; i += 1) begin : gen_level
    localparam logic [Regions-1:0] Low = {(Regions >> (i + 1)){{(1 << i){1'b0}}, {(1 << i){1'b1}}}};
    logic [Regions-1:0] fields, sums;  // fields of 2^i bits, each the count of its own bits; sums of two neighbours
    if (i == 0) begin : gen_first
      assign fields = mask_i;
    end else begin : gen_next
      assign fields = gen_level[i-1].sums;
    end
    assign sums = (fields & Low) + ((fields >> (1 << i)) & Low);
  end
  assign count_o = gen_level[RegionW-1].sums[RegionW:0];

  logic unused_high;
  assign unused_high = &{1'b0, gen_level[RegionW-1].sums[Regions-1:RegionW+1]};

endmodule
