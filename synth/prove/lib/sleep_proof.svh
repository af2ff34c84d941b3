// SPDX-License-Identifier: Apache-2.0
// The end of rtl/lib/pipegs_sleep.sv in its proof: asleep after Patience quiet cycles, awake with the first event.
//
// Rule    The counter stops at Patience; asleep only if nothing happened in the last Patience cycles nor in this one.

logic [CountW-1:0] since_q;  // cycles since the last event, at most Patience

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) since_q <= '0;
  else since_q <= moved_i || wake_i ? '0 : since_q == CountW'(Patience) ? since_q : since_q + 1'b1;
end
always_comb begin
  if (rst_ni) begin
    assert (quiet_q <= CountW'(Patience));
    assert (asleep_o == (since_q == CountW'(Patience) && !wake_i));
    assert (quiet_q == since_q);
  end
end
