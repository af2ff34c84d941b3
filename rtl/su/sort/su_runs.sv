// SPDX-License-Identifier: Apache-2.0
// su_runs: the list of keys of a set that spilled, pool by pool, to the splitter and the sorter.
//
// Idea    As soon as the list in external memory holds as many whole lines as fit the pool they are loaded, split and
//         sorted while the list still grows; what is left when the set has ended is the last, shorter run. What comes
//         out of the sorter goes to su_lines.
// Stream  open_i: the pool is empty. read, line: lines of the list; write: a key and its record's number go to the next
//         slot of the pool; group: slots 0 .. group_count_o - 1 are to be sorted; written_i: they are a run in memory.
// Pace    One key per cycle until the pool is filled, then the splitter's.
// Model   The whole SU is tested against cpp_model/su/su.hpp.

module su_runs (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           start_i,   // a set begins to spill
  input  logic                           open_i,
  input  logic [pipegs_pkg::SlotW-1:0]   listed_i,  // whole lines of the list that are in memory
  input  logic                           closed_i,  // the set has ended, its list is complete ...
  input  logic [pipegs_pkg::SlotW-1:0]   count_i,   // ... and has so many keys
  output logic                           done_o,    // all of them are in runs

  output logic                           read_valid_o,
  input  logic                           read_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]   read_line_o,
  input  logic                           line_valid_i,
  output logic                           line_ready_o,
  input  logic [pipegs_pkg::MemoryW-1:0] line_i,

  output logic                           write_o,
  output logic [pipegs_pkg::RecordW-1:0] write_slot_o,
  output logic [pipegs_pkg::KeyW-1:0]    write_key_o,
  output logic [pipegs_pkg::SlotW-1:0]   write_number_o,

  output logic                           group_o,  // one cycle
  output logic [pipegs_pkg::RecordW:0]   group_count_o,
  input  logic                           written_i,

  output logic                           active_o
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned SumW = pipegs_pkg::RecordW + 1;
  localparam int unsigned KeyPartW = 64;  // of a line of the list
  localparam int unsigned LinePartW = $clog2(pipegs_pkg::MemoryW / KeyPartW);
  localparam int unsigned RunLines = pipegs_pkg::Records >> LinePartW;
  localparam int unsigned RunKeys = RunLines << LinePartW;

  typedef enum logic [1:0] {
    Idle,   // waits until the list has a run's keys
    Load,   // brings them into the pool
    Group,  // starts the splitter
    Sort    // waits until they are a run in memory
  } state_e;
  state_e state_q;

  logic [SlotW-1:0]     first_q;             // line where the run begins
  logic [SumW-1:0]      size_q, filled_q;    // keys of the run, those in the pool
  logic [SumW-1:0]      asked_q;             // lines of it
  logic [LinePartW-1:0] part;
  logic                 whole, rest, look;
  logic [SlotW+LinePartW-1:0] first_key;

  assign first_key = {first_q, LinePartW'(0)};
  assign whole     = listed_i >= first_q + SlotW'(RunLines);
  assign rest      = closed_i && first_key < (SlotW+LinePartW)'(count_i);
  assign done_o    = state_q == Idle && closed_i && !rest;

  assign part         = filled_q[LinePartW-1:0];
  assign read_valid_o = state_q == Load && (SumW+LinePartW)'({asked_q, LinePartW'(0)}) < (SumW+LinePartW)'(size_q);
  assign read_line_o  = first_q + SlotW'(asked_q);
  assign look         = state_q == Load && line_valid_i && filled_q != size_q;
  assign line_ready_o = look && (part == '1 || filled_q == size_q - 1'b1);

  assign write_o        = look;
  assign write_slot_o   = filled_q[SumW-2:0];
  assign write_key_o    = line_i[part*KeyPartW +: KeyW];
  assign write_number_o = first_key[SlotW-1:0] + SlotW'(filled_q);
  assign group_o        = state_q == Group;
  assign group_count_o  = size_q;

  always_comb begin
    unique case (state_q)
      Idle:    active_o = start_i || (open_i && (whole || rest));
      Load:    active_o = look || read_ready_i || filled_q == size_q;
      Group:   active_o = 1'b1;
      default: active_o = written_i;
    endcase
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else begin
      unique case (state_q)
        Idle:    if (open_i && (whole || rest)) state_q <= Load;
        Load:    if (filled_q == size_q) state_q <= Group;
        Group:   state_q <= Sort;
        default: if (written_i) state_q <= Idle;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) first_q <= '0;
    if (state_q == Idle) begin
      size_q   <= whole ? SumW'(RunKeys) : SumW'(count_i) - SumW'(first_key);
      asked_q  <= '0;
      filled_q <= '0;
    end
    if (read_ready_i) asked_q <= asked_q + 1'b1;
    if (look) filled_q <= filled_q + 1'b1;
    if (state_q == Sort && written_i) first_q <= first_q + SlotW'(RunLines);
  end

  logic unused_line;  // a list's key has a part of 64 bits
  assign unused_line = &{1'b0, line_i, first_key};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || state_q == Idle);
  pipegs_stream_check #(.DataW($bits(read_line_o))) u_check_read (
    .clk_i,
    .rst_ni,
    .valid_i(read_valid_o),
    .ready_i(read_ready_i),
    .beat_i(read_line_o)
  );
`endif

endmodule
