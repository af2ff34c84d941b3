// SPDX-License-Identifier: Apache-2.0
// pipegs_square: the square of a signed number, in two fifths of the gates of a multiplier.
//
// Idea    x_i x_j and x_j x_i are one product of bits, with twice the weight; x_i x_i is x_i. Those with the sign bit
//         are negative, but for its own.
// Stream  Combinational.
// Model   x * x

module pipegs_square #(
  parameter int unsigned DataW = 24
) (
  input  logic signed [DataW-1:0] in_i,
  output logic [2*DataW-2:0]      out_o
);

  localparam int unsigned OutW = 2 * DataW - 1;

  logic [OutW-1:0] row, sum;
  always_comb begin
    sum = '0;
    for (int unsigned i = 0; i < DataW; i += 1) begin
      row      = '0;
      row[2*i] = in_i[i];
      for (int unsigned j = i + 1; j < DataW - 1; j += 1) row[i+j+1] = in_i[i] && in_i[j];
      sum += row;
    end
    row = '0;
    for (int unsigned j = 0; j < DataW - 1; j += 1) row[DataW+j] = in_i[DataW-1] && in_i[j];
    sum -= row;
  end
  assign out_o = sum;

endmodule
