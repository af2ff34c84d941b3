// SPDX-License-Identifier: Apache-2.0
// pipegs_list_write: appends each record to the list of its window in external memory.
//
// Paper   the reproduced GSCore of Sec. 5: a global preprocessing writes what rasterization reads later.
// Idea    One line per record:   address = overflow + list_first(window) + records before it in this list
//         The counts lie in an SRAM beside this module: read when a record is taken, written back one higher when its
//         line goes to the output register. A record of the same window right behind it takes the count from there.
//         When a frame begins the counts of its windows are cleared, one per cycle. A record for which its list has no
//         room is not written, nor is any behind it (full_o).
// Stream  splats and their windows' numbers in, one stream per PU, in turn; an end is taken at once. Memory writes out.
//         done_o: the counts are cleared, every PU's end has come and every line was accepted.
// Pace    One record per cycle while the memory takes it.
// Model   cpp_model/list/list_write.hpp

module pipegs_list_write #(
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned NumberW   = pipegs_pkg::ListWindowW,
  localparam int unsigned EntryW    = pipegs_pkg::ListEntryW,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW,
  localparam int unsigned UnitIndexW = Units > 1 ? $clog2(Units) : 1,
  localparam int unsigned LogW       = $clog2(EntryW + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  pipegs_pkg::windows_t           windows_i,
  input  pipegs_pkg::span_t              overflow_i,  // constant while a frame is inside
  input  logic                           restart_i,  // a frame begins; nothing is inside

  input  logic [Units-1:0]               splat_valid_i,
  output logic [Units-1:0]               splat_ready_o,
  input  logic [Units*SplatBits-1:0]     splat_i,
  input  logic [Units*NumberW-1:0]       number_i,     // of each splat's window

  output logic                           count_read_o,  // to the SRAM of the counts
  output logic [NumberW-1:0]             count_number_o,
  input  logic [EntryW-1:0]              count_i,
  output logic                           count_write_o,
  output logic [NumberW-1:0]             count_at_o,
  output logic [EntryW-1:0]              count_o,

  output logic                           mem_valid_o,
  input  logic                           mem_ready_i,
  output logic [AddressW-1:0]            mem_address_o,
  output logic [pipegs_pkg::MemoryW-1:0] mem_data_o,

  output logic [LogW-1:0]                log_o,        // a list has 2^this lines
  output logic                           full_o,       // stays
  output logic [AddressW-1:0]            full_line_o,  // that would have been written
  output logic                           done_o,
  output logic                           active_o  // needs a clock
);

  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned LeftW   = NumberW + 1;

  typedef struct packed {logic [Units-1:0][SplatBits-1:0] of;} splats_t;
  typedef struct packed {logic [Units-1:0][NumberW-1:0] of;} numbers_t;
  splats_t  splats;
  numbers_t numbers;
  assign splats  = splat_i;
  assign numbers = number_i;

  // --- clearing the counts ------------------------------------------------------------------------------------------
  logic [LeftW-1:0]   left_q, windows;  // counts still to clear: those below left_q
  logic [WindowW-1:0] most_x, most_y;
  logic               clearing;

  assign most_x   = windows_i.last_x - windows_i.first_x;
  assign most_y   = windows_i.last_y - windows_i.first_y;
  assign windows  = (LeftW'(most_x) + LeftW'(1)) * (LeftW'(most_y) + LeftW'(1));
  assign clearing = left_q != '0;

  logic roomy, none;  // the room is known; there is none

  pipegs_list_room u_room (
    .clk_i,
    .rst_ni,
    .restart_i,
    .windows_i(windows),
    .lines_i(pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaLists)),
    .done_o(roomy),
    .none_o(none),
    .log_o
  );

  // --- one record from all PUs, in turn -----------------------------------------------------------------------------
  logic [Units-1:0]      is_end, data, source, ended_q;
  logic [UnitIndexW-1:0] port;
  logic                  take, move;
  logic                  held_valid_q, out_valid_q, same_q, full, full_q;
  logic [SplatBits-1:0]  held_q, out_q;
  logic [NumberW-1:0]    number, held_number_q;
  logic [EntryW-1:0]     entry, kept_q;
  logic [AddressW-1:0]   address_q;

  always_comb begin
    for (int unsigned i = 0; i < Units; i += 1) begin
      is_end[i] = splat_valid_i[i] && splats.of[i][pipegs_pkg::KindW-1:0] != pipegs_pkg::KindData;
    end
  end
  assign data = splat_valid_i & ~is_end;

  pipegs_arbiter #(.Ports(Units)) u_source (
    .clk_i,
    .rst_ni,
    .request_i(data),
    .advance_i(take),
    .grant_o(source),
    .port_o(port)
  );

  assign move          = held_valid_q && (!out_valid_q || mem_ready_i) && !full_q;
  assign take          = data != '0 && !clearing && roomy && (!held_valid_q || move);
  assign splat_ready_o = (take ? source : '0) | is_end;
  assign number        = numbers.of[port];

  assign entry          = same_q ? kept_q : count_i;
  assign full           = none || entry == '1 || entry >> log_o != '0;
  assign count_read_o   = take;
  assign count_number_o = number;
  assign count_write_o  = clearing || move;
  assign count_at_o     = clearing ? NumberW'(left_q - LeftW'(1)) : held_number_q;
  assign count_o        = clearing ? '0 : entry + EntryW'(1);

  assign mem_valid_o   = out_valid_q && !full_q;
  assign mem_address_o = address_q;
  assign mem_data_o    = pipegs_pkg::MemoryW'(out_q);
  assign full_o        = full_q;
  assign full_line_o   = address_q;
  assign done_o        = ended_q == '1 && !clearing && roomy && !held_valid_q && !out_valid_q;
  assign active_o      = restart_i || clearing || !roomy || splat_valid_i != '0 || held_valid_q || out_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      left_q       <= '0;
      held_valid_q <= 1'b0;
      out_valid_q  <= 1'b0;
      ended_q      <= '0;
      full_q       <= 1'b0;
    end else begin
      if (restart_i) left_q <= windows;
      else if (clearing) left_q <= left_q - LeftW'(1);
      if (restart_i) ended_q <= '0;
      else ended_q <= ended_q | is_end;
      if (take) held_valid_q <= 1'b1;
      else if (move) held_valid_q <= 1'b0;
      if (move) out_valid_q <= 1'b1;
      else if (mem_ready_i && !full_q) out_valid_q <= 1'b0;
      if (move && full) full_q <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      held_q        <= splats.of[port];
      held_number_q <= number;
      same_q        <= move && number == held_number_q;  // the SRAM promises nothing then
    end
    if (move) begin
      out_q     <= held_q;
      kept_q    <= entry + EntryW'(1);
      address_q <= overflow_i.first + pipegs_pkg::list_first(held_number_q, log_o) + AddressW'(entry);
    end
  end

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_data_o})), .Proven(1)) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_data_o})
  );
`endif

endmodule
