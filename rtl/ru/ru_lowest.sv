// ru_lowest: the lowest set bit of a mask of regions.
//
// Idea    x & -x leaves the lowest bit; bit i of its number says in which half of the numbers it lies.
//           number[0]: ..1010   number[1]: ..1100   number[2]: ..11110000
// Stream  mask_i -> the bit alone and its number (0 for an empty mask). Combinational.
// Model   std::countr_zero

module ru_lowest (
  input  logic [pipegs_pkg::Regions-1:0] mask_i,
  output logic [pipegs_pkg::Regions-1:0] one_hot_o,
  output logic [pipegs_pkg::RegionW-1:0] number_o
);

  localparam int unsigned Regions = pipegs_pkg::Regions;

  assign one_hot_o = mask_i & (~mask_i + 1'b1);

  for (genvar i = 0; i < pipegs_pkg::RegionW; i += 1) begin : gen_bit
    localparam logic [Regions-1:0] Half = {(Regions >> (i + 1)){{(1 << i){1'b1}}, {(1 << i){1'b0}}}};
    assign number_o[i] = (one_hot_o & Half) != '0;
  end

endmodule
