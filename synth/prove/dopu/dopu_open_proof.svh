// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/nearest/dopu_open.sv in its proof: at most Most buckets are open, and each waits its turn for the
// reader.
//
// Rule    A bucket is opened only when there is room; the number open is those opened and not settled; the nearest is
//         the smallest of them, or the largest number; no job is overwritten before the reader has it.
// Assumes A bucket is settled only while one is open (the module's own promise).

localparam int unsigned ProofW = 16;
logic [ProofW-1:0]  opened_q, settled_q;  // modulo 2^16
logic               waits_q;              // a job waits for the reader
logic [BucketW-1:0] smallest;             // of those open, one after the other
logic [ProofW-1:0]  number;               // of those open

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    opened_q  <= '0;
    settled_q <= '0;
    waits_q   <= 1'b0;
  end else begin
    opened_q  <= opened_q + ProofW'(take);
    settled_q <= settled_q + ProofW'(settled_i);
    waits_q   <= take || (waits_q && !job_ready);
  end
end

always_comb begin
  smallest = '1;
  number   = '0;
  for (int unsigned i = 0; i < Most; i += 1) begin
    if (open_q[i] && bucket_q[i] < smallest) smallest = bucket_q[i];
    number += ProofW'(open_q[i]);
  end
  assume (!settled_i || any_o);
  if (rst_ni) begin
    assert ((open_q & (open_q + 1'b1)) == '0);  // from the oldest on
    assert (number == opened_q - settled_q);
    assert (!(take && waits_q));
    assert (waits_q == job_valid_q);
    assert (any_o == (opened_q != settled_q));
    assert (nearest_o == smallest);
  end
end
