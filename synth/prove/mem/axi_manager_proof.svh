// SPDX-License-Identifier: Apache-2.0
// The end of rtl/mem/pipegs_axi_manager.sv in its proof: the rules of AXI4 on all channels, and what is out.
//
// Rule    axi_check. pending_o is up while anything is out. What `axi_fence` assumes: it sees the number of writes that
//         were accepted and not answered, no write is accepted in the cycle of a read, and a read of a tag that may
//         write does not pass while a write is unanswered. What `axi_read` assumes: a read is accepted when there is
//         room. An answer of this epoch that failed is told in the next cycle, each kind by itself, a write's with its
//         line; writes_o and answered_o are the writes that are unanswered, and one that is answered.
// Assumes A subordinate that keeps its rules; a base that is a multiple of 4096; reads of 1 to 8 lines in one aligned
//         group, or of half a line if Coded. The core may withdraw a request.
// Invariant  Reads that are accepted and not answered wait in the fence, on AR or with the subordinate.

(* anyseq *) logic pick;
(* hierconn *) logic [$clog2(Fenced+1)-1:0] \u_fence.waiting ;
(* hierconn *) logic \u_fence.passes ;
(* hierconn *) logic [$clog2(Reads+1)-1:0] \u_read.reads_q ;
(* hierconn *) logic [$clog2(Reads+1)-1:0] \u_read.out_q ;
(* hierconn *) logic [3:0] \u_read.lines ;
(* hierconn *) logic [LineW-1:0] \u_read.line ;
(* hierconn *) logic [pipegs_pkg::HalvesW-1:0] \u_read.halves ;
localparam int unsigned ProofReadsW  = $clog2(Reads + 1) + 1;
localparam int unsigned ProofWritesW = $clog2(Writes + 1) + 1;
localparam int unsigned IdW          = pipegs_pkg::AxiIdW;
localparam int unsigned ProofBeats   = pipegs_pkg::MemoryW / pipegs_pkg::AxiDataW;
(* hierconn *) logic [(ProofBeats > 1 ? $clog2(ProofBeats) : 1)-1:0] \u_write.beat_q ;
(* hierconn *) logic \u_write.done_epoch ;
(* hierconn *) logic [LineW-1:0] \u_write.error_line_o ;
logic [3:0]              failed_q;
logic [LineW-1:0]        failed_line_q;
logic                    manager, subordinate, accepts_read, accepts_write;
logic [ProofReadsW-1:0]  reads;
logic [ProofReadsW+IdW-1:0] sum;  // of all IDs
logic [(1<<IdW)*ProofReadsW-1:0] reads_of;
logic [ProofWritesW-1:0] addresses, lines, open_q;
logic [7:0]              beat;

proof_reset u_proof_reset (.clk_i, .rst_ni);
axi_check #(.Reads(Reads), .Writes(Writes)) u_check (
  .clk_i, .rst_ni, .pick_i(pick), .manager_i(m_axi_o), .subordinate_i(m_axi_i),
  .manager_o(manager), .subordinate_o(subordinate), .reads_o(reads), .reads_of_o(reads_of), .addresses_o(addresses),
  .lines_o(lines), .beat_o(beat)
);

assign accepts_read  = mem_valid_i && mem_ready_o && !mem_request_i.write;
assign accepts_write = mem_valid_i && mem_ready_o && mem_request_i.write;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) open_q <= '0;
  else open_q <= open_q + ProofWritesW'(accepts_write) - ProofWritesW'(m_axi_i.write.b_valid && m_axi_o.write.b_ready);
end

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) failed_q <= '0;
  else begin
    failed_q[1:0] <= m_axi_i.read.r_valid && m_axi_o.read.r_ready && m_axi_i.read.r.id[IdW-1] == epoch_i ?
                     {m_axi_i.read.r.resp == 2'd3, m_axi_i.read.r.resp == 2'd2} : 2'd0;
    failed_q[3:2] <= m_axi_i.write.b_valid && m_axi_o.write.b_ready && \u_write.done_epoch == epoch_i ?
                     {m_axi_i.write.b.resp == 2'd3, m_axi_i.write.b.resp == 2'd2} : 2'd0;
  end
end
always_ff @(posedge clk_i) failed_line_q <= \u_write.error_line_o ;

always_comb begin
  sum = '0;
  for (int unsigned i = 0; i < 1 << IdW; i += 1) sum = sum + (ProofReadsW+IdW)'(reads_of[i*ProofReadsW +: ProofReadsW]);
end

always_comb begin
  assume (subordinate);
  assume (base_i[11:0] == '0);
  assume (!issue_valid || (\u_read.lines != '0 && 5'(\u_read.line [2:0]) + 5'(\u_read.lines ) <= 5'd8));
  assume (!issue_valid || \u_read.halves == '1 ||
          (pipegs_pkg::Coded && \u_read.halves != '0 && \u_read.lines == 4'd1));
  assert (manager);
  if (rst_ni) begin
    assert (pending_o || (reads == '0 && addresses == '0 && lines == '0 && !rsp_valid_o));
    assert (pending_o || !(m_axi_o.read.ar_valid || m_axi_o.write.aw_valid || m_axi_o.write.w_valid));
    assert (error_o == failed_q);
    assert (error_o[3:2] == '0 || error_line_o == failed_line_q);
    assert (writes_o == writes && answered_o == (m_axi_i.write.b_valid && m_axi_o.write.b_ready));
    assert (ProofWritesW'(writes) == open_q && open_q <= ProofWritesW'(Writes));
    assert (!(write_valid && read_valid));
    assert (!(accepts_read && mem_request_i.tag < TagW'(pipegs_pkg::WritePorts) && open_q != '0) || !\u_fence.passes );
    assert (!(accepts_read && !read_room));
    assert (read_wait_o.waits == (reads != '0 || m_axi_o.read.ar_valid) && write_wait_o.waits == (open_q != '0));
    // invariants
    assert (ProofReadsW'(\u_read.out_q ) == reads + ProofReadsW'(m_axi_o.read.ar_valid));
    assert (addresses <= ProofWritesW'(Writes) && lines <= ProofWritesW'(Writes));
    assert (sum == (ProofReadsW+IdW)'(reads));
    for (int unsigned i = 0; i < 1 << IdW; i += 1) assert (reads_of[i*ProofReadsW +: ProofReadsW] <= reads);
    assert (ProofReadsW'(\u_read.reads_q ) <= ProofReadsW'(Reads) && reads <= ProofReadsW'(Reads));
    assert (ProofReadsW'(\u_read.reads_q ) ==
            reads + ProofReadsW'(m_axi_o.read.ar_valid) + ProofReadsW'(\u_fence.waiting ));
    assert (ProofWritesW'(writes) == addresses + ProofWritesW'(m_axi_o.write.aw_valid));
    assert (ProofWritesW'(writes) == lines + ProofWritesW'(m_axi_o.write.w_valid));
    assert (8'(\u_write.beat_q ) < (m_axi_o.write.w_valid ? 8'(ProofBeats) : 8'd1));
    assert (beat == (m_axi_o.write.w_valid ? 8'(\u_write.beat_q ) : '0));
  end
end
