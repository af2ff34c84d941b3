// SPDX-License-Identifier: Apache-2.0
// The end of rtl/lib/pipegs_arbiter.sv in its proof: one grant at most, to a request; a shown grant stays; and
// fairness.
//
// Rule    While port `who` asks, no other port is granted (and uses it) twice, so at most Ports - 1 others go first.
//         Both ports are the solver's choice. A request may also be withdrawn; a shown grant stays while it is not.
// Invariant  distance(p): ports between p and `who` on the way round. Each grant that passes `who` brings the last port
//         nearer to it, and a shown grant lies on that way, unless `who` came after it was shown.

localparam int unsigned ProofW = $clog2(2 * Ports + 1);
(* anyconst *) logic [PortW-1:0] who;
(* anyconst *) logic [PortW-1:0] other;
logic              used, stalled_q, passed_q;  // passed_q: `other` was granted while `who` waits
logic [Ports-1:0]  grant_q;
logic [ProofW-1:0] waits_q;                  // grants that passed `who`

function automatic logic [ProofW-1:0] proof_distance(input logic [PortW-1:0] from, input logic [PortW-1:0] target);
  proof_distance = target > from ? ProofW'(target) - ProofW'(from) - 1'b1
                                 : ProofW'(Ports) + ProofW'(target) - ProofW'(from) - 1'b1;
endfunction

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign used = advance_i && request_i != '0;

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    stalled_q  <= 1'b0;
    passed_q <= 1'b0;
    waits_q  <= '0;
  end else begin
    stalled_q <= request_i != '0 && !advance_i;
    if (!request_i[who] || (used && grant_o[who])) begin
      passed_q <= 1'b0;
      waits_q  <= '0;
    end else if (used) begin
      passed_q <= passed_q || grant_o[other];
      waits_q  <= waits_q + 1'b1;
    end
  end
end
always_ff @(posedge clk_i) grant_q <= grant_o;

always_comb begin
  assume ((PortW+1)'(who) < (PortW+1)'(Ports));
  assume ((PortW+1)'(other) < (PortW+1)'(Ports));
  if (rst_ni) begin
    assert ((grant_o & (grant_o - 1'b1)) == '0);
    assert ((grant_o & ~request_i) == '0);
    assert ((grant_o != '0) == (request_i != '0));
    assert (grant_o == '0 || grant_o == Ports'(1) << port_o);
    assert (!stalled_q || (grant_q & request_i) == '0 || grant_o == grant_q);
    assert (waits_q < ProofW'(Ports));
    assert (!(used && request_i[who] && who != other && grant_o[other] && passed_q));
    // invariants
    assert ((PortW+1)'(last_q) < (PortW+1)'(Ports));
    assert ((PortW+1)'(shown_q) < (PortW+1)'(Ports));
    assert (locked_q == stalled_q && (!stalled_q || grant_q == Ports'(1) << shown_q));
    assert (waits_q == '0 || waits_q + proof_distance(last_q, who) < ProofW'(Ports));
    assert (!locked_q || waits_q == '0 || shown_q == who || proof_distance(shown_q, who) < proof_distance(last_q, who));
    assert (!passed_q || (waits_q != '0 && proof_distance(other, who) >= proof_distance(last_q, who)));
  end
end
