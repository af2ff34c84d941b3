// SPDX-License-Identifier: Apache-2.0
// ru_own: the regions of a part that belong to one RU, as a mask.
//
// Idea    Two RUs own the colours of a chess board; four own every fourth region of a row, each row starting two
//         further: 2x2 regions, and four in a row, keep all of them busy. A mask is a constant for each RU. Parts are
//         multiples of that pattern, so the mask is that of every part.
// Stream  unit_i, constant. Combinational.
// Model   ru_own_mask in cpp_model/ru/ru_walk.hpp

module ru_own (
  input  logic [pipegs_pkg::UnitW-1:0]   unit_i,
  output logic [pipegs_pkg::MaskW-1:0]   own_o
);

  localparam int unsigned Units = pipegs_pkg::Units;
  localparam int unsigned RegionsX = pipegs_pkg::PartRegionsX;
  localparam int unsigned Step = Units / 2;  // from one row to the next

  for (genvar r = 0; r < pipegs_pkg::MaskW; r += 1) begin : gen_region
    localparam int unsigned Owner = (r % RegionsX + Step * (r / RegionsX)) % Units;
    assign own_o[r] = unit_i == pipegs_pkg::UnitW'(Owner);
  end

endmodule
