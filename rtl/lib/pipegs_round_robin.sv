// SPDX-License-Identifier: Apache-2.0
// pipegs_round_robin: whose turn it is: the first one of a mask behind the last, else the first of all.
//
// Stream  mask_i, last_i -> choice_o (0 for an empty mask). Combinational.
// Model   The loops in the tests of arbiter and dopu.

module pipegs_round_robin #(
  parameter int unsigned Ports = 4,
  localparam int unsigned PortW = Ports > 1 ? $clog2(Ports) : 1
) (
  input  logic [Ports-1:0] mask_i,
  input  logic [PortW-1:0] last_i,   // whose turn it was
  output logic [PortW-1:0] choice_o
);

  logic [Ports-1:0] behind;
  logic [PortW-1:0] first, first_behind;

  always_comb begin
    for (int unsigned i = 0; i < Ports; i += 1) behind[i] = mask_i[i] && PortW'(i) > last_i;
  end
  pipegs_first_set #(.DataW(Ports)) u_first (
    .mask_i,
    .one_hot_o(),
    .number_o(first)
  );
  pipegs_first_set #(.DataW(Ports)) u_behind (
    .mask_i(behind),
    .one_hot_o(),
    .number_o(first_behind)
  );
  assign choice_o = behind != '0 ? first_behind : first;

endmodule
