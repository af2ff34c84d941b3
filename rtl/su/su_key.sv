// SPDX-License-Identifier: Apache-2.0
// su_key: the sort key of a splat: depth, then index, then the part of the window.
//
// Idea    Fields that a machine has no use for are not there: no index without IndexTies, no part in a window of one.
// Stream  splat -> key. Combinational.
// Model   splat_key in cpp_model/su/su.hpp

module su_key (
  input  pipegs_pkg::splat_t          splat_i,
  output logic [pipegs_pkg::KeyW-1:0] key_o
);

  logic [pipegs_pkg::KeyW-pipegs_pkg::PartW-1:0] order;
  if (pipegs_pkg::IndexTies == 1) begin : gen_ties
    assign order = {splat_i.depth, splat_i.index};
  end else begin : gen_depth
    assign order = splat_i.depth;
  end
  if (pipegs_pkg::Parts > 1) begin : gen_part
    assign key_o = {order, splat_i.part};
  end else begin : gen_whole
    assign key_o = order;
  end

  logic unused;
  assign unused = &{1'b0, splat_i};

endmodule
