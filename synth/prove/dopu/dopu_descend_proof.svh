// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/dopu_descend.sv in its proof: every verdict has a place in the queue of its level.
//
// Rule    Of each level at most Results nodes are in the test or wait as results, so no queue refuses one; a node that
//         the readers or the walk show enters once, or is dropped.
// Assumes Of dopu_test what free_test says. A window that is done stays done while something of it is inside.
// Invariant  A place is reserved for each node in the test and each result that waits.

(* hierconn *) logic [7:0] \u_test.inside_q[0] ;
(* hierconn *) logic [7:0] \u_test.inside_q[1] ;
(* hierconn *) logic [7:0] \u_test.inside_q[2] ;
(* hierconn *) logic [7:0] \u_test.inside_q[3] ;
logic [7:0] inside [Levels];

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign inside[0] = \u_test.inside_q[0] ;
assign inside[1] = \u_test.inside_q[1] ;
assign inside[2] = \u_test.inside_q[2] ;
for (genvar l = 0; l < Levels; l += 1) begin : gen_proof
  always_comb begin
    if (rst_ni) begin
      assert (reserved_q[l] <= ReservedW'(Results));
      assert (!push[l] || queue_ready[l]);
      assert (!(enter[l] && drop[l]) && (node_valid[l] || !node_ready[l]));
      assert (9'(reserved_q[l]) == 9'(inside[l]) + 9'(gen_results[l].held));
    end
  end
end
always_comb if (rst_ni) assert ($countones(enter) <= 1 && \u_test.inside_q[3] == '0);
