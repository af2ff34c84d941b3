// SPDX-License-Identifier: Apache-2.0
// The end of rtl/mem/pipegs_axi_read.sv in its proof: AXI4 on AR and R, and what is known of reads that are out.
//
// Rule    axi_check. AR shows the read taken last: its ID, all beats of its lines, its address computed here without
//         cutting the page off. reads_q counts the reads accepted and not answered, at most Reads; drained_o is up
//         exactly while none of them is of the other epoch. An error is told only of this epoch, and no beat
//         of it comes in the cycle in which it begins. What is waited for is a read on AR or one that is out, and the
//         line that is told is that of the read that AR shows, else of one taken there, whose ID is not answered since.
// Assumes A subordinate that keeps its rules; a base that is a multiple of 4096 and stays; reads of 1 to 8 lines in one
//         aligned group, or of half a line if Coded; one is accepted only when there is room, and shown at the input
//         once, now or later; the epoch turns only when no read of the one that begins is out.
// Invariant  A read of an epoch is behind its fence, on AR, or with the subordinate.

localparam int unsigned ProofW = $clog2(Reads + 1) + 1;
localparam int unsigned Tags   = 1 << TagW;
(* anyconst *) logic [AddrW-1:0] base;
logic                    manager, subordinate, takes;
logic [ProofW-1:0]       reads;
logic [2*Tags*ProofW-1:0] reads_of;
logic [ProofW-1:0]       behind_0_q, behind_1_q, out_0, out_1, sum_0, sum_1;  // of epochs 0 and 1
logic [AddrW-1:0]        expected_q;
logic [IdW-1:0]          expected_id_q;
logic [3:0]              expected_lines_q;
logic [pipegs_pkg::HalvesW-1:0] expected_halves_q;
logic [7:0]              expected_len;
logic [LineW-1:0]        expected_line_q, owed_expected_q;

pipegs_pkg::axi_manager_t     bus;  // the channels here, and others on which nothing moves
pipegs_pkg::axi_subordinate_t memory;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign bus.read     = m_axi_o;
assign bus.write    = '0;
assign memory.read  = m_axi_i;
assign memory.write = '0;
axi_check #(.Reads(Reads), .Writes(1)) u_check (
  .clk_i, .rst_ni, .pick_i(1'b0), .manager_i(bus), .subordinate_i(memory),
  .manager_o(manager), .subordinate_o(subordinate), .reads_o(reads), .reads_of_o(reads_of), .addresses_o(),
  .lines_o(), .beat_o()
);

assign takes = in_valid_i && in_ready_o;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    behind_0_q <= '0;
    behind_1_q <= '0;
  end else begin
    behind_0_q <= behind_0_q + ProofW'(accept_i && !epoch_i) - ProofW'(takes && !id[IdW-1]);
    behind_1_q <= behind_1_q + ProofW'(accept_i && epoch_i) - ProofW'(takes && id[IdW-1]);
  end
end
always_ff @(posedge clk_i) if (takes) begin
  expected_q       <= base_i + (AddrW'(line) << LineB) + (halves == 2'b10 ? AddrW'(1) << (LineB - 1) : AddrW'(0));
  expected_id_q    <= id;
  expected_lines_q <= lines;
  expected_halves_q <= halves;
  expected_line_q  <= line;
end
always_ff @(posedge clk_i) if (m_axi_o.ar_valid && m_axi_i.ar_ready && renews) owed_expected_q <= expected_line_q;
assign expected_len = (expected_halves_q == '1 ? 8'(expected_lines_q) * 8'(Beats) : 8'(HalfBeats)) - 8'd1;
always_comb begin
  out_0 = '0;
  out_1 = '0;
  for (int unsigned i = 0; i < Tags; i += 1) begin
    out_0 = out_0 + reads_of[i*ProofW +: ProofW];
    out_1 = out_1 + reads_of[(Tags+i)*ProofW +: ProofW];
  end
  sum_0 = behind_0_q + out_0 + ProofW'(ar_valid_q && !id_q[IdW-1]);
  sum_1 = behind_1_q + out_1 + ProofW'(ar_valid_q && id_q[IdW-1]);
end

always_comb begin
  assume (subordinate);
  assume (base_i == base && base[11:0] == '0);
  assume (!accept_i || room_o);
  assume (!in_valid_i || (lines != '0 && 5'(line[2:0]) + 5'(lines) <= 5'd8));
  assume (!in_valid_i || halves == '1 || (pipegs_pkg::Coded && halves != '0 && lines == 4'd1));
  assume (!in_valid_i || (id[IdW-1] ? behind_1_q : behind_0_q) + ProofW'(accept_i && id[IdW-1] == epoch_i) != '0);
  assume (!rst_ni || !turn || (epoch_i ? sum_1 : sum_0) == '0);
  assert (manager);
  if (rst_ni) begin
    assert (!m_axi_o.ar_valid || (m_axi_o.ar.addr == expected_q && m_axi_o.ar.id == expected_id_q &&
                               m_axi_o.ar.len == expected_len));
    assert (!takes || !m_axi_o.ar_valid || m_axi_i.ar_ready);
    assert (!(turn && now));
    assert (drained_o == ((epoch_i ? sum_0 : sum_1) == '0));
    assert (pending_o || (sum_0 == '0 && sum_1 == '0 && !line_valid_o));
    assert (!error_o || (m_axi_i.r_valid && m_axi_i.r.id[IdW-1] == epoch_i && m_axi_i.r.resp[1]));
    assert (wait_o.waits == (m_axi_o.ar_valid || reads != '0));
    assert (wait_o.moves == ((m_axi_o.ar_valid && m_axi_i.ar_ready) || m_axi_i.r_valid));
    assert (wait_o.located || !m_axi_o.ar_valid);
    assert (!wait_o.located || wait_o.waits);
    assert (!wait_o.located || wait_o.line == (m_axi_o.ar_valid ? expected_line_q : owed_expected_q));
    assert (!owed_q || reads_of[owed_id_q*ProofW +: ProofW] != '0);
    // invariants
    assert (ProofW'(out_q) == reads + ProofW'(ar_valid_q));
    assert (!owed_q || owed_line_q == owed_expected_q);
    assert (!ar_valid_q || shown_line == expected_line_q);
    assert (reads_q <= ReadsW'(Reads) && behind_0_q <= ProofW'(Reads) && behind_1_q <= ProofW'(Reads));
    assert (sum_0 <= ProofW'(Reads) && sum_1 <= ProofW'(Reads) && out_0 <= ProofW'(Reads) && out_1 <= ProofW'(Reads));
    assert (ProofW'(reads_q) == sum_0 + sum_1 && reads == out_0 + out_1);
    assert (old_q == ReadsW'(epoch_q ? sum_0 : sum_1));
    for (int unsigned i = 0; i < 2 * Tags; i += 1) assert (reads_of[i*ProofW +: ProofW] <= ProofW'(Reads));
  end
end
