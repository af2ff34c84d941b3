// SPDX-License-Identifier: Apache-2.0
// pipegs_normalize: shifts a signed number left until its two top bits differ.
//
// Idea    The copies of the sign below it are removed in powers of two, the largest first: shift by 16 if the 17 top
//         bits agree, then by 8 if the 9 top bits agree, ...
// Stream  Combinational. out_o = in_i 2^shift_o, shift_o 0 to DataW - 1; zero stays zero, with the largest shift.
// Model   cpp_model/lib/math/normalize.hpp

module pipegs_normalize #(
  parameter int unsigned DataW = 28,
  localparam int unsigned ShiftW = $clog2(DataW)
) (
  input  logic signed [DataW-1:0]  in_i,
  output logic signed [DataW-1:0]  out_o,
  output logic        [ShiftW-1:0] shift_o
);

  logic signed [DataW-1:0]  value, top;
  logic        [ShiftW-1:0] shift;
  always_comb begin
    value = in_i;
    shift = '0;
    for (int unsigned i = ShiftW; i > 0; i -= 1) begin
      top = value >>> (DataW - 1 - (32'd1 << (i - 1)));
      // Only zero could be shifted too far.
      if (top == {DataW{value[DataW-1]}} && 32'(shift) + (32'd1 << (i - 1)) < DataW) begin
        value = value <<< (32'd1 << (i - 1));
        shift[i-1] = 1'b1;
      end
    end
  end
  assign out_o   = value;
  assign shift_o = shift;

endmodule
