// SPDX-License-Identifier: Apache-2.0
// su_spill: brings a set that does not fit the pool to external memory, and what is left of it back.
//
// Idea    Everything that the set has in the pool is released, and what comes out of su_emit goes to memory instead of
//         to the merge, which frees the slots. Records that come in meanwhile go to memory as well and first. Record n
//         is line n of the area of records, its key part n % 8 of line n / 8 of the list of keys. No record is kept
//         here: it waits where it comes from until the port has it. The last key of a line comes from the record
//         itself, which goes behind the line. The next mark ends the spill: when what is before it was sent, what is
//         left returns to the pool, or stays if it is more than a half of it: then the set goes on spilling.
// Stream  in: records as they come; back: records out of the pool; record and keys: lines to write; count_o with the
//         number of records.
// Pace    The port's: one record in two cycles, and one line of keys.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_spill (
  input  logic                             clk_i,
  input  logic                             rst_ni,

  input  logic                             start_i,       // nothing that was released is left inside
  input  logic                             drained_i,     // the same
  input  logic                             ended_i,       // the mark that ends the spill has come
  output logic                             job_valid_o,   // release the whole set ...
  input  logic                             job_done_i,
  output logic                             divert_o,      // ... to memory
  output logic                             open_o,        // the pool is empty: all else goes to memory ...
  output logic [pipegs_pkg::SlotW-1:0]     listed_o,      // ... where so many whole lines of keys are
  output logic                             closed_o,      // all that came before the mark, and all its keys
  input  logic                             done_i,        // what is before the mark was sent, and the mark
  input  logic                             mark_all_i,    // nothing can be left
  input  logic [pipegs_pkg::SlotW-1:0]     rest_i,        // so many are left
  output logic                             again_o,       // one cycle: some are; ...
  output logic                             stay_o,        // ... they stay, and the set goes on spilling
  output logic                             refill_o,      // they return to the pool ...
  input  logic                             returned_i,    // ... where they are now
  output logic                             end_o,         // one cycle: nothing of the set is in memory

  input  logic                             in_valid_i,
  output logic                             in_ready_o,
  input  logic [pipegs_pkg::SplatBits-1:0] in_i,
  input  logic                             back_valid_i,
  output logic                             back_ready_o,
  input  logic [pipegs_pkg::SplatBits-1:0] back_i,

  output logic [pipegs_pkg::SlotW-1:0]     count_o,

  output logic                             record_valid_o,
  input  logic                             record_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]     record_line_o,
  output logic [pipegs_pkg::SplatBits-1:0] record_o,
  output logic                             keys_valid_o,
  input  logic                             keys_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]     keys_line_o,
  output logic [pipegs_pkg::MemoryW-1:0]   keys_o,

  output logic                             active_o
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned KeyPartW = 64;  // of a line of keys
  localparam int unsigned KeysPerLine = pipegs_pkg::MemoryW / KeyPartW;
  localparam int unsigned PartW = $clog2(KeysPerLine);

  typedef enum logic [2:0] {
    Idle,    // waits for start_i
    Release, // su_buckets releases the set
    Drain,   // until that lies in memory
    Close,   // until the mark has come and all lines are written; writes the last line of keys
    Send,    // until what is before the mark was sent
    Refill   // until what is left is in the pool
  } state_e;
  state_e state_q;

  logic             from_in, from_back, back_q, shown, last_part, close, all_written;
  logic             keys_sent_q;  // the line that the shown record completes, or the last line, is written
  logic [SlotW-1:0] number_q;     // of records that are written
  logic [PartW-1:0] part;
  logic [KeyW-1:0]  key, keys_q [KeysPerLine-1];

  // The record that is shown; back_q: it was in the cycle before, and a record that comes in has to wait.
  assign from_in      = in_valid_i && !back_q;
  assign from_back    = back_valid_i && divert_o && !from_in;
  assign shown        = from_in || from_back;
  assign in_ready_o   = record_ready_i && from_in;
  assign back_ready_o = record_ready_i && from_back;
  assign part         = number_q[PartW-1:0];
  assign last_part    = part == PartW'(KeysPerLine - 1);

  su_key u_key (
    .splat_i(record_o),
    .key_o(key)
  );
  assign job_valid_o    = state_q == Release;
  assign divert_o       = state_q == Release || state_q == Drain;
  assign open_o         = state_q == Close || closed_o;
  assign listed_o       = number_q >> PartW;
  assign closed_o       = state_q == Send || state_q == Refill;
  assign again_o        = pipegs_pkg::HasWatermarks && done_i && !mark_all_i && rest_i != '0;
  assign stay_o         = again_o && rest_i > SlotW'(pipegs_pkg::SuRefill);
  assign refill_o       = state_q == Refill;
  assign end_o          = (done_i && !again_o) || returned_i;
  assign close          = state_q == Close && ended_i;
  assign all_written    = close && (keys_sent_q || part == '0);
  assign count_o        = number_q;
  assign record_valid_o = shown && (!last_part || keys_sent_q);
  assign record_line_o  = number_q;
  assign record_o       = from_in ? in_i : back_i;
  assign keys_valid_o   = !keys_sent_q && ((shown && last_part) || (close && part != '0));
  assign keys_line_o    = number_q >> PartW;
  always_comb begin
    keys_o = '0;
    for (int unsigned i = 0; i < KeysPerLine - 1; i += 1) keys_o[i*KeyPartW +: KeyW] = keys_q[i];
    if (shown) keys_o[(KeysPerLine-1)*KeyPartW +: KeyW] = key;
  end
  assign active_o       = start_i || (from_back && !back_q) || record_ready_i || keys_ready_i ||
                          job_done_i || (state_q == Drain && drained_i) || all_written || done_i || returned_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q     <= Idle;
      number_q    <= '0;
      back_q      <= 1'b0;
      keys_sent_q <= 1'b0;
    end else begin
      unique case (state_q)
        Idle:    if (start_i) state_q <= Release;
        Release: if (job_done_i) state_q <= Drain;
        Drain:   if (drained_i) state_q <= Close;
        Close:   if (all_written) state_q <= Send;
        Send:    if (done_i) state_q <= stay_o ? Close : again_o ? Refill : Idle;
        default: if (returned_i) state_q <= Idle;
      endcase
      back_q <= from_back && !record_ready_i;
      if (keys_ready_i) keys_sent_q <= 1'b1;
      if (start_i || stay_o || record_ready_i) keys_sent_q <= 1'b0;
      if (start_i) number_q <= '0;
      else if (record_ready_i) number_q <= number_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) if (record_ready_i && !last_part) keys_q[part] <= key;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!record_ready_i || record_valid_o);
  always_ff @(posedge clk_i) if (rst_ni) assert (!keys_ready_i || keys_valid_o);
  always_ff @(posedge clk_i) if (rst_ni) assert (!back_q || from_back);
  always_ff @(posedge clk_i) if (rst_ni) assert (!close || !shown);
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || (state_q == Idle && drained_i));
  always_ff @(posedge clk_i) if (rst_ni) assert (!done_i || state_q == Send);
  pipegs_stream_check #(.DataW($bits({keys_line_o, keys_o}))) u_check_keys (
    .clk_i,
    .rst_ni,
    .valid_i(keys_valid_o),
    .ready_i(keys_ready_i),
    .beat_i({keys_line_o, keys_o})
  );
  pipegs_stream_check #(.DataW($bits({record_line_o, record_o}))) u_check_record (
    .clk_i,
    .rst_ni,
    .valid_i(record_valid_o),
    .ready_i(record_ready_i),
    .beat_i({record_line_o, record_o})
  );
`endif

endmodule
