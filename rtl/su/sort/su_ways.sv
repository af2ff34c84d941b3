// SPDX-License-Identifier: Apache-2.0
// su_ways: the runs that are being merged: their lines from external memory into the pool, ahead of the merge.
//
// Idea    Each way has SuWayLines places for a line in the pool, eight slots each, and asks for its next line as soon
//         as a place is free, the ways in turn. So a way whose keys all come next still has that many lines in flight.
// Stream  setup: a way's first line and its number of keys (0: the way is empty). read, line: lines of runs; write:
//         their keys go to their slots. ready_o of way_i: lines in its places, some and more than one; release_i: its
//         nearest line is used up.
// Pace    One key per cycle; a request in two.
// Model   The whole SU is tested against cpp_model/su/su.hpp.

module su_ways #(
  localparam int unsigned WayW = $clog2(pipegs_pkg::SuWays)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           setup_i,  // of all ways one after the other
  input  logic [WayW-1:0]                setup_way_i,
  input  logic [pipegs_pkg::SlotW-1:0]   setup_line_i,
  input  logic [pipegs_pkg::SlotW-1:0]   setup_keys_i,

  output logic                           read_valid_o,
  input  logic                           read_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]   read_line_o,
  output logic [WayW-1:0]                read_way_o,
  input  logic                           line_valid_i,
  output logic                           line_ready_o,
  input  logic [WayW-1:0]                line_way_i,
  input  logic [pipegs_pkg::MemoryW-1:0] line_i,

  output logic                           write_o,
  output logic [pipegs_pkg::RecordW-1:0] write_slot_o,
  output logic [pipegs_pkg::KeyW-1:0]    write_key_o,
  output logic [pipegs_pkg::SlotW-1:0]   write_number_o,

  input  logic [WayW-1:0]                way_i,
  output logic [1:0]                     ready_o,  // more than one, some
  input  logic                           release_i,

  output logic                           active_o
);

  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned Ways = pipegs_pkg::SuWays;
  localparam int unsigned Lines = pipegs_pkg::SuWayLines;
  localparam int unsigned RunKeys = pipegs_pkg::SuRunKeys;
  localparam int unsigned EntryW = pipegs_pkg::KeyW + SlotW;
  localparam int unsigned HeldW = $clog2(Lines + 1);
  localparam int unsigned TailW = Lines > 1 ? $clog2(Lines) : 1;
  localparam int unsigned PlaceW = 3;

  logic [Ways-1:0]   more_q, wants;   // the run has lines that were not asked for; and a place is free
  logic [HeldW-1:0]  held_q [Ways];   // places that are taken, from the request on
  logic [HeldW-1:0]  ready_q [Ways];  // those whose line is there
  logic [TailW-1:0]  tail_q [Ways];   // the place of the line that comes next

  // --- requests -----------------------------------------------------------------------------------------------------
  logic              asking_q, pick;
  logic [WayW-1:0]   asked_q, choice;
  logic [SlotW-1:0]  line, keys;  // to be asked for next, keys from there on
  logic              last;

  for (genvar i = 0; i < Ways; i += 1) begin : gen_wants
    assign wants[i] = more_q[i] && held_q[i] != HeldW'(Lines);
  end
  pipegs_round_robin #(.Ports(Ways)) u_turn (
    .mask_i(wants),
    .last_i(asked_q),
    .choice_o(choice)
  );
  assign pick         = !asking_q && !setup_i && wants != '0;
  assign read_valid_o = asking_q;
  assign read_line_o  = line;
  assign read_way_o   = asked_q;
  assign last         = keys <= SlotW'(RunKeys);

  pipegs_sram #(.DataW(2 * SlotW), .Depth(Ways)) u_asks (
    .clk_i,
    .write_i(setup_i || read_ready_i),
    .waddr_i(setup_i ? setup_way_i : asked_q),
    .wdata_i(setup_i ? {setup_line_i, setup_keys_i} : {line + 1'b1, keys - SlotW'(RunKeys)}),
    .read_i(pick),
    .raddr_i(choice),
    .rdata_o({line, keys})
  );

  // --- lines --------------------------------------------------------------------------------------------------------
  logic [PlaceW-1:0] place_q;
  logic              filled;

  assign filled       = line_valid_i && place_q == PlaceW'(RunKeys - 1);
  assign line_ready_o = filled;
  assign write_o      = line_valid_i;
  assign write_slot_o = pipegs_pkg::RecordW'((32'(line_way_i) * Lines + 32'(tail_q[line_way_i])) << PlaceW) |
                        pipegs_pkg::RecordW'(place_q);
  assign {write_number_o, write_key_o} = line_i[place_q*EntryW +: EntryW];
  assign ready_o      = {ready_q[way_i] >> 1 != '0, ready_q[way_i] != '0};
  assign active_o     = setup_i || pick || read_ready_i || line_valid_i || release_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      asking_q <= 1'b0;
      asked_q  <= '0;
      more_q   <= '0;
      place_q  <= '0;
    end else begin
      if (pick) asked_q <= choice;
      asking_q <= pick || (asking_q && !read_ready_i);
      if (setup_i) more_q[setup_way_i] <= setup_keys_i != '0;
      else if (read_ready_i && last) more_q[asked_q] <= 1'b0;
      if (line_valid_i) place_q <= filled ? '0 : place_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < Ways; i += 1) begin
      if (setup_i && setup_way_i == WayW'(i)) begin
        held_q[i]  <= '0;
        ready_q[i] <= '0;
        tail_q[i]  <= '0;
      end else begin
        held_q[i]  <= held_q[i] + HeldW'(read_ready_i && asked_q == WayW'(i)) -
                      HeldW'(release_i && way_i == WayW'(i));
        ready_q[i] <= ready_q[i] + HeldW'(filled && line_way_i == WayW'(i)) - HeldW'(release_i && way_i == WayW'(i));
        if (filled && line_way_i == WayW'(i)) tail_q[i] <= tail_q[i] == TailW'(Lines - 1) ? '0 : tail_q[i] + 1'b1;
      end
    end
  end

  logic unused_line;
  assign unused_line = &{1'b0, line_i};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!setup_i || !asking_q);
  always_ff @(posedge clk_i) if (rst_ni) assert (!release_i || ready_o[0]);
  pipegs_stream_check #(.DataW($bits({read_line_o, read_way_o}))) u_check_read (
    .clk_i,
    .rst_ni,
    .valid_i(read_valid_o),
    .ready_i(read_ready_i),
    .beat_i({read_line_o, read_way_o})
  );
`endif

endmodule
