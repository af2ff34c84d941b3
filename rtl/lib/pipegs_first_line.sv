// SPDX-License-Identifier: Apache-2.0
// pipegs_first_line: of several that may each name a line of memory, the line of the lowest one that does.
//
// Idea    A part that finds something wrong says so, with the line of memory that it concerns, and goes on saying it.
//         This joins what several parts say into one.
// Stream  valid and line of each port in; whether any is valid, and the line of the lowest valid one, out.
// Pace    Combinational.
// Model   A loop in the test.

module pipegs_first_line #(
  parameter int unsigned Ports = 2,
  localparam int unsigned AddressW = pipegs_pkg::AddressW
) (
  input  logic [Ports-1:0]          valid_i,
  input  logic [Ports*AddressW-1:0] line_i,
  output logic                      valid_o,
  output logic [AddressW-1:0]       line_o
);

  always_comb begin
    line_o = '0;
    for (int unsigned i = Ports; i > 0; i -= 1) if (valid_i[i-1]) line_o = line_i[(i-1)*AddressW +: AddressW];
  end
  assign valid_o = valid_i != '0;

endmodule
