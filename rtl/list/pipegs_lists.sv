// SPDX-License-Identifier: Apache-2.0
// pipegs_lists: the lists of the windows: written while the frame is preprocessed, then read window by window.
//
// Paper   the reproduced GSCore of Sec. 5: two phases with a synchronisation between them, which the layers do away
//         with.
// Idea    pipegs_list_write until every PU's end has come and every line is with the memory, then pipegs_list_read. The
//         memory applies requests in the order in which it accepts them, so a read behind a write sees it. Both share
//         one memory port and the SRAM of the counts, {window} -> records in its list. Only wiring and the phase here.
// Stream  splats of the PUs in, splats to the SUs out. written_o: one cycle, when the second phase begins.
// Pace    One record per cycle in either phase.
// Model   cpp_model/list/list_write.hpp

module pipegs_lists #(
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned NumberW   = pipegs_pkg::ListWindowW,
  localparam int unsigned EntryW    = pipegs_pkg::ListEntryW,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW,
  localparam int unsigned BurstW    = pipegs_pkg::BurstW,
  localparam int unsigned MemoryW   = pipegs_pkg::MemoryW,
  localparam int unsigned LogW      = $clog2(EntryW + 1)
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  input  pipegs_pkg::windows_t       windows_i,
  input  pipegs_pkg::span_t          overflow_i, // constant while a frame is inside
  input  logic                       restart_i,  // a frame begins

  input  logic [Units-1:0]           made_valid_i,  // from the PUs
  output logic [Units-1:0]           made_ready_o,
  input  logic [Units*SplatBits-1:0] made_i,
  input  logic [Units*NumberW-1:0]   number_i,      // of each splat's window

  output logic                       mem_valid_o,
  input  logic                       mem_ready_i,
  output logic                       mem_write_o,
  output logic [AddressW-1:0]        mem_address_o,
  output logic [BurstW-1:0]          mem_lines_o,    // of a read, less one
  output logic [MemoryW-1:0]         mem_data_o,
  input  logic                       rsp_valid_i,
  input  logic [MemoryW-1:0]         rsp_data_i,

  output logic [Units-1:0]           splat_valid_o,  // to the SUs
  input  logic [Units-1:0]           splat_ready_i,
  input  logic [Units-1:0]           splat_room_i,   // see pipegs_list_read
  output pipegs_pkg::splat_t         splat_o,

  output logic                       full_o,         // see pipegs_list_write
  output logic [AddressW-1:0]        full_line_o,
  output logic                       written_o,
  output logic                       busy_o,         // the second phase is not over
  output logic                       active_o
);

  logic                written_q, done, write_active, read_active, reading;
  logic                write_valid, read_valid, write_count_read, read_count_read, count_write;
  logic [NumberW-1:0]  write_number, read_number, count_at;
  logic [EntryW-1:0]   count, count_new;
  logic [AddressW-1:0] write_address, read_address;
  logic [BurstW-1:0]   read_lines;
  logic [LogW-1:0]     room_log;

  pipegs_list_write u_write (
    .clk_i,
    .rst_ni,
    .windows_i,
    .overflow_i,
    .restart_i,
    .splat_valid_i(made_valid_i),
    .splat_ready_o(made_ready_o),
    .splat_i(made_i),
    .number_i,
    .count_read_o(write_count_read),
    .count_number_o(write_number),
    .count_i(count),
    .count_write_o(count_write),
    .count_at_o(count_at),
    .count_o(count_new),
    .mem_valid_o(write_valid),
    .mem_ready_i,
    .mem_address_o(write_address),
    .mem_data_o,
    .log_o(room_log),
    .full_o,
    .full_line_o,
    .done_o(done),
    .active_o(write_active)
  );

  pipegs_list_read u_read (
    .clk_i,
    .rst_ni,
    .windows_i,
    .overflow_i,
    .log_i(room_log),
    .start_i(written_o),
    .count_read_o(read_count_read),
    .count_number_o(read_number),
    .count_i(count),
    .mem_valid_o(read_valid),
    .mem_ready_i(mem_ready_i),
    .mem_address_o(read_address),
    .mem_lines_o(read_lines),
    .rsp_valid_i,
    .rsp_data_i,
    .splat_valid_o,
    .splat_ready_i,
    .splat_room_i,
    .splat_o,
    .busy_o(reading),
    .active_o(read_active)
  );

  pipegs_sram #(.DataW(EntryW), .Depth(2 ** NumberW)) u_counts (
    .clk_i,
    .write_i(count_write),
    .waddr_i(count_at),
    .wdata_i(count_new),
    .read_i(write_count_read || read_count_read),
    .raddr_i(write_count_read ? write_number : read_number),
    .rdata_o(count)
  );

  assign mem_valid_o   = write_valid || read_valid;
  assign mem_write_o   = write_valid;
  assign mem_address_o = write_valid ? write_address : read_address;
  assign mem_lines_o   = write_valid ? '0 : read_lines;
  assign written_o     = done && !written_q;
  assign busy_o        = reading;
  assign active_o      = write_active || read_active || written_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) written_q <= 1'b1;
    else if (restart_i) written_q <= 1'b0;
    else if (done) written_q <= 1'b1;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(write_valid && (read_valid || reading)))
    else $error("a list is read before all are written");
  pipegs_stream_check #(.DataW($bits({mem_write_o, mem_address_o, mem_data_o}))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_write_o, mem_address_o, mem_data_o})
  );
`endif

endmodule
