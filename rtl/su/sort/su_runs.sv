// SPDX-License-Identifier: Apache-2.0
// su_runs: the list of keys of a set that spilled: those that leave, pool by pool, to the splitter and the sorter.
//
// Idea    A round reads the list in external memory once from its beginning and loads the keys before the mark (all,
//         where an end releases all) into the pool; full, it is split and sorted, and what comes out of the sorter goes
//         to su_lines. Keys at or behind the mark stay in the list, and their number says how much is left; those
//         before the mark of the round before were sent. Without watermarks the round begins while the list still
//         grows. If what is left returns to the pool, a last round loads it, and the slots are shown as they are.
// Stream  open_i: the pool is empty. read, line: lines of the list; write: a key and its record's number go to the next
//         slot of the pool; group: slots 0 .. count - 1 are to be sorted; written_i: they are a run in memory. item: a
//         slot of what returns, while returns_o; idle_i: nothing is left behind the sorter.
// Pace    One key per cycle until the pool is filled, then the splitter's.
// Model   The whole SU is tested against cpp_model/su/su.hpp.

module su_runs (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic [pipegs_pkg::ExpW-1:0]    octave_i,  // in which the buckets of depth begin

  input  logic                           start_i,   // a set begins to spill
  input  logic                           again_i,   // what was before the mark has left: the next round
  input  logic                           refill_i,  // it is that of what returns to the pool
  input  logic                           open_i,
  input  logic [pipegs_pkg::SlotW-1:0]   listed_i,  // whole lines of the list that are in memory
  input  logic                           closed_i,  // the list is complete ...
  input  logic [pipegs_pkg::SlotW-1:0]   count_i,   // ... and has so many keys
  input  logic                           mark_valid_i,
  input  pipegs_pkg::su_mark_t           mark_i,
  output logic                           done_o,    // all keys before the mark are in runs ...
  output logic [pipegs_pkg::SlotW-1:0]   formed_o,  // ... so many ...
  output logic [pipegs_pkg::SlotW-1:0]   rest_o,    // ... and so many are left

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

  output logic                           group_valid_o,  // one cycle
  output pipegs_pkg::su_group_t          group_o,
  input  logic                           written_i,

  input  logic                           idle_i,
  output logic                           refills_o,      // what returns is looked up in the list
  output logic                           returns_o,
  output logic                           returned_o,     // all of it is in the pool
  output logic                           item_valid_o,
  input  logic                           item_ready_i,
  output logic [pipegs_pkg::RecordW-1:0] item_slot_o,

  output logic                           active_o
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned SumW = pipegs_pkg::RecordW + 1;
  localparam int unsigned KeyPartW = 64;  // of a line of the list
  localparam int unsigned LinePartW = $clog2(pipegs_pkg::MemoryW / KeyPartW);
  localparam int unsigned RunKeys = (pipegs_pkg::Records >> LinePartW) << LinePartW;

  typedef enum logic [1:0] {
    Load,   // brings a run's keys into the pool
    Group,  // starts the splitter
    Sort,   // waits until they are a run in memory
    Return  // shows the slots of what returns, until all of it has come
  } state_e;
  state_e state_q;

  logic [SlotW-1:0]     asked_q, seen_q;  // lines asked for, keys looked at
  logic [SlotW-1:0]     lines, formed_q, rest_q;
  logic [SumW-1:0]      filled_q;         // keys in the pool; of what returns, those still to be shown ...
  logic [SumW-2:0]      shown_q;          // ... and those that were
  logic [LinePartW-1:0] part;
  logic                 begins, full, through, look, leaves, stays, refill_q;
  logic [KeyW-1:0]      key, min, max;

  assign part    = seen_q[LinePartW-1:0];
  assign key     = line_i[part*KeyPartW +: KeyW];
  assign full    = filled_q == SumW'(RunKeys);
  assign through = closed_i && seen_q == count_i;
  assign lines   = closed_i ? (count_i >> LinePartW) + SlotW'(count_i[LinePartW-1:0] != '0) : listed_i;

  // --- which keys ---------------------------------------------------------------------------------------------------
  if (pipegs_pkg::HasWatermarks) begin : gen_marks
    logic [pipegs_pkg::BucketW-1:0] bucket, from_q;  // of the key; of the mark that left last
    logic                           unsent, nearer;

    su_bucket u_bucket (
      .octave_i,
      .depth_i(key[KeyW-1 -: pipegs_pkg::DepthW]),
      .bucket_o(bucket)
    );
    always_ff @(posedge clk_i) begin
      if (start_i) from_q <= '0;
      else if (again_i) from_q <= mark_i.bucket;
    end
    assign begins = closed_i && (mark_valid_i || refill_q);
    assign unsent = bucket >= from_q;
    assign nearer = refill_q || mark_i.all || bucket < mark_i.bucket;
    assign leaves = unsent && nearer;
    assign stays  = unsent && !nearer;
  end else begin : gen_all
    assign begins = open_i;
    assign leaves = 1'b1;
    assign stays  = 1'b0;
    logic unused_marks;
    assign unused_marks = &{1'b0, octave_i, mark_valid_i, mark_i};
  end

  // --- lines of the list --------------------------------------------------------------------------------------------
  assign read_valid_o   = begins && state_q != Return && asked_q < lines;
  assign read_line_o    = asked_q;
  assign look           = state_q == Load && line_valid_i && !full;
  assign line_ready_o   = look && (part == '1 || (closed_i && seen_q == count_i - 1'b1));
  assign write_o        = look && leaves;
  assign write_slot_o   = filled_q[SumW-2:0];
  assign write_key_o    = key;
  assign write_number_o = seen_q;

  su_minmax u_minmax (
    .clk_i,
    .rst_ni,
    .clear_i(start_i || again_i || state_q == Group),
    .valid_i(write_o),
    .key_i(key),
    .min_o(min),
    .max_o(max)
  );
  assign group_valid_o = state_q == Group;
  assign group_o       = {filled_q, min, max};
  assign done_o        = state_q == Load && through && filled_q == '0 && !refill_q;
  assign formed_o      = formed_q;
  assign rest_o        = rest_q;

  // --- what returns -------------------------------------------------------------------------------------------------
  assign refills_o    = refill_q && closed_i && state_q == Load;
  assign returns_o    = state_q == Return;
  assign item_valid_o = returns_o && filled_q != '0;
  assign item_slot_o  = shown_q;  // a record that has come takes none whose number is still to be shown
  assign returned_o   = returns_o && filled_q == '0 && idle_i;

  always_comb begin
    unique case (state_q)
      Load:    active_o = start_i || again_i || look || read_ready_i ||
                          (filled_q != '0 && (full || through) && (!refill_q || idle_i));
      Group:   active_o = 1'b1;
      Sort:    active_o = written_i || read_ready_i;
      default: active_o = (item_valid_o && item_ready_i) || returned_o;
    endcase
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q  <= Load;
      filled_q <= '0;
    end else begin
      if (write_o) filled_q <= filled_q + 1'b1;
      if (item_valid_o && item_ready_i) filled_q <= filled_q - 1'b1;
      if ((state_q == Sort && written_i) || start_i || again_i) filled_q <= '0;
      unique case (state_q)
        Load: begin
          if (refill_q && through) begin
            if (idle_i) state_q <= Return;
          end else if (filled_q != '0 && (full || through)) begin
            state_q <= Group;
          end
        end
        Group:   state_q <= Sort;
        Sort:    if (written_i) state_q <= Load;
        default: if (returned_o) state_q <= Load;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (read_ready_i) asked_q <= asked_q + 1'b1;
    if (state_q == Load) shown_q <= '0;
    else if (item_ready_i) shown_q <= shown_q + 1'b1;
    if (look) seen_q <= seen_q + 1'b1;
    if (look && stays) rest_q <= rest_q + 1'b1;
    if (state_q == Group) formed_q <= formed_q + SlotW'(filled_q);
    if (start_i || again_i) begin
      asked_q  <= '0;
      seen_q   <= '0;
      formed_q <= '0;
      rest_q   <= '0;
      refill_q <= again_i && refill_i;
    end
  end

  logic unused_line;  // a list's key has a part of 64 bits; a mark's kind
  assign unused_line = &{1'b0, line_i, open_i, mark_i};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(start_i || again_i) || state_q == Load);
  pipegs_stream_check #(.DataW($bits(read_line_o))) u_check_read (
    .clk_i,
    .rst_ni,
    .valid_i(read_valid_o),
    .ready_i(read_ready_i),
    .beat_i(read_line_o)
  );
  pipegs_stream_check #(.DataW($bits(item_slot_o))) u_check_item (
    .clk_i,
    .rst_ni,
    .valid_i(item_valid_o),
    .ready_i(item_ready_i),
    .beat_i(item_slot_o)
  );
`endif

endmodule
