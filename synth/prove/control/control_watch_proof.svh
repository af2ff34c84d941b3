// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_watch.sv in its proof: silence is told when it has lasted, never before.
//
// Rule    run_q counts the cycles in a row in which something is owed and nothing moves, since they began or since it
//         was told; limit_q is what limit_i was then. It is told in the cycle behind the last of limit_q cycles, and
//         never else. silent_o is up from then on while they go on.

logic [32:0] run_q;
logic [31:0] limit_q;
logic        told_q, silence_q, quiet, ends;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign quiet = waits_i && !moves_i && limit_i != '0;
assign ends  = quiet && limit_q != '0 && run_q + 33'd1 == {1'b0, limit_q};
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    run_q     <= '0;
    limit_q   <= '0;
    told_q    <= 1'b0;
    silence_q <= 1'b0;
  end else begin
    told_q    <= ends;
    silence_q <= quiet && (silence_q || ends);
    if (!quiet || limit_q == '0 || ends) begin
      run_q   <= '0;
      limit_q <= limit_i;
    end else begin
      run_q <= run_q + 33'd1;
    end
  end
end

always_comb begin
  if (rst_ni) begin
    assert (tell_o == told_q && silent_o == silence_q);
    assert (!tell_o || silent_o);
    // invariants
    assert (run_q + {1'b0, left_q} == {1'b0, limit_q});
    assert (run_q == '0 || run_q < {1'b0, limit_q});
    assert (limit_q == '0 || left_q != '0);
  end
end
