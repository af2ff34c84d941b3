// ru_own: the regions of a window that belong to one RU, as a mask.
//
// Idea    Regions are dealt to the RUs like the squares of a chess board: one RU owns all, two own the squares of one
//         colour each, four own one square of each block of 2x2. A mask is two constants and a few gates.
// Stream  unit_i, constant. Combinational.
// Model   ru_own_mask in cpp_model/ru/ru_walk.hpp

module ru_own (
  input  logic [pipegs_pkg::UnitW-1:0]   unit_i,
  output logic [pipegs_pkg::Regions-1:0] own_o
);

  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned RegionsX = pipegs_pkg::RegionsX;
  localparam logic [Regions-1:0] OddX = {(Regions / 2){2'b10}};
  localparam logic [Regions-1:0] OddY = {(RegionsX / 2){{RegionsX{1'b1}}, {RegionsX{1'b0}}}};

  if (pipegs_pkg::Units == 1) begin : gen_one
    assign own_o = '1;
    logic unused_unit;
    assign unused_unit = &{1'b0, unit_i};
  end else if (pipegs_pkg::Units == 2) begin : gen_two
    assign own_o = unit_i[0] ? OddX ^ OddY : ~(OddX ^ OddY);
    logic unused_unit;
    assign unused_unit = &{1'b0, unit_i};
  end else begin : gen_four
    assign own_o = (unit_i[0] ? OddX : ~OddX) & (unit_i[1] ? OddY : ~OddY);
  end

endmodule
