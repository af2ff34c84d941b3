// SPDX-License-Identifier: Apache-2.0
// free_test: stands for rtl/dopu/dopu_test.sv: any verdict at any time, one for each node that entered.
//
// Idea    Known of the real one: it is a pipeline, so a verdict carries the tag of a node inside. Nodes inside are
//         counted by the level in the top of their tag.

module dopu_test #(
  parameter int unsigned TagW = 4,
  parameter int unsigned Phase = 0,
  localparam int unsigned DistanceW = 2 * pipegs_pkg::TestW + 2
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  awake_i,  // the unit's clock does not stand, or would not

  input  pipegs_pkg::position_t                 position_i,
  input  logic [pipegs_pkg::WorldW-1:0]         near_plane_i,
  input  logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_i,

  input  logic                                  node_valid_i,
  output logic                                  node_ready_o,
  input  pipegs_pkg::node_t                     node_i,
  input  logic                                  set_i,
  input  logic                                  tight_i,
  input  logic [pipegs_pkg::ScaleW-1:0]         scale_i,
  input  logic [TagW-1:0]                       tag_i,

  output logic                                  result_valid_o,
  output logic                                  result_pass_o,
  output pipegs_pkg::node_t                     result_node_o,
  output logic [TagW-1:0]                       result_tag_o,
  output logic signed [DistanceW-1:0]            result_nearest_o,
  output logic signed [DistanceW-1:0]            result_farthest_o,
  output logic [pipegs_pkg::ExpW-1:0]           result_exponent_o
);

  (* anyseq *) logic ready, valid, pass;
  (* anyseq *) logic [pipegs_pkg::NodeBits-1:0] node;
  (* anyseq *) logic [TagW-1:0] tag;
  (* anyseq *) logic [DistanceW-1:0] nearest, farthest;
  (* anyseq *) logic [pipegs_pkg::ExpW-1:0] exponent;
  logic [7:0] inside_q [4];
  logic [1:0] enters, leaves;  // the levels

  assign node_ready_o      = ready;
  assign result_valid_o    = valid;
  assign result_pass_o     = pass;
  assign result_node_o     = node;
  assign result_tag_o      = tag;
  assign result_nearest_o  = nearest;
  assign result_farthest_o = farthest;
  assign result_exponent_o = exponent;
  assign enters            = tag_i[TagW-1 -: 2];
  assign leaves            = tag[TagW-1 -: 2];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      for (int unsigned l = 0; l < 4; l += 1) inside_q[l] <= '0;
    end else begin
      for (int unsigned l = 0; l < 4; l += 1) begin
        inside_q[l] <= inside_q[l] + 8'(node_valid_i && ready && enters == 2'(l)) - 8'(valid && leaves == 2'(l));
      end
    end
  end
  always_comb assume (!rst_ni || !valid || inside_q[leaves] != '0);

  logic unused;
  assign unused = &{1'b0, position_i, near_plane_i, planes_i, node_i, set_i, tag_i};

endmodule
