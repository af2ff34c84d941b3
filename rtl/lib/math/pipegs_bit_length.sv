// SPDX-License-Identifier: Apache-2.0
// pipegs_bit_length: how many bits a number needs: the place of its highest set bit, counted from 1.
//
// Stream  in_i -> length_o, 0 for 0. Combinational.
// Model   std::bit_width

module pipegs_bit_length #(
  parameter int unsigned DataW = 32,
  localparam int unsigned LengthW = $clog2(DataW + 1)
) (
  input  logic [DataW-1:0]   in_i,
  output logic [LengthW-1:0] length_o
);

  always_comb begin
    length_o = '0;
    for (int unsigned i = 0; i < DataW; i += 1) if (in_i[i]) length_o = LengthW'(i + 1);
  end

endmodule
