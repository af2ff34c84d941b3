// SPDX-License-Identifier: Apache-2.0
// pipegs_saturate: a signed number in fewer bits: as it is when it fits, else the nearest number that does.
//
// Idea    It fits when all bits from the new sign on are equal. If not, the old sign tells which end is nearest.
// Stream  Combinational.
// Model   saturate() in cpp_model/fixed.hpp

module pipegs_saturate #(
  parameter int unsigned InW  = 32,  // more than OutW
  parameter int unsigned OutW = 16
) (
  input  logic signed [InW-1:0]  in_i,
  output logic signed [OutW-1:0] out_o
);

  assign out_o = in_i[InW-1:OutW-1] == {(InW - OutW + 1){in_i[InW-1]}} ? in_i[OutW-1:0] :
                 {in_i[InW-1], {(OutW - 1){!in_i[InW-1]}}};

endmodule
