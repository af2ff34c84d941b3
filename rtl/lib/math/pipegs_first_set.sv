// SPDX-License-Identifier: Apache-2.0
// pipegs_first_set: the lowest set bit of a mask.
//
// Idea    x & -x leaves the lowest bit; bit i of its number says in which half of the numbers it lies.
//           number[0]: ..1010   number[1]: ..1100   number[2]: ..11110000
// Stream  mask_i -> the bit alone and its number (both 0 for an empty mask). Combinational.
// Model   std::countr_zero

module pipegs_first_set #(
  parameter int unsigned DataW = 64,
  localparam int unsigned NumberW = DataW > 1 ? $clog2(DataW) : 1
) (
  input  logic [DataW-1:0]   mask_i,
  output logic [DataW-1:0]   one_hot_o,
  output logic [NumberW-1:0] number_o
);

  localparam int unsigned WholeW = 2 ** NumberW;

  assign one_hot_o = mask_i & (~mask_i + 1'b1);

  for (genvar i = 0; i < NumberW; i += 1) begin : gen_bit
    localparam logic [WholeW-1:0] Half = {(WholeW >> (i + 1)){{(1 << i){1'b1}}, {(1 << i){1'b0}}}};
    assign number_o[i] = (one_hot_o & Half[DataW-1:0]) != '0;
  end

endmodule
