// SPDX-License-Identifier: Apache-2.0
// The end of rtl/lib/pipegs_skid.sv in its proof: a queue of two that is never refused while a place is free.
//
// Rule    proof_stream; ready exactly while fewer than two beats are inside, valid exactly while one is.
// Invariant  The beat ahead is in out_q, the other one in spare_q.

(* anyseq *) logic pick;
logic              tracked;  // by u_proof, see proof_stream
logic [1:0]        ahead, held;
logic              kept_bit;
logic [(DataW > 1 ? $clog2(DataW) : 1)-1:0] bit_place;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_stream #(.DataW(DataW), .Capacity(2)) u_proof (
  .clk_i, .rst_ni, .in_valid_i, .in_ready_i(in_ready_o), .in_i, .out_valid_i(out_valid_o), .out_ready_i, .out_i(out_o),
  .pick_i(pick), .tracked_o(tracked), .ahead_o(ahead), .place_o(bit_place), .bit_o(kept_bit), .held_o(held)
);

always_comb begin
  if (rst_ni) begin
    assert (in_ready_o == (held != 2'd2));
    assert (out_valid_o == (held != 2'd0));
    assert (!tracked || kept_bit == (ahead == 2'd0 ? out_q[bit_place] : spare_q[bit_place]));
  end
end
