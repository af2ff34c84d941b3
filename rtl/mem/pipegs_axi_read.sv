// SPDX-License-Identifier: Apache-2.0
// pipegs_axi_read: reads of the core as AXI4 read bursts, and their answers.
//
// Idea    A read of up to eight lines is one burst of INCR with the ID {epoch, tag}: AXI keeps the order within an ID,
//         as the core wants it within a tag. Eight lines are 512 bytes and lie in one aligned group, so no burst
//         crosses 4 KB. Half a line (Coded, the ports of colours) is half as many beats, or one of half the bus.
//         Counted are the reads accepted and not answered, and of these the ones of an older epoch: their beats are
//         taken and dropped. One bit tells two epochs apart, so the epoch may change again only when
//         drained_o is up. Of the reads that are out one is remembered until an answer to its ID ends, which may be
//         that to an older one: so what is remembered is unanswered, and when memory falls silent it is known which
//         read it owes.
// Stream  in: the read, {epoch, tag, halves, lines, line}. out: AR; R is never refused. Lines and their tag to the
//         core.
// Pace    One read and one beat per cycle; AR shows one cycle after the read, a line one cycle after its last beat.
// Model   sim/memory/axi/axi_memory.hpp has the other side.

module pipegs_axi_read #(
  parameter int unsigned AddrW = 40,
  parameter int unsigned Reads = 256,
  localparam int unsigned LineW  = pipegs_pkg::AddressW,
  localparam int unsigned TagW   = pipegs_pkg::TagW,
  localparam int unsigned IdW    = pipegs_pkg::AxiIdW,
  localparam int unsigned ReadW  = IdW + pipegs_pkg::HalvesW + 4 + LineW,
  localparam int unsigned ReadsW = $clog2(Reads + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic [AddrW-1:0]               base_i,      // byte address of line 0, a multiple of 4096
  input  logic                           epoch_i,
  output logic                           room_o,      // another read may be accepted
  input  logic                           accept_i,    // it is, of this epoch, now or after its fence shown at the input
  output logic                           drained_o,   // no read of an older epoch is unanswered
  output logic                           pending_o,   // some read is unanswered, or its line shows in this cycle
  output pipegs_pkg::memory_wait_t       wait_o,

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  logic [ReadW-1:0]               in_i,
  output logic                           line_valid_o,
  output logic [TagW-1:0]                line_tag_o,
  output logic [pipegs_pkg::MemoryW-1:0] line_o,

  output logic                           error_o,     // a beat of this epoch failed
  output logic                           error_decode_o,  // nothing is at that address

  output pipegs_pkg::axi_reads_t         m_axi_o,
  input  pipegs_pkg::axi_reads_answer_t  m_axi_i
);

  localparam int unsigned LineB = $clog2(pipegs_pkg::MemoryW / 8);
  localparam int unsigned PageB = 12 - LineB;  // bits of a line's number within 4 KB
  localparam int unsigned DataW = pipegs_pkg::AxiDataW;
  localparam int unsigned Beats = pipegs_pkg::MemoryW / DataW;
  localparam int unsigned HalfBeats = Beats > 1 ? Beats / 2 : 1;
  localparam logic [2:0]  Size = 3'($clog2(DataW / 8));

  logic              ar_valid_q, free, epoch_q, turn, now, answered, gathering;
  logic [IdW-1:0]    id, id_q;
  logic [3:0]        lines;
  logic [pipegs_pkg::HalvesW-1:0] halves;
  logic [7:0]        length_q;
  logic [2:0]        size_q;
  logic [LineW-1:0]  line;
  logic [AddrW-1:0]  address_q;
  logic [ReadsW-1:0] reads_q, old_q;  // unanswered; of these, of an older epoch
  logic [ReadsW-1:0] out_q;           // of the unanswered ones those that AR shows or has shown
  logic              asks, owed_q, renews;  // asks: AR is taken; owed_q: one is remembered; renews: another one may be
  logic [IdW-1:0]    owed_id_q;
  logic [LineW-1:0]  shown_line, owed_line_q;

  // --- AR ------------------------------------------------------------------------------------------------------------
  assign {id, halves, lines, line} = in_i;
  assign free       = !ar_valid_q || m_axi_i.ar_ready;
  assign in_ready_o = free;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) ar_valid_q <= 1'b0;
    else if (free) ar_valid_q <= in_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (free && in_valid_i) begin
      id_q      <= id;
      length_q  <= halves != '1 ? 8'(HalfBeats - 1) : 8'(lines) * 8'(Beats) - 8'd1;
      size_q    <= halves != '1 && Beats == 1 ? Size - 3'd1 : Size;
      address_q <= {base_i[AddrW-1:12] + (AddrW-12)'(line[LineW-1:PageB]), line[PageB-1:0],
                    halves == 2'b10, (LineB-1)'(0)};
    end
  end

  // --- R -------------------------------------------------------------------------------------------------------------
  assign turn     = epoch_i != epoch_q;
  assign now      = m_axi_i.r_valid && m_axi_i.r.id[IdW-1] == epoch_i;
  assign answered = m_axi_i.r_valid && m_axi_i.r.last;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      epoch_q <= 1'b0;
      reads_q <= '0;
      old_q   <= '0;
    end else begin
      epoch_q <= epoch_i;
      if (accept_i && !answered) reads_q <= reads_q + 1'b1;
      if (answered && !accept_i) reads_q <= reads_q - 1'b1;
      if (turn) old_q <= answered ? reads_q - 1'b1 : reads_q;
      else if (answered && !now) old_q <= old_q - 1'b1;
    end
  end

  // --- what memory owes ----------------------------------------------------------------------------------------------
  assign asks       = ar_valid_q && m_axi_i.ar_ready;
  assign renews     = !owed_q || (answered && m_axi_i.r.id == owed_id_q);
  assign shown_line = {(LineW-PageB)'(address_q[AddrW-1:12] - base_i[AddrW-1:12]), address_q[11:LineB]};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      out_q  <= '0;
      owed_q <= 1'b0;
    end else begin
      out_q <= out_q + ReadsW'(in_valid_i && free) - ReadsW'(answered);
      if (renews) owed_q <= asks;
    end
  end
  always_ff @(posedge clk_i) begin
    if (renews && asks) begin
      owed_id_q   <= id_q;
      owed_line_q <= shown_line;
    end
  end

  assign wait_o.waits   = out_q != '0;
  assign wait_o.moves   = asks || m_axi_i.r_valid;
  assign wait_o.located = ar_valid_q || owed_q;
  assign wait_o.line    = ar_valid_q ? shown_line : owed_line_q;

  pipegs_axi_gather #(.DataW(DataW)) u_gather (
    .clk_i,
    .rst_ni,
    .turn_i(turn),
    .beat_valid_i(now),
    .beat_last_i(m_axi_i.r.last),
    .beat_tag_i(m_axi_i.r.id[TagW-1:0]),
    .beat_i(m_axi_i.r.data),
    .line_valid_o,
    .line_tag_o,
    .line_o,
    .active_o(gathering)
  );

  assign m_axi_o.ar.id    = id_q;
  assign m_axi_o.ar.addr  = pipegs_pkg::AxiAddrW'(address_q);
  assign m_axi_o.ar.len   = length_q;
  assign m_axi_o.ar.size  = size_q;
  assign m_axi_o.ar.burst = pipegs_pkg::AxiIncr;
  assign m_axi_o.ar.cache = pipegs_pkg::AxiCache;
  assign m_axi_o.ar.prot  = pipegs_pkg::AxiProt;
  assign m_axi_o.ar_valid = ar_valid_q;
  assign m_axi_o.r_ready  = 1'b1;
  assign room_o           = reads_q != ReadsW'(Reads);
  assign drained_o        = turn ? reads_q == '0 : old_q == '0;
  assign pending_o        = reads_q != '0 || gathering;
  assign error_o          = now && m_axi_i.r.resp[1];
  assign error_decode_o   = m_axi_i.r.resp[0];

  logic unused;
  assign unused = &{1'b0, base_i[11:0]};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) begin
    assert (!turn || old_q == '0) else $error("pipegs_axi_read: a third epoch begins before the first one is drained");
    assert (!(free && in_valid_i) || (lines != '0 && 5'(line[2:0]) + 5'(lines) <= 5'd8))
      else $error("pipegs_axi_read: a read leaves its group of eight lines");
  end
`endif

endmodule
