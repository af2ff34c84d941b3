// SPDX-License-Identifier: Apache-2.0
// pipegs_host: the core with the registers on which its host stands, behind one port to memory.
//
// Idea    The registers give frames to the core, its counters and errors to the host. Between them stand only what ends
//         a frame: pipegs_control_done holds its end back until its pixels are in memory, pipegs_control_restart resets
//         the core when a frame was aborted or has met an error. Then every frame inside is given up; the queued one is
//         begun behind it, unless it was an abort, which drops that one too. Whatever leaves the core passes a gate
//         here that closes a cycle before its reset falls. Only wiring and these gates here.
// Stream  s_axi: AXI4-Lite, see pipegs_control_bus. mem_*: see pipegs_memory_arbiter; a read belongs to the epoch
//         that shows with it.
// Pace    A frame begins four cycles after the bus has taken the write of CONTROL.start.
// Model   The harness drives it as software does: cpp_model/driver, sim/rtl/rtl_bridge.cpp.

module pipegs_host #(
  localparam int unsigned LineW    = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned PerfW    = pipegs_pkg::PerfW,
  localparam int unsigned UnitsW   = (1 + 3 * pipegs_pkg::Units) * 4 * PerfW,
  localparam int unsigned WritesW  = $clog2(pipegs_pkg::BusWrites + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           test_mode_i,  // scan test of the silicon: rst_ni resets the core too; else 0
  input  logic                           scan_en_i,    // every clock runs: patterns shift; else 0

  input  pipegs_pkg::axi_lite_manager_t     s_axi_i,
  output pipegs_pkg::axi_lite_subordinate_t s_axi_o,
  output logic                           irq_o,         // level: an enabled event is not cleared

  output logic                           mem_valid_o,
  input  logic                           mem_ready_i,
  output pipegs_pkg::memory_request_t    mem_request_o,
  output logic [MemoryW-1:0]             mem_data_o,
  input  logic                           mem_rsp_valid_i,
  input  logic [pipegs_pkg::TagW-1:0]    mem_rsp_tag_i,
  input  logic [MemoryW-1:0]             mem_rsp_data_i,

  output logic                           mem_epoch_o,
  input  logic                           mem_drained_i,     // no read of an older epoch is unanswered
  input  logic [WritesW-1:0]             mem_writes_i,      // accepted and not answered
  input  logic                           mem_answered_i,    // pulse: one of them is
  input  logic [3:0]                     mem_error_i,       // pulses: read SLVERR, DECERR, write SLVERR, DECERR
  input  logic [LineW-1:0]               mem_error_line_i,  // of a write: number of its line
  input  pipegs_pkg::memory_wait_t       mem_read_wait_i,   // what memory owes
  input  pipegs_pkg::memory_wait_t       mem_write_wait_i
);

  pipegs_pkg::frame_t   frame;
  pipegs_pkg::areas_t   areas;
  pipegs_pkg::picture_t picture;
  logic                 frame_valid, frame_ready, core_ready, core_busy, core_done, done, waiting;
  logic                 abort, give_up, ready, core_rst_n;
  logic                 apart;            // what the core shows counts for nothing
  logic                 core_valid, frame_shown, busy;
  logic [7:0]           errors;
  logic [31:0]          timeout;
  logic                 read_timeout, write_timeout, read_silent, write_silent;
  logic [1:0]           core_error;       // bad_scene, area_full
  logic [2*LineW-1:0]   core_error_line;
  logic [PerfW-1:0]     cycles, preprocess_cycles, overflow_lines;
  logic [UnitsW-1:0]    perf;

  // Frames that were given up are not inside any more, but what they have written may be on its way. What a silent
  // memory owes nobody waits for.
  assign busy        = (core_busy && !apart) || waiting || (mem_writes_i != '0 && !write_silent);
  assign errors      = {write_timeout, read_timeout, core_error & {2{!apart}}, mem_error_i};
  assign give_up     = abort || errors != '0;
  assign frame_shown = frame_valid && ready;
  assign frame_ready = core_ready && ready;
  assign mem_valid_o = core_valid && !apart;

  pipegs_control_registers u_registers (
    .clk_i,
    .rst_ni,
    .s_axi_i,
    .s_axi_o,
    .irq_o,
    .frame_valid_o(frame_valid),
    .frame_ready_i(frame_ready),
    .frame_o(frame),
    .areas_o(areas),
    .picture_o(picture),
    .abort_o(abort),
    .timeout_o(timeout),
    .apart_i(apart),
    .busy_i(busy),
    .silent_i(read_silent || write_silent),
    .frame_done_i(done),
    .error_i(errors),
    .located_i({mem_write_wait_i.located, mem_read_wait_i.located, 2'b11, 2'b11, 2'b00}),
    .error_address_i({mem_write_wait_i.line, mem_read_wait_i.line, core_error_line, mem_error_line_i, mem_error_line_i,
                      LineW'(0), LineW'(0)}),
    .counters_i({perf, overflow_lines, preprocess_cycles, cycles})
  );

  pipegs_control_watch u_watch_reads (
    .clk_i,
    .rst_ni,
    .limit_i(timeout),
    .waits_i(mem_read_wait_i.waits),
    .moves_i(mem_read_wait_i.moves),
    .tell_o(read_timeout),
    .silent_o(read_silent)
  );

  pipegs_control_watch u_watch_writes (
    .clk_i,
    .rst_ni,
    .limit_i(timeout),
    .waits_i(mem_write_wait_i.waits),
    .moves_i(mem_write_wait_i.moves),
    .tell_o(write_timeout),
    .silent_o(write_silent)
  );

  pipegs_control_restart u_restart (
    .clk_i,
    .rst_ni,
    .test_mode_i,
    .give_up_i(give_up),
    .drained_i(mem_drained_i),
    .epoch_o(mem_epoch_o),
    .apart_o(apart),
    .core_rst_no(core_rst_n),
    .ready_o(ready)
  );

  pipegs_control_done u_done (
    .clk_i,
    .rst_ni,
    .core_done_i(core_done && !apart),
    .give_up_i(give_up),
    .writes_i(mem_writes_i),
    .answered_i(mem_answered_i),
    .done_o(done),
    .waiting_o(waiting)
  );

  pipegs_top u_core (
    .clk_i,
    .rst_ni(core_rst_n),
    .scan_en_i,
    .frame_valid_i(frame_shown),
    .frame_ready_o(core_ready),
    .frame_i(frame),
    .areas_i(areas),
    .picture_i(picture),
    .done_o(core_done),
    .busy_o(core_busy),
    .error_o(core_error),
    .error_line_o(core_error_line),
    .mem_valid_o(core_valid),
    .mem_ready_i,
    .mem_request_o,
    .mem_data_o,
    .mem_rsp_valid_i,
    .mem_rsp_tag_i,
    .mem_rsp_data_i,
    .cycles_o(cycles),
    .preprocess_cycles_o(preprocess_cycles),
    .overflow_lines_o(overflow_lines),
    .perf_o(perf)
  );

`ifndef SYNTHESIS
  // What is given up is taken back.
  pipegs_stream_check #(.DataW($bits({frame, areas, picture}))) u_check_frame (
    .clk_i,
    .rst_ni(ready),
    .valid_i(frame_shown),
    .ready_i(core_ready),
    .beat_i({frame, areas, picture})
  );
  pipegs_stream_check #(.DataW($bits({mem_request_o, mem_data_o}))) u_check_mem (
    .clk_i, .rst_ni(!apart), .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_request_o, mem_data_o})
  );
`endif

endmodule
