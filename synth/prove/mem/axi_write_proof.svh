// SPDX-License-Identifier: Apache-2.0
// The end of rtl/mem/pipegs_axi_write.sv in its proof: AXI4 on AW, W and B, and every bit of a line in its place.
//
// Rule    axi_check. The address is that of the line taken last, computed here without cutting the page off; of the
//         line one bit of the solver's choice is remembered, and stands in the beat and at the place where it belongs,
//         under a strobe if its half of the line is written.
//         writes_o counts the lines taken and not answered, at most Writes. Nothing is taken over what waits.
// Assumes A subordinate that keeps its rules; a base that is a multiple of 4096.
// Invariant  A line that was taken and is not answered waits on AW or was taken there; the same of W.

(* anyconst *) logic [$clog2(pipegs_pkg::MemoryW)-1:0] place;
localparam int unsigned ProofW = $clog2(Writes + 1) + 1;
logic              manager, subordinate, bit_q, half_q;
logic [ProofW-1:0] addresses, lines;
logic [7:0]        beat;
logic [AddrW-1:0]  expected_q;
logic [pipegs_pkg::MemoryW-1:0] moved;  // the line as it would stand if no beat had left
logic [Grains-1:0] moved_written;       // and what of it is written

pipegs_pkg::axi_manager_t     bus;  // the channels here, and others on which nothing moves
pipegs_pkg::axi_subordinate_t memory;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign bus.write    = m_axi_o;
assign bus.read     = '0;
assign memory.write = m_axi_i;
assign memory.read  = '0;
axi_check #(.Reads(1), .Writes(Writes)) u_check (
  .clk_i, .rst_ni, .pick_i(1'b0), .manager_i(bus), .subordinate_i(memory),
  .manager_o(manager), .subordinate_o(subordinate), .reads_o(), .reads_of_o(), .addresses_o(addresses),
  .lines_o(lines), .beat_o(beat)
);

always_ff @(posedge clk_i) if (in_valid_i && in_ready_o) begin
  expected_q <= base_i + (AddrW'(in_line_i) << LineB);
  bit_q      <= in_data_i[place];
  half_q     <= in_halves_i[place / (pipegs_pkg::MemoryW / 2)];
end

assign moved         = data_q << (beat_q * DataW);
assign moved_written = written_q << (beat_q * StepW);
always_comb begin
  assume (subordinate);
  assume (base_i[11:0] == '0);
  assert (manager);
  if (rst_ni) begin
    assert (!m_axi_o.aw_valid || m_axi_o.aw.addr == expected_q);
    assert (!(m_axi_o.w_valid && beat == 8'(place / DataW)) || m_axi_o.w.data[place % DataW] == bit_q);
    assert (!(m_axi_o.w_valid && beat == 8'(place / DataW)) || m_axi_o.w.strb[place % DataW / 8] == half_q);
    assert (!(in_valid_i && in_ready_o) || ((!m_axi_o.aw_valid || m_axi_i.aw_ready) &&
                                            (!m_axi_o.w_valid || (m_axi_i.w_ready && m_axi_o.w.last))));
    assert (!error_o || (m_axi_i.b_valid && m_axi_o.b_ready && m_axi_i.b.resp[1]));
    assert (wait_o.waits == (writes_o != '0) && (!wait_o.located || wait_o.waits));
    assert (wait_o.moves == ((m_axi_o.aw_valid && m_axi_i.aw_ready) || (m_axi_o.w_valid && m_axi_i.w_ready) ||
                             (m_axi_i.b_valid && m_axi_o.b_ready)));
    // invariants
    assert (addresses <= ProofW'(Writes) && lines <= ProofW'(Writes));
    assert (ProofW'(writes_o) == addresses + ProofW'(aw_valid_q));
    assert (ProofW'(writes_o) == lines + ProofW'(w_valid_q));
    assert (beat == (w_valid_q ? 8'(beat_q) : '0));
    assert (8'(beat_q) < (w_valid_q ? 8'(Beats) : 8'd1));
    assert (!w_valid_q || 8'(beat_q) > 8'(place / DataW) || moved[place] == bit_q);
    assert (!w_valid_q || 8'(beat_q) > 8'(place / DataW) || moved_written[place / GrainW] == half_q);
    for (int unsigned i = 0; i < Grains; i += 1) begin
      assert (!w_valid_q || 8'(beat_q) > 8'(i / StepW) ||
              moved_written[i] == moved_written[i / (Grains/2) * (Grains/2) + Grains/2 - 1]);
    end
  end
end
