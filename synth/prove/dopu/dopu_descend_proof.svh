// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/dopu_descend.sv in its proof: every verdict has a place in the queue of its level, and a chunk
// that is shown is not taken back.
//
// Rule    Of each level at most Results nodes are in the test or wait as results, so no queue refuses one; a node that
//         the readers or the walk show enters once, or is dropped. A chunk once shown stays, the same, until it is
//         taken, whenever its window is done; no chunk leaves unseen but one of a done window, and no end.
// Assumes Of dopu_test what free_test says, of the readers what free_line_reader says. Windows are done, and not done
//         again, at any time.
// Invariant  A place is reserved for each node in the test and each result that waits; what waits at the port is shown.

(* hierconn *) logic [7:0] \u_test.inside_q[0] ;
(* hierconn *) logic [7:0] \u_test.inside_q[1] ;
(* hierconn *) logic [7:0] \u_test.inside_q[2] ;
(* hierconn *) logic [7:0] \u_test.inside_q[3] ;
(* hierconn *) logic \u_hold.waits_q ;
logic [7:0] inside [Levels];

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(BeatW)) u_hold (
  .clk_i, .rst_ni, .valid_i(chunk_valid_o), .ready_i(chunk_ready_i), .beat_i({chunk_kind_o, chunk_set_o, chunk_o})
);
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
always_comb begin
  if (rst_ni) begin
    assert ($countones(enter) <= 1 && \u_test.inside_q[3] == '0);
    assert (shown_q == \u_hold.waits_q );
    assert (!(kept_valid[2] && kept_ready[2]) || (chunk_valid_o && chunk_ready_i) ||
            (kept[2][NodeBits +: KindW] == pipegs_pkg::KindData && set_done_i[kept[2][BeatW-1]]));
    assert (!(chunk_valid_o && chunk_ready_i) || (kept_valid[2] && kept_ready[2]));
  end
end
