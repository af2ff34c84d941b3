// SPDX-License-Identifier: Apache-2.0
// su_port: the one memory port of an SU and the store for the lines that were read.
//
// Idea    One request is chosen at a time and stays until the memory takes it. A read is only asked for when the
//         store has room for its answer, counted from the request to the moment the line is used; a queue beside the
//         store says whose line each one is. At most one overflowed set lives. Of the unit's share one area has
//         records, one the list of keys, two the runs of every other level (area_place). A line that its area does not
//         hold is not asked for, nor is any behind it (full_o); the last number of all has no place, so that a count
//         that wraps is seen. A set begins to spill when all that was read has left, so no line is written while it is
//         being read.
// Stream  record, keys, run: lines to write. fetch: the number of a line of keys; read: of a record. line: the lines
//         read, in order; line_fetch_o: it is one of keys, for line_way_o.
// Pace    One request in two cycles, up to Answers reads in flight.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_port #(
  localparam int unsigned WayW = $clog2(pipegs_pkg::SuWays)
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,
  input  pipegs_pkg::span_t                 overflow_i,  // constant while a set is inside
  input  logic [pipegs_pkg::UnitW-1:0]      unit_i,

  input  logic                              record_valid_i,
  output logic                              record_ready_o,
  input  logic [pipegs_pkg::SlotW-1:0]      record_line_i,
  input  logic [pipegs_pkg::SplatBits-1:0]  record_i,
  input  logic                              keys_valid_i,
  output logic                              keys_ready_o,
  input  logic [pipegs_pkg::SlotW-1:0]      keys_line_i,
  input  logic [pipegs_pkg::MemoryW-1:0]    keys_i,

  input  logic                              run_valid_i,
  output logic                              run_ready_o,
  input  logic                              run_area_i,   // 1: AreaRuns, 0: AreaMerged
  input  logic [pipegs_pkg::SlotW-1:0]      run_line_i,
  input  logic [pipegs_pkg::MemoryW-1:0]    run_i,

  input  logic                              fetch_valid_i,
  output logic                              fetch_ready_o,
  input  logic                              fetch_list_i,  // of AreaKeys; else ...
  input  logic                              fetch_area_i,  // ... as run_area_i
  input  logic [pipegs_pkg::SlotW-1:0]      fetch_line_i,
  input  logic [WayW-1:0]                   fetch_way_i,
  input  logic                              read_valid_i,
  output logic                              read_ready_o,
  input  logic [pipegs_pkg::SlotW-1:0]      read_line_i,

  output logic                              line_valid_o,
  input  logic                              line_ready_i,
  output logic                              line_fetch_o,
  output logic [WayW-1:0]                   line_way_o,
  output logic [pipegs_pkg::MemoryW-1:0]    line_o,

  output logic                              mem_valid_o,
  input  logic                              mem_ready_i,
  output logic                              mem_write_o,
  output logic [pipegs_pkg::AddressW-1:0]   mem_address_o,
  output logic [pipegs_pkg::MemoryW-1:0]    mem_data_o,
  input  logic                              rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]    rsp_data_i,

  output logic                              full_o,      // stays
  output logic [pipegs_pkg::AddressW-1:0]   full_line_o,  // that would have been next
  output logic                              overflow_o,  // a line was written
  output logic                              waits_o,     // reads are in flight, or a request is not yet taken
  output logic                              active_o
);

  localparam int unsigned Answers = pipegs_pkg::SuAnswers;
  localparam int unsigned FlightW = $clog2(Answers + 1);
  localparam int unsigned AddressW = pipegs_pkg::AddressW;

  typedef enum logic [2:0] {None, Record, Keys, Run, Fetch, Read} choice_e;
  choice_e choice_q, choice_d;

  logic [AddressW-1:0]             share_q;       // the first line of the unit's share
  logic [2:0]                      area, area_q;
  logic [pipegs_pkg::SlotW-1:0]    line, line_q;
  logic [FlightW-1:0]              flight_q;  // lines asked for and not yet used
  logic [FlightW-1:0]              await_q;   // of these, the unanswered ones
  logic                            taken, asked, used, room;
  logic [FlightW-1:0]              stored;    // of these, the answered ones
  logic [FlightW-1:0]              owners;
  logic                            owner_valid, unused_queue_ready, unused_owner_ready;

  assign room   = flight_q != FlightW'(Answers);
  assign taken  = mem_valid_o && mem_ready_i;
  assign used   = line_valid_o && line_ready_i;

  always_comb begin
    choice_d = None;
    if (record_valid_i) choice_d = Record;
    else if (keys_valid_i) choice_d = Keys;
    else if (run_valid_i) choice_d = Run;
    else if (fetch_valid_i && room) choice_d = Fetch;
    else if (read_valid_i && room) choice_d = Read;
    unique case (choice_d)
      Record:  line = record_line_i;
      Keys:    line = keys_line_i;
      Run:     line = run_line_i;
      Fetch:   line = fetch_line_i;
      default: line = read_line_i;
    endcase
    unique case (choice_d)
      Keys:    area = pipegs_pkg::AreaKeys;
      Run:     area = run_area_i ? pipegs_pkg::AreaRuns : pipegs_pkg::AreaMerged;
      Fetch:   area = fetch_list_i ? pipegs_pkg::AreaKeys :
                      fetch_area_i ? pipegs_pkg::AreaRuns : pipegs_pkg::AreaMerged;
      default: area = pipegs_pkg::AreaRecords;
    endcase
  end

  // The place of a line is counted once it is chosen: to choose it takes most of a cycle.
  assign full_o         = choice_q != None &&
                          (line_q == '1 || AddressW'(line_q) >= pipegs_pkg::area_lines(overflow_i.lines, area_q));
  assign full_line_o    = mem_address_o;
  assign mem_valid_o    = choice_q != None && !full_o;
  assign mem_write_o    = choice_q != Fetch && choice_q != Read;
  assign mem_address_o  = share_q + pipegs_pkg::area_place(overflow_i.lines, area_q) + AddressW'(line_q);
  assign mem_data_o     = choice_q == Keys ? keys_i : choice_q == Run ? run_i : pipegs_pkg::MemoryW'(record_i);
  assign record_ready_o = taken && choice_q == Record;
  assign keys_ready_o   = taken && choice_q == Keys;
  assign run_ready_o    = taken && choice_q == Run;
  assign fetch_ready_o  = taken && choice_q == Fetch;
  assign read_ready_o   = taken && choice_q == Read;
  assign asked          = fetch_ready_o || read_ready_o;
  assign overflow_o     = taken && mem_write_o;
  assign waits_o        = mem_valid_o || (flight_q != '0 && !line_valid_o);
  assign active_o       = mem_valid_o || choice_d != None || rsp_valid_i || used || (stored != '0 && !line_valid_o) ||
                          (owners != '0 && !owner_valid);

  pipegs_sram_fifo #(.DataW(pipegs_pkg::MemoryW), .Depth(Answers)) u_answers (
    .clk_i,
    .rst_ni,
    .in_valid_i(rsp_valid_i),
    .in_ready_o(unused_queue_ready),
    .in_i(rsp_data_i),
    .out_valid_o(line_valid_o),
    .out_ready_i(line_ready_i),
    .out_o(line_o),
    .count_o(stored)
  );
  pipegs_sram_fifo #(.DataW(1 + WayW), .Depth(Answers)) u_owners (
    .clk_i,
    .rst_ni,
    .in_valid_i(asked),
    .in_ready_o(unused_owner_ready),
    .in_i({fetch_ready_o, fetch_way_i}),
    .out_valid_o(owner_valid),
    .out_ready_i(used),
    .out_o({line_fetch_o, line_way_o}),
    .count_o(owners)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      choice_q <= None;
      flight_q <= '0;
      await_q  <= '0;
    end else begin
      if (choice_q == None) choice_q <= choice_d;
      else if (taken) choice_q <= None;
      if (asked && !used) flight_q <= flight_q + 1'b1;
      if (used && !asked) flight_q <= flight_q - 1'b1;
      await_q <= await_q + FlightW'(asked) - FlightW'(rsp_valid_i);
    end
  end

  always_ff @(posedge clk_i) begin
    share_q <= overflow_i.first + pipegs_pkg::area_first(overflow_i.lines, unit_i, pipegs_pkg::AreaKeys);
    if (choice_q == None) {area_q, line_q} <= {area, line};
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!rsp_valid_i || (unused_queue_ready && await_q != '0));
  always_ff @(posedge clk_i) if (rst_ni) assert (!asked || unused_owner_ready);
  always_ff @(posedge clk_i) if (rst_ni) assert (!line_valid_o || owner_valid);
  pipegs_stream_check #(.DataW($bits({mem_write_o, mem_address_o, mem_data_o})), .Proven(1)) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_write_o, mem_address_o, mem_write_o ? mem_data_o : '0})  // a read has no data
  );
`endif

endmodule
