// SPDX-License-Identifier: Apache-2.0
// pipegs_list_read: reads the lists of the windows, one after another, and deals their entries to the SUs.
//
// Paper   the reproduced GSCore of Sec. 5: rasterization begins when the preprocessing of the frame is over.
// Idea    For each window two jobs for pipegs_line_reader: its lines, and a marker that becomes the window's end. So
//         the lines of the next windows are asked for while this one is dealt. An entry goes to any SU that has room,
//         in turn; an end goes to all. When none has room for some cycles the next one in turn gets it: a full SU
//         brings records to memory only when another one is at its door.
// Stream  start_i: all lists are written. Counts from their SRAM; memory reads; splats out, one record for all SUs with
//         one valid each. Room is no ready: it may not wait for valid. A list is one layer: only windows end.
// Pace    One entry per cycle (with a single SU every second one).
// Model   cpp_model/list/list_write.hpp (the lists); any dealing is right.

module pipegs_list_read #(
  parameter  int unsigned Lines     = pipegs_pkg::ListLines,
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned NumberW   = pipegs_pkg::ListWindowW,
  localparam int unsigned EntryW    = pipegs_pkg::ListEntryW,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW,
  localparam int unsigned LogW      = $clog2(EntryW + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  pipegs_pkg::windows_t           windows_i,
  input  pipegs_pkg::span_t              overflow_i,  // constant while a frame is inside
  input  logic [LogW-1:0]                log_i,         // a list has 2^this lines
  input  logic                           start_i,       // one cycle

  output logic                           count_read_o,  // to the SRAM of the counts
  output logic [NumberW-1:0]             count_number_o,
  input  logic [EntryW-1:0]              count_i,

  output logic                           mem_valid_o,
  input  logic                           mem_ready_i,
  output logic [AddressW-1:0]            mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]  mem_lines_o,  // less one
  input  logic                           rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0] rsp_data_i,

  output logic [Units-1:0]               splat_valid_o,
  input  logic [Units-1:0]               splat_ready_i,
  input  logic [Units-1:0]               splat_room_i,   // SUs that one may choose first
  output pipegs_pkg::splat_t             splat_o,

  output logic                           busy_o,   // from start_i until the last end is taken
  output logic                           active_o  // needs a clock
);

  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned LeftW   = NumberW + 1;
  localparam int unsigned PortW   = Units > 1 ? $clog2(Units) : 1;

  // --- jobs ---------------------------------------------------------------------------------------------------------
  typedef enum logic [1:0] {
    StateIdle,   // waits for start_i
    StateCount,  // asks for the count of the window
    StateLines,  // gives the job of its lines, if it has any
    StateEnd     // gives the job of its end
  } state_e;
  state_e             state_q;
  logic [NumberW-1:0] number_q;
  logic [LeftW-1:0]   left_q, windows;  // windows behind this one
  logic [WindowW-1:0] most_x, most_y;
  logic               job_valid, job_ready, leave;

  assign most_x         = windows_i.last_x - windows_i.first_x;
  assign most_y         = windows_i.last_y - windows_i.first_y;
  assign windows        = (LeftW'(most_x) + LeftW'(1)) * (LeftW'(most_y) + LeftW'(1));
  assign count_read_o   = state_q == StateCount;
  assign count_number_o = number_q;
  assign job_valid      = (state_q == StateLines && count_i != '0) || state_q == StateEnd;
  assign leave          = job_valid ? job_ready : state_q != StateIdle;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) state_q <= StateIdle;
    else unique case (state_q)
      StateIdle:  if (start_i) state_q <= StateCount;
      StateCount: state_q <= StateLines;
      StateLines: if (leave) state_q <= StateEnd;
      default:    if (leave) state_q <= left_q == '0 ? StateIdle : StateCount;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      number_q <= '0;
      left_q   <= windows - LeftW'(1);
    end else if (state_q == StateEnd && leave) begin
      number_q <= number_q + NumberW'(1);
      left_q   <= left_q - LeftW'(1);
    end
  end

  // --- lines --------------------------------------------------------------------------------------------------------
  logic                 item_valid, item_ready, item_read, item_last, item_tag, waiting, idle, bad;
  logic [AddressW-1:0]  bad_line;
  pipegs_pkg::span_t    lists;
  assign lists = {pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaLists), overflow_i.first};
  logic [AddressW-1:0]  item_index;
  logic [SplatBits-1:0] item;

  pipegs_line_reader #(
    .TagW(1),
    .ItemW(SplatBits),
    .ItemsPerLine(1),
    .Lines(Lines),
    .Jobs(pipegs_pkg::ListJobs),
    .IndexW(AddressW),
    .CountW(EntryW)
  ) u_reader (
    .clk_i,
    .rst_ni,
    .table_i(lists),
    .job_valid_i(job_valid),
    .job_ready_o(job_ready),
    .job_read_i(state_q == StateLines),
    .job_first_i(pipegs_pkg::list_first(number_q, log_i)),
    .job_count_i(count_i),
    .job_tag_i(1'b0),
    .mem_valid_o,
    .mem_ready_i,
    .mem_address_o,
    .mem_lines_o,
    .rsp_valid_i,
    .rsp_data_i,
    .out_valid_o(item_valid),
    .out_ready_i(item_ready),
    .out_read_o(item_read),
    .out_index_o(item_index),
    .out_last_o(item_last),
    .out_tag_o(item_tag),
    .out_item_o(item),
    .bad_o(bad),
    .bad_line_o(bad_line),
    .waiting_o(waiting),
    .idle_o(idle)
  );

  // --- dealing ------------------------------------------------------------------------------------------------------
  logic [Units-1:0]     waiting_q, able, request, target;  // waiting: SUs that have still to take the record
  logic [1:0]           none_q;                      // cycles in which no SU had room
  logic [PortW-1:0]     target_port;
  logic                 free, give;
  logic [SplatBits-1:0] out_q;

  // An SU that takes the present record in this cycle may have no room for another.
  pipegs_arbiter #(.Ports(Units)) u_target (
    .clk_i,
    .rst_ni,
    .request_i(request),
    .advance_i(give),
    .grant_o(target),
    .port_o(target_port)
  );
  assign able       = splat_room_i & ~waiting_q;
  assign request    = able == '0 && none_q == '1 ? '1 : able;
  assign free       = (waiting_q & ~splat_ready_i) == '0;
  assign item_ready = free && (!item_read || target != '0);
  assign give       = item_valid && item_ready;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      waiting_q <= '0;
      none_q    <= '0;
    end else begin
      waiting_q <= give ? (item_read ? target : '1) : waiting_q & ~splat_ready_i;
      if (give || !item_valid || !free || able != '0) none_q <= '0;
      else if (none_q != '1) none_q <= none_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (give) out_q <= item_read ? item : SplatBits'(pipegs_pkg::KindWindowEnd);
  end
  assign splat_valid_o = waiting_q;
  assign splat_o       = out_q;

  // --- clock: a line that has come needs two cycles to the door, all else shows at once -----------------------------
  logic moved, asleep;
  assign moved    = (state_q != StateIdle && leave) || give || (waiting_q & splat_ready_i) != '0;
  assign busy_o   = state_q != StateIdle || !idle || waiting_q != '0;
  assign active_o = start_i || (busy_o && !asleep);
  pipegs_sleep #(.Patience(7)) u_sleep (
    .clk_i,
    .rst_ni,
    .moved_i(moved),
    .wake_i(start_i || moved || rsp_valid_i || (mem_valid_o && mem_ready_i)),
    .asleep_o(asleep)
  );

  logic unused_reader;
  assign unused_reader = &{1'b0, bad, bad_line, item_index, item_last, item_tag, waiting, target_port};

`ifndef SYNTHESIS
  pipegs_stream_check #(.Ports(Units), .Shared(1), .DataW($bits(splat_o)), .Proven(1)) u_check_splat (
    .clk_i,
    .rst_ni,
    .valid_i(splat_valid_o),
    .ready_i(splat_ready_i),
    .beat_i(splat_o)
  );
  pipegs_stream_check #(.DataW($bits({state_q, number_q, count_i}))) u_check_job (
    .clk_i,
    .rst_ni,
    .valid_i(job_valid),
    .ready_i(job_ready),
    .beat_i({state_q, number_q, count_i})
  );
`endif

endmodule
