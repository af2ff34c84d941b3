// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_memory_arbiter.sv in its proof: each request leaves once, unchanged, in the order of the
// grants.
//
// Idea    The request taken last and whether the memory still owes its acceptance are the whole state: one beat fits
//         inside.
// Rule    At most one port is ready. A grant is for a port that asked in the cycle before, one of the first class
//         (those that may write, and the last one) if such a one did, else of geometry only if no colour did, and stays
//         while its port may be served. A burst of geometry of n lines keeps geometry away for n - 1 cycles. What
//         leaves is what was taken last, with the port's number as its tag, and stays until the memory takes it;
//         nothing is taken over a request that waits, and nothing at all once it is stopped. An answer goes to the port
//         of its tag in the next cycle, and to no other.
// Invariant  The registers hold what was remembered. Fairness inside is that of arbiter_proof.svh, at this size.

localparam int unsigned ProofAddressW = pipegs_pkg::AddressW;
localparam int unsigned ProofHalvesW = pipegs_pkg::HalvesW;
localparam int unsigned ProofBeatW = 1 + ProofAddressW + pipegs_pkg::TagW + ProofHalvesW + BurstW;
(* anyconst *) logic [PortW-1:0] watched;  // any port
(* anyconst *) logic [$clog2(pipegs_pkg::MemoryW)-1:0] place;  // any bit of a line
logic                        waits_q;  // a request of the watched port was taken last and is still here
logic                        any_q;    // some request is here
// In the cycle before: a port was chosen, one of the first class asked, the grant waited.
logic                        chosen_q, first_q, second_q, held_q;
logic [BurstW-1:0]           lines_q, last_lines_q;  // of the watched port's request; of the last burst of geometry
logic [BurstW:0]             since_q;                // cycles since it was taken, up to 2^BurstW
logic [Ports-1:0]            asked_q, granted_q;
logic                        asks, takes, writes, line_bit, write_q, line_bit_q, answer_q, answer_bit_q;
logic [ProofAddressW-1:0]    address_q;
logic [ProofHalvesW-1:0]     halves, halves_q;
logic [pipegs_pkg::TagW-1:0] answer_tag_q;
logic [ProofBeatW-1:0]       beat;

assign asks       = valid_i[watched];
assign takes      = asks && ready_o[watched];
always_comb begin
  writes   = 1'b0;
  line_bit = 1'b0;
  halves   = halves_i[watched*ProofHalvesW +: ProofHalvesW];
  for (int unsigned i = 0; i < WritePorts; i += 1) begin
    if (watched == PortW'(i)) begin
      writes   = write_i[i];
      line_bit = data_i[i*pipegs_pkg::MemoryW + 32'(place)];
    end
  end
end

proof_hold #(.DataW(ProofBeatW)) u_hold (
  .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i(beat)
);
proof_hold #(.DataW(pipegs_pkg::MemoryW)) u_hold_data (
  .clk_i, .rst_ni, .valid_i(mem_valid_o && mem_request_o.write), .ready_i(mem_ready_i), .beat_i(mem_data_o)
);
assign beat = {mem_request_o.write, mem_request_o.address, mem_request_o.tag, mem_request_o.halves,
               mem_request_o.lines};

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    waits_q  <= 1'b0;
    any_q    <= 1'b0;
    chosen_q <= 1'b0;
    held_q   <= 1'b0;
    answer_q <= 1'b0;
    since_q  <= (BurstW+1)'(2**BurstW);
  end else begin
    chosen_q <= (valid_i & able & ~grant_q) != '0 &&
                ((valid_i & able & grant_q) == '0 || (valid_i & ready_o) != '0);
    held_q   <= (valid_i & able & grant_q) != '0 && (valid_i & ready_o) == '0;
    if ((valid_i & ready_o & Geometry) != '0) since_q <= '0;
    else if (!since_q[BurstW]) since_q <= since_q + 1'b1;
    any_q    <= (valid_i & ready_o) != '0 || (any_q && !(mem_valid_o && mem_ready_i));
    waits_q  <= takes || (waits_q && !(mem_valid_o && mem_ready_i));
    answer_q <= mem_rsp_valid_i;
  end
end
always_ff @(posedge clk_i) begin
  first_q   <= (valid_i[WritePorts-1:0] & ~grant_q[WritePorts-1:0]) != '0 || (valid_i[Ports-1] && !grant_q[Ports-1]);
  second_q  <= (valid_i & ~grant_q & ~Geometry) != '0;
  asked_q   <= valid_i & able & ~grant_q;
  if ((valid_i & ready_o & Geometry) != '0) last_lines_q <= out.lines;
  granted_q <= grant_q;
  answer_tag_q <= mem_rsp_tag_i;
  answer_bit_q <= mem_rsp_data_i[place];
  if (takes) begin
    write_q    <= writes;
    halves_q   <= halves;
    address_q  <= address_i[watched*ProofAddressW +: ProofAddressW];
    lines_q    <= lines_i[watched*BurstW +: BurstW];
    line_bit_q <= line_bit;
  end
end

always_comb begin
  assume ((PortW+1)'(watched) < (PortW+1)'(Ports));
  if (rst_ni) begin
    assert ((ready_o & (ready_o - 1'b1)) == '0);
    assert (grant_q == '0 || grant_q == Ports'(1) << port_q);
    assert (!chosen_q || ((grant_q & asked_q) == grant_q && grant_q != '0));
    assert (!chosen_q || !first_q || grant_q[WritePorts-1:0] != '0 || grant_q[Ports-1]);
    assert (!chosen_q || !second_q || (grant_q & Geometry) == '0);
    assert (!held_q || grant_q == granted_q);
    assert ((valid_i & ready_o & Geometry) == '0 || since_q >= (BurstW+1)'(last_lines_q));
    assert (ready_o == '0 || !any_q || mem_ready_i);
    assert (mem_valid_o == any_q);
    assert (!waits_q || (any_q && mem_request_o.tag == pipegs_pkg::TagW'(watched)));
    assert (!(any_q && mem_request_o.tag == pipegs_pkg::TagW'(watched)) || waits_q);
    assert (!waits_q || (mem_request_o.write == write_q && mem_request_o.address == address_q &&
            mem_request_o.halves == halves_q && mem_request_o.lines == lines_q));
    assert (!(waits_q && write_q) || mem_data_o[place] == line_bit_q);
    assert (ready_o == (grant_q & able) || (any_q && !mem_ready_i) || stop_i);
    assert (!stop_i || ready_o == '0);
    assert (since_q[BurstW] ? pause_q == '0 : (BurstW+1)'(pause_q) == (since_q < (BurstW+1)'(last_lines_q) ?
            (BurstW+1)'(last_lines_q) - since_q : (BurstW+1)'(0)));
    assert (rsp_valid_o == (answer_q ? Ports'(1) << answer_tag_q : '0));
    assert (!answer_q || rsp_data_o[place] == answer_bit_q);
  end
end
