// SPDX-License-Identifier: Apache-2.0
// pipegs_axi_manager: the core's memory port becomes an AXI4 manager.
//
// Idea    Reads go through the fence to AR, writes to AW and W; each side has its unit, here they are joined. A request
//         is accepted when its side has room. Reads of the tags that may write, those below WritePorts, must see all
//         writes accepted before them and wait for these in the fence; other tags read only what the host wrote before
//         the start. The core may be reset while requests are out: epoch_i turns, the bus goes on by its rules, and
//         answers to the old core are dropped.
// Stream  mem: request (1 to 8 lines of one aligned group of eight; a write has 1), data of a write. rsp: tag and line
//         of an answer, in order within a tag, never refused. m_axi: AXI4; no path leads from its inputs
//         to its outputs without a register.
// Pace    One request per cycle if the bus is as wide as a line, else a line in as many cycles as it has beats. A read
//         shows on AR one cycle after it was accepted, its line to the core one cycle after its last beat.
// Model   sim/memory/axi/axi_memory.hpp has the other side; verif/mem/axi_manager_test.cpp compares every line.

module pipegs_axi_manager #(
  parameter int unsigned AddrW  = 40,   // of a byte address
  parameter int unsigned Reads  = pipegs_pkg::BusReads,   // bursts that may be unanswered
  parameter int unsigned Writes = pipegs_pkg::BusWrites,  // likewise
  parameter int unsigned Fenced = pipegs_pkg::BusFenced,  // reads that may wait for writes
  localparam int unsigned LineW  = pipegs_pkg::AddressW,
  localparam int unsigned TagW   = pipegs_pkg::TagW
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic [AddrW-1:0]               base_i,         // byte address of line 0, a multiple of 4096; constant while
                                                         // pending_o
  input  logic                           epoch_i,        // turns when the core is reset; not before drained_o
  output logic                           drained_o,      // no read of an older epoch is unanswered
  output logic                           pending_o,      // a read or a write is unanswered

  input  logic                           mem_valid_i,
  output logic                           mem_ready_o,
  input  pipegs_pkg::memory_request_t    mem_request_i,
  input  logic [pipegs_pkg::MemoryW-1:0] mem_data_i,
  output logic                           rsp_valid_o,
  output logic [TagW-1:0]                rsp_tag_o,
  output logic [pipegs_pkg::MemoryW-1:0] rsp_data_o,

  output logic [3:0]                     error_o,        // pulses: read SLVERR, read DECERR, write SLVERR, write
                                                         // DECERR; of this epoch, one cycle after the answer
  output logic [LineW-1:0]               error_line_o,   // of a write: number of its line
  output logic [$clog2(Writes+1)-1:0]    writes_o,       // accepted and not answered
  output logic                           answered_o,     // one of them is, in this cycle
  output pipegs_pkg::memory_wait_t       read_wait_o,    // what the bus owes
  output pipegs_pkg::memory_wait_t       write_wait_o,

  output pipegs_pkg::axi_manager_t       m_axi_o,
  input  pipegs_pkg::axi_subordinate_t   m_axi_i
);

  localparam int unsigned ReadW   = pipegs_pkg::AxiIdW + pipegs_pkg::HalvesW + 4 + LineW;
  localparam int unsigned WritesW = $clog2(Writes + 1);

  logic               read_valid, read_ready, read_room, fence_ready, issue_valid, issue_ready, reads_pending;
  logic               write_valid, write_ready;
  logic [WritesW-1:0] writes;
  logic [ReadW-1:0]   issue;
  logic               read_error, read_decode, write_error, write_decode;
  logic [3:0]         error_q;
  logic [LineW-1:0]   write_line, error_line_q;

  assign write_valid = mem_valid_i && mem_request_i.write;
  assign read_valid  = mem_valid_i && !mem_request_i.write && read_room;
  assign read_ready  = fence_ready && read_room;
  assign mem_ready_o = mem_request_i.write ? write_ready : read_ready;
  assign pending_o   = writes != '0 || reads_pending;

  pipegs_axi_fence #(.DataW(ReadW), .Fenced(Fenced), .Writes(Writes)) u_fence (
    .clk_i,
    .rst_ni,
    .in_valid_i(read_valid),
    .in_ready_o(fence_ready),
    .in_fenced_i(mem_request_i.tag < TagW'(pipegs_pkg::WritePorts)),
    .in_i({epoch_i, mem_request_i.tag, mem_request_i.halves, 4'(mem_request_i.lines) + 4'd1, mem_request_i.address}),
    .write_i(write_valid && write_ready),
    .writes_i(writes),
    .out_valid_o(issue_valid),
    .out_ready_i(issue_ready),
    .out_o(issue)
  );

  pipegs_axi_read #(.AddrW(AddrW), .Reads(Reads)) u_read (
    .clk_i,
    .rst_ni,
    .base_i,
    .epoch_i,
    .room_o(read_room),
    .accept_i(read_valid && fence_ready),
    .drained_o,
    .pending_o(reads_pending),
    .wait_o(read_wait_o),
    .in_valid_i(issue_valid),
    .in_ready_o(issue_ready),
    .in_i(issue),
    .line_valid_o(rsp_valid_o),
    .line_tag_o(rsp_tag_o),
    .line_o(rsp_data_o),
    .error_o(read_error),
    .error_decode_o(read_decode),
    .m_axi_o(m_axi_o.read),
    .m_axi_i(m_axi_i.read)
  );

  pipegs_axi_write #(.AddrW(AddrW), .Writes(Writes)) u_write (
    .clk_i,
    .rst_ni,
    .base_i,
    .epoch_i,
    .in_valid_i(write_valid),
    .in_ready_o(write_ready),
    .in_line_i(mem_request_i.address),
    .in_halves_i(mem_request_i.halves),
    .in_data_i(mem_data_i),
    .writes_o(writes),
    .wait_o(write_wait_o),
    .error_o(write_error),
    .error_decode_o(write_decode),
    .error_line_o(write_line),
    .m_axi_o(m_axi_o.write),
    .m_axi_i(m_axi_i.write)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) error_q <= '0;
    else error_q <= {write_error && write_decode, write_error && !write_decode, read_error && read_decode,
                     read_error && !read_decode};
  end
  always_ff @(posedge clk_i) error_line_q <= write_line;
  assign error_o      = error_q;
  assign error_line_o = error_line_q;
  assign writes_o     = writes;
  assign answered_o   = m_axi_i.write.b_valid && m_axi_o.write.b_ready;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) begin
    assert (!mem_valid_i || !mem_request_i.write || mem_request_i.lines == '0)
      else $error("pipegs_axi_manager: a write of more than one line");
    assert (base_i[11:0] == '0) else $error("pipegs_axi_manager: the base is not a multiple of 4096");
  end
  // A core that is reset takes back what it shows; until then it must stay.
  pipegs_stream_check #(.DataW($bits(mem_request_i))) u_check_read (
    .clk_i,
    .rst_ni(rst_ni && mem_valid_i),
    .valid_i(read_valid),
    .ready_i(fence_ready),
    .beat_i(mem_request_i)
  );
  pipegs_stream_check #(.DataW($bits({mem_request_i, mem_data_i}))) u_check_write (
    .clk_i,
    .rst_ni(rst_ni && mem_valid_i),
    .valid_i(write_valid),
    .ready_i(write_ready),
    .beat_i({mem_request_i, mem_data_i})
  );
`endif

endmodule
