// SPDX-License-Identifier: Apache-2.0
// The end of rtl/mem/pipegs_axi_fence.sv in its proof: no read leaves before the writes that it must see are answered.
//
// Rule    Of the read that the queue remembers the writes are counted that were unanswered when it was accepted; it
//         leaves when all of these are answered, unchanged. A read that passes must see none, or none is unanswered and
//         no other waits. What is shown stays, if its giver keeps it. In is accepted or shown at the output, never both
//         lost: a read that passes is taken exactly when the output is, others exactly when the queue has room.
// Assumes The number of writes is that of those accepted and not answered, at most Writes; no write is accepted in the
//         cycle of a read. Both are proven in `axi_manager`. The core may withdraw a read.
// Invariant  While some of its writes are unanswered, the writes accepted since its stamp are the others.

(* anyseq *) logic answered;  // one of the writes
(* hierconn *) logic [StampW+DataW-1:0] \u_waiting.word_q ;
(* hierconn *) logic \u_waiting.tracked_q ;
(* hierconn *) logic \u_waiting.picks ;
(* hierconn *) logic \u_waiting.heads ;
logic [WritesW-1:0] open_q, left_q;  // unanswered; of these, ahead of the remembered read
logic [DataW-1:0]   read_q, in_q, out_q;
logic [StampW-1:0]  younger;
logic               passed_q, waited_q, fenced_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    open_q   <= '0;
    passed_q <= 1'b0;
    waited_q <= 1'b0;
  end else begin
    open_q   <= open_q + WritesW'(write_i) - WritesW'(answered);
    passed_q <= out_valid_o && !out_ready_i && !due;
    waited_q <= out_valid_o && !out_ready_i && due;
  end
end
always_ff @(posedge clk_i) begin
  in_q     <= in_i;
  fenced_q <= in_fenced_i;
  out_q    <= out_o;
  if (\u_waiting.picks ) begin
    left_q <= open_q - WritesW'(answered);
    read_q <= in_i;
  end else if (answered && left_q != '0) left_q <= left_q - 1'b1;
end

assign younger = stamp_q - \u_waiting.word_q [StampW+DataW-1:DataW];
always_comb begin
  assume (writes_i == open_q);
  assume (!answered || open_q != '0);
  assume (!write_i || open_q < WritesW'(Writes));
  assume (!(write_i && in_valid_i));
  if (rst_ni) begin
    assert (!(out_valid_o && due && \u_waiting.heads ) || (left_q == '0 && out_o == read_q));
    assert (!(out_valid_o && !due) || (in_valid_i && out_o == in_i));
    assert (!(out_valid_o && !due && in_fenced_i) || (writes_i == '0 && waiting == '0));
    assert (!(in_valid_i && in_ready_o) || (out_valid_o && out_ready_i && !due) || !passes);
    assert (!waited_q || (out_valid_o && out_o == out_q));
    assert (!(passed_q && in_valid_i && in_i == in_q && in_fenced_i == fenced_q) || (out_valid_o && out_o == out_q));
    // invariants
    assert (open_q <= WritesW'(Writes));
    assert (passed_q == passing_q && waited_q == leaving_q);
    assert (!(passed_q && fenced_q) || (writes_i == '0 && waiting == '0));
    assert (!\u_waiting.tracked_q || left_q == '0 ||
            (left_q <= open_q && younger == StampW'(open_q) - StampW'(left_q)));
    assert (!(waited_q && \u_waiting.heads ) || left_q == '0);
    assert (!\u_waiting.tracked_q || \u_waiting.word_q [DataW-1:0] == read_q);
  end
end
