// SPDX-License-Identifier: Apache-2.0
// su_emit: turns sorted keys back into splats and frees their slots.
//
// Idea    Sorted keys wait in a queue while their records are fetched: from the pool when their turn comes, which frees
//         the slot, from external memory as soon as they enter the queue, so that up to 32 fetches overlap. A key of a
//         set that spilled has a record number of its own, which lies where a record would; while that set is still
//         being sorted key and number go back to external memory. Ends walk through the queue behind their layer, so
//         the next layer is sorted meanwhile; none enters before all records of its layer were asked for, which the
//         next set may overwrite.
// Stream  item: keys with slots in order, or an end with its kind as slot. out: splats. free: a slot whose record was
//         read.
// Pace    One splat per cycle, none behind a write into the pool; of a set that spilled one in three cycles, or as fast
//         as the memory takes requests.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_emit (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            item_valid_i,
  output logic                            item_ready_o,
  input  logic [pipegs_pkg::KeyW-1:0]     item_key_i,
  input  logic [pipegs_pkg::RecordW-1:0]  item_slot_i,
  input  logic                            item_end_i,   // kind in the slot's low bits
  input  logic                            spilled_i,    // slots are those of a set that spilled
  input  logic                            keep_i,       // its keys go to kept, with their numbers

  output logic                            kept_valid_o,
  input  logic                            kept_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]    kept_number_o,
  output logic                            read_valid_o,
  input  logic                            read_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]    read_line_o,  // the record's number
  input  logic                            line_valid_i,
  output logic                            line_ready_o,
  input  logic [pipegs_pkg::SplatBits-1:0] line_i,

  input  logic                            record_busy_i,  // nothing is read of the pool
  output logic                            record_read_o,
  output logic [pipegs_pkg::RecordW-1:0]  record_slot_o,
  input  logic [pipegs_pkg::SplatBits-pipegs_pkg::KeyW-pipegs_pkg::KindW-1:0] record_i,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output pipegs_pkg::splat_t              out_o,

  output logic                            free_o,
  output logic [pipegs_pkg::RecordW-1:0]  free_slot_o,
  output logic                            empty_o,
  output logic                            active_o
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned KindW = pipegs_pkg::KindW;
  localparam int unsigned RecordW = pipegs_pkg::RecordW;
  localparam int unsigned NumberW = pipegs_pkg::SlotW;
  localparam int unsigned EntryW = KindW + 1 + RecordW + KeyW;
  localparam int unsigned PayloadAt = KindW + KeyW;  // a splat is {payload, key without depth, key's depth, kind}

  // Where is the record? For a set that spilled the number is read first.
  logic               looked_q, look, outside, known, item_go, queue_ready, ask_q;  // ask: for the record of read_line
  logic [NumberW-1:0] number, read_line_q;
  assign number       = record_i[NumberW-1:0];
  assign outside      = pipegs_pkg::Overflow != 0 && spilled_i && !item_end_i;
  assign look         = item_valid_i && outside && !looked_q && !record_busy_i;
  assign known        = !outside || looked_q;
  assign read_valid_o = ask_q;
  assign read_line_o  = read_line_q;
  assign item_ready_o = keep_i && outside ? looked_q && kept_ready_i : known && queue_ready && !ask_q;
  assign item_go      = item_valid_i && item_ready_o;
  assign kept_valid_o  = item_valid_i && outside && looked_q && keep_i;
  assign kept_number_o = number;

  // The queue of sorted keys, and the beat whose record is being read.
  logic              head_valid, head_ready;
  logic [$clog2(pipegs_pkg::SuWaiting+1)-1:0] waiting;
  logic [EntryW-1:0] head, entry;
  logic [KindW-1:0]  head_kind, kind_q;
  logic              head_outside, outside_q, valid_q;
  logic [RecordW-1:0]  head_slot;
  logic [KeyW-1:0]   head_key, key_q;
  logic [pipegs_pkg::SplatBits-PayloadAt-1:0] payload;
  logic [KeyW-1:0]   key;
  logic              sent, fetch;  // fetch: of a record in the pool
  pipegs_pkg::splat_t entry_splat;  // with the record of the pool

  assign entry = {item_end_i ? item_slot_i[KindW-1:0] : pipegs_pkg::KindData, outside, item_slot_i, item_key_i};
  pipegs_sram_fifo #(.DataW(EntryW), .Depth(pipegs_pkg::SuWaiting)) u_waiting (
    .clk_i,
    .rst_ni,
    .in_valid_i(item_go && !(keep_i && outside)),
    .in_ready_o(queue_ready),
    .in_i(entry),
    .out_valid_o(head_valid),
    .out_ready_i(head_ready),
    .out_o(head),
    .count_o(waiting)
  );
  assign {head_kind, head_outside, head_slot, head_key} = head;
  assign head_ready    = (!valid_q || sent) && !record_busy_i;
  assign fetch         = head_valid && head_ready && head_kind == pipegs_pkg::KindData && !head_outside;
  assign record_read_o = look || fetch;
  assign record_slot_o = look ? item_slot_i : head_slot;

  assign out_valid_o  = valid_q && (!outside_q || line_valid_i);
  assign sent         = out_valid_o && out_ready_i;
  assign line_ready_o = sent && outside_q;
  assign payload      = kind_q == pipegs_pkg::KindData ? record_i : '0;
  assign key          = kind_q == pipegs_pkg::KindData ? key_q : '0;
  assign out_o        = outside_q ? line_i : entry_splat;
  if (KeyW > pipegs_pkg::DepthW) begin : gen_name  // index and part are a key's lower bits, a splat's upper ones
    assign entry_splat = {payload, key[KeyW-pipegs_pkg::DepthW-1:0], key[KeyW-1 -: pipegs_pkg::DepthW], kind_q};
  end else begin : gen_depth
    assign entry_splat = {payload, key, kind_q};
  end
  assign free_o       = fetch;
  assign free_slot_o  = head_slot;
  assign empty_o      = waiting == '0 && !valid_q;
  assign active_o     = item_go || look || read_ready_i || sent || (head_valid && head_ready) ||
                        (waiting != '0 && !head_valid) || record_busy_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      looked_q <= 1'b0;
      ask_q    <= 1'b0;
      valid_q  <= 1'b0;
    end else begin
      looked_q <= item_valid_i && outside && (look || looked_q) && !item_go;
      ask_q    <= (item_go && outside && !keep_i) || (ask_q && !read_ready_i);
      if (!valid_q || sent) valid_q <= head_valid && head_ready;
    end
  end

  always_ff @(posedge clk_i) begin
    if (item_go && outside) read_line_q <= number;
    if (head_valid && head_ready) begin
      kind_q    <= head_kind;
      outside_q <= head_outside;
      key_q     <= head_key;
    end
  end

`ifndef SYNTHESIS
  // A number that is read meets no record of the pool.
  always_ff @(posedge clk_i) if (rst_ni) assert (!(look || looked_q) || !fetch);
  always_ff @(posedge clk_i) if (rst_ni)
    assert (!look || !valid_q || outside_q || kind_q != pipegs_pkg::KindData);
  pipegs_stream_check #(.DataW($bits(kept_number_o))) u_check_kept (
    .clk_i,
    .rst_ni,
    .valid_i(kept_valid_o),
    .ready_i(kept_ready_i),
    .beat_i(kept_number_o)
  );
  pipegs_stream_check #(.DataW($bits(out_o))) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
  pipegs_stream_check #(.DataW($bits(read_line_o))) u_check_read (
    .clk_i,
    .rst_ni,
    .valid_i(read_valid_o),
    .ready_i(read_ready_i),
    .beat_i(read_line_o)
  );
`endif

endmodule
