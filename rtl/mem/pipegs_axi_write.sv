// SPDX-License-Identifier: Apache-2.0
// pipegs_axi_write: lines of the core as AXI4 write bursts.
//
// Idea    A line is one burst of INCR with ID 0; of half a line the strobes of the other half are 0. Address and data
//         go into their registers in the same cycle, so data never shows before its address does, and neither waits for
//         the other to be taken. The lines that are not answered stand in a queue: their number is the limit of
//         outstanding writes and what the fence waits for, and an answer that tells of an error names the line at its
//         head.
// Stream  in: the number of a line and its 512 bits. out: AW and W; B is taken when the queue shows its line, which is
//         before the answer can come. An error of an epoch that is over is not reported.
// Pace    A line in MemoryW / DataW cycles; its address shows one cycle after it was taken.
// Model   sim/memory/axi/axi_memory.hpp has the other side.

module pipegs_axi_write #(
  parameter int unsigned AddrW  = 40,
  parameter int unsigned Writes = 64,
  localparam int unsigned LineW   = pipegs_pkg::AddressW,
  localparam int unsigned WritesW = $clog2(Writes + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic [AddrW-1:0]               base_i,       // byte address of line 0, a multiple of 4096
  input  logic                           epoch_i,
  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  logic [LineW-1:0]               in_line_i,
  input  logic [pipegs_pkg::HalvesW-1:0] in_halves_i,  // of the line, what is written
  input  logic [pipegs_pkg::MemoryW-1:0] in_data_i,
  output logic [WritesW-1:0]             writes_o,     // accepted and not answered
  output pipegs_pkg::memory_wait_t       wait_o,       // of the oldest of them

  output logic                           error_o,      // a write of this epoch failed
  output logic                           error_decode_o,  // nothing is at that address
  output logic [LineW-1:0]               error_line_o,

  output pipegs_pkg::axi_writes_t        m_axi_o,
  input  pipegs_pkg::axi_writes_answer_t m_axi_i
);

  localparam int unsigned LineB = $clog2(pipegs_pkg::MemoryW / 8);
  localparam int unsigned PageB = 12 - LineB;  // bits of a line's number within 4 KB
  localparam int unsigned DataW = pipegs_pkg::AxiDataW;
  localparam int unsigned Beats = pipegs_pkg::MemoryW / DataW;
  localparam int unsigned BeatW = Beats > 1 ? $clog2(Beats) : 1;
  // A grain lies in one beat and in one half of the line.
  localparam int unsigned GrainW = DataW < pipegs_pkg::MemoryW / 2 ? DataW : pipegs_pkg::MemoryW / 2;
  localparam int unsigned Grains = pipegs_pkg::MemoryW / GrainW;
  localparam int unsigned StepW  = DataW / GrainW;  // in a beat

  logic                           aw_valid_q, w_valid_q, take, room, address_free, data_free, data_last, done;
  logic [AddrW-1:0]               address_q;
  logic [pipegs_pkg::MemoryW-1:0] data_q;
  logic [Grains-1:0]              written_q;   // those of the beat that is shown lowest
  logic [BeatW-1:0]               beat_q;
  logic                           done_epoch;  // of the write that is answered next

  assign data_last    = beat_q == BeatW'(Beats - 1);
  assign address_free = !aw_valid_q || m_axi_i.aw_ready;
  assign data_free    = !w_valid_q || (m_axi_i.w_ready && data_last);
  assign in_ready_o   = room && address_free && data_free;
  assign take         = in_valid_i && in_ready_o;
  assign done         = m_axi_i.b_valid && m_axi_o.b_ready;

  pipegs_sram_fifo #(.DataW(1 + LineW), .Depth(Writes)) u_writes (
    .clk_i,
    .rst_ni,
    .in_valid_i(take),
    .in_ready_o(room),
    .in_i({epoch_i, in_line_i}),
    .out_valid_o(m_axi_o.b_ready),
    .out_ready_i(m_axi_i.b_valid),
    .out_o({done_epoch, error_line_o}),
    .count_o(writes_o)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      aw_valid_q <= 1'b0;
      w_valid_q  <= 1'b0;
      beat_q     <= '0;
    end else begin
      if (address_free) aw_valid_q <= take;
      if (data_free) w_valid_q <= take;
      if (data_free) beat_q <= '0;
      else if (m_axi_i.w_ready) beat_q <= beat_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      address_q <= {base_i[AddrW-1:12] + (AddrW-12)'(in_line_i[LineW-1:PageB]), in_line_i[PageB-1:0], LineB'(0)};
    end
    if (take) data_q <= in_data_i;
    else if (m_axi_i.w_ready) data_q <= data_q >> DataW;
    if (take) written_q <= {{(Grains/2){in_halves_i[1]}}, {(Grains/2){in_halves_i[0]}}};
    else if (m_axi_i.w_ready) written_q <= written_q >> StepW;
  end

  assign m_axi_o.aw.id    = '0;
  assign m_axi_o.aw.addr  = pipegs_pkg::AxiAddrW'(address_q);
  assign m_axi_o.aw.len   = 8'(Beats - 1);
  assign m_axi_o.aw.size  = 3'($clog2(DataW / 8));
  assign m_axi_o.aw.burst = pipegs_pkg::AxiIncr;
  assign m_axi_o.aw.cache = pipegs_pkg::AxiCache;
  assign m_axi_o.aw.prot  = pipegs_pkg::AxiProt;
  assign m_axi_o.aw_valid = aw_valid_q;
  assign m_axi_o.w.data   = data_q[DataW-1:0];
  for (genvar i = 0; i < StepW; i += 1) begin : gen_strobes
    assign m_axi_o.w.strb[GrainW/8*i +: GrainW/8] = {(GrainW/8){written_q[i]}};
  end
  assign m_axi_o.w.last   = data_last;
  assign m_axi_o.w_valid  = w_valid_q;
  assign error_o          = done && m_axi_i.b.resp[1] && done_epoch == epoch_i;
  assign error_decode_o   = m_axi_i.b.resp[0];

  assign wait_o.waits   = writes_o != '0;
  assign wait_o.moves   = (aw_valid_q && m_axi_i.aw_ready) || (w_valid_q && m_axi_i.w_ready) || done;
  assign wait_o.located = m_axi_o.b_ready;
  assign wait_o.line    = error_line_o;

  logic unused;
  assign unused = &{1'b0, base_i[11:0], m_axi_i.b.id};

endmodule
