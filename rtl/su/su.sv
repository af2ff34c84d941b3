// su: a Sorting Unit: collects splats and sends them nearest first.
//
// Paper   Sec. 4.2.2: MinMax Finder, Pivot-based Splitter, 16-channel Bitonic Sorter; Sec. 4.1 for the overlap of layers.
// Idea    One pool of slots. su_collect gives a record a slot and puts it into its bucket of depth; an end releases the
//         buckets before it (su_buckets), nearest first, as chains: chain -> su_split -> su_bitonic -> su_emit, which
//         frees the slots one by one. Ends walk along in the same queues, so many layers live at once. A set that
//         alone fills the pool goes to external memory (su_spill) and through the same path store by store (su_select);
//         with Overflow 0 there is no such set.
//         Here: wiring and the stores.
// Stream  in: splats in any order, then an end beat. out: the same splats by {depth, index}, then the end beat. A layer's end
//         when Order is 2 is a watermark: no later splat of the window is nearer than its depth; it comes out behind
//         the splats of nearer buckets. mem: only overflow. active_o low: nothing would change in this cycle.
// Pace    2 to 4 cycles per splat over all (docs/units/su.md); the memory stays idle while sets fit the pool.
// Model   cpp_model/su/su.hpp

module su (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  pipegs_pkg::frame_t               frame_i,
  input  logic [pipegs_pkg::UnitW-1:0]     unit_i,

  input  logic                             in_valid_i,
  output logic                             in_ready_o,
  input  pipegs_pkg::splat_t               in_i,

  output logic                             out_valid_o,
  input  logic                             out_ready_i,
  output pipegs_pkg::splat_t               out_o,

  input  logic                             spill_i,     // another SU is spilling
  output logic                             spilling_o,

  output logic                             mem_valid_o,
  input  logic                             mem_ready_i,
  output logic                             mem_write_o,
  output logic [pipegs_pkg::AddressW-1:0]  mem_address_o,
  output logic [pipegs_pkg::MemoryW-1:0]   mem_data_o,
  input  logic                             rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]   rsp_data_i,

  output logic                             active_o,
  output logic [1:0]                       perf_o,
  output logic                             overflow_o  // a line was written to external memory
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned KindW = pipegs_pkg::KindW;
  localparam int unsigned DepthW = pipegs_pkg::DepthW;
  localparam int unsigned SlotW = pipegs_pkg::RecordW;
  localparam int unsigned NumberW = pipegs_pkg::SlotW;
  localparam int unsigned BucketW = pipegs_pkg::BucketW;
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits;
  localparam int unsigned PayloadAt = KindW + KeyW;  // without IndexTies the index is of the payload
  localparam int unsigned PayloadW = SplatBits - PayloadAt;
  localparam int unsigned Chains = 64;  // released chains and ends that wait for the splitter
  localparam int unsigned Marks = pipegs_pkg::Order == 2 ? 64 : 4;  // of two windows; of two layers
  localparam int unsigned MarkW = 3 + KindW + BucketW;
  localparam int unsigned ChainW = KindW + BucketW + SlotW + SlotW + 1;

  logic unused_frame;  // only frame_i.overflow is needed
  assign unused_frame = &{1'b0, frame_i};

  // --- what comes in -------------------------------------------------------------------------------------------------
  logic [SplatBits-1:0] in_bits;
  logic [BucketW-1:0]   in_bucket;
  logic [KeyW-1:0]      in_key;
  logic                 slot_valid, write, full, empty, slots_active, free;
  logic [SlotW-1:0]     slot, free_slot;
  logic                 insert_valid, insert_ready, set, record_valid, record_ready, mark_push, mark_room, mark_all, mark_spills;
  logic                 spill_start, ended, spill_done, collect_active, drained, set_released;
  logic                 in_valid, in_ready;
  pipegs_pkg::splat_t   in;

  // Whether there is room hangs on most of the unit: the PU must not wait for that within the cycle.
  skid #(.DataW(SplatBits)) u_in (
    .clk_i, .rst_ni, .in_valid_i, .in_ready_o, .in_i, .out_valid_o(in_valid), .out_ready_i(in_ready), .out_o(in_bits)
  );
  assign in        = in_bits;
  logic unused_in;  // the rest is only kept
  assign unused_in = &{1'b0, in};
  assign in_bucket = in.depth[DepthW-1 -: BucketW];
  assign in_key    = KeyW'({in.depth, in.index} >> (DepthW + pipegs_pkg::SplatIndexW - KeyW));

  su_slots u_slots (
    .clk_i, .rst_ni, .slot_valid_o(slot_valid), .slot_ready_i(write), .slot_o(slot),
    .free_i(free), .free_slot_i(free_slot), .full_o(full), .empty_o(empty), .active_o(slots_active)
  );

  su_collect u_collect (
    .clk_i, .rst_ni, .in_valid_i(in_valid), .in_ready_o(in_ready), .in_kind_i(in.kind), .in_bucket_i(in_bucket),
    .slot_valid_i(slot_valid), .insert_valid_o(insert_valid), .insert_ready_i(insert_ready), .set_o(set), .write_o(write),
    .record_valid_o(record_valid), .record_ready_i(record_ready),
    .mark_valid_o(mark_push), .mark_ready_i(mark_room), .mark_all_o(mark_all), .spilled_o(mark_spills),
    .released_i(set_released), .released_set_i(head_set), .full_i(full), .drained_i(drained),
    .spill_i, .spill_start_o(spill_start), .spilling_o, .ended_o(ended), .spill_done_i(spill_done), .active_o(collect_active)
  );

  // --- marks: ends in order, each waits until su_buckets has released what lies before it -----------------------------
  logic               mark_valid, mark_pop, mark_waits, head_set, head_all, head_spills;
  logic [KindW-1:0]   head_kind;
  logic [BucketW-1:0] head_bucket;
  logic [$clog2(Marks+1)-1:0] marks;

  sram_fifo #(.DataW(MarkW), .Depth(Marks)) u_marks (
    .clk_i, .rst_ni, .in_valid_i(mark_push), .in_ready_o(mark_room),
    .in_i({set, mark_all, mark_spills, in.kind, in_bucket}),
    .out_valid_o(mark_valid), .out_ready_i(mark_pop), .out_o({head_set, head_all, head_spills, head_kind, head_bucket}),
    .count_o(marks)
  );
  assign mark_waits = mark_valid && !head_spills;

  // --- buckets, and the queue of released chains ---------------------------------------------------------------------
  logic               job_done, spill_job, buckets_active, hungry;
  logic               bucket_link, bucket_link_ready;
  logic [SlotW-1:0]   bucket_link_slot, bucket_link_to;
  logic               released_valid, released_ready, chain_valid, chain_ready;
  logic [KindW-1:0]   released_kind, chain_kind;
  logic [SlotW-1:0]   released_head, chain_head;
  logic [SlotW:0]     released_count, chain_count;
  logic [BucketW-1:0] released_bucket, chain_bucket;
  logic [$clog2(Chains+1)-1:0] chains;

  su_buckets u_buckets (
    .clk_i, .rst_ni,
    .insert_valid_i(insert_valid), .insert_ready_o(insert_ready), .insert_set_i(set), .insert_bucket_i(in_bucket),
    .insert_slot_i(slot),
    .job_valid_i(spill_job || mark_waits), .job_done_o(job_done), .job_set_i(spill_job ? set : head_set),
    .job_all_i(spill_job || head_all), .job_bucket_i(head_bucket), .job_kind_i(spill_job ? pipegs_pkg::KindData : head_kind),
    .chain_valid_o(released_valid), .chain_ready_i(released_ready), .chain_kind_o(released_kind),
    .chain_head_o(released_head), .chain_count_o(released_count), .chain_bucket_o(released_bucket), .hungry_i(hungry),
    .link_write_o(bucket_link), .link_ready_i(bucket_link_ready), .link_slot_o(bucket_link_slot), .link_o(bucket_link_to),
    .active_o(buckets_active)
  );
  assign set_released = job_done && !spill_job && head_all;

  sram_fifo #(.DataW(ChainW), .Depth(Chains)) u_chains (
    .clk_i, .rst_ni, .in_valid_i(released_valid), .in_ready_o(released_ready),
    .in_i({released_kind, released_bucket, released_head, released_count}),
    .out_valid_o(chain_valid), .out_ready_i(chain_ready), .out_o({chain_kind, chain_bucket, chain_head, chain_count}),
    .count_o(chains)
  );

  // --- the stores ----------------------------------------------------------------------------------------------------
  logic                select_claim, select_write, split_read, split_claim, split_link, payload_read;
  logic [SlotW-1:0]    select_slot, split_slot, split_link_slot, split_link_to, payload_slot, link;
  logic [KeyW-1:0]     select_key, stored_key;
  logic [PayloadW-1:0] payload;

  sram #(.DataW(KeyW), .Depth(pipegs_pkg::Records)) u_keys (
    .clk_i,
    .write_i(select_write || write), .waddr_i(select_write ? select_slot : slot),
    .wdata_i(select_write ? select_key : in_key),
    .read_i(split_read), .raddr_i(split_slot), .rdata_o(stored_key)
  );
  // The splitter never waits for a link. Selected keys are a chain from the last slot to the first; nobody else is there then.
  assign bucket_link_ready = !split_claim && !select_claim;
  sram #(.DataW(SlotW), .Depth(pipegs_pkg::Records)) u_links (
    .clk_i,
    .write_i(split_link || select_write || (bucket_link && bucket_link_ready)),
    .waddr_i(split_link ? split_link_slot : select_write ? select_slot : bucket_link_slot),
    .wdata_i(split_link ? split_link_to : select_write ? select_slot - 1'b1 : bucket_link_to),
    .read_i(split_read), .raddr_i(split_slot), .rdata_o(link)
  );
  sram #(.DataW(PayloadW), .Depth(pipegs_pkg::Records)) u_records (
    .clk_i,
    .write_i(write), .waddr_i(slot), .wdata_i(in_bits[SplatBits-1:PayloadAt]),
    .read_i(payload_read), .raddr_i(payload_slot), .rdata_o(payload)
  );

  // --- sorting -------------------------------------------------------------------------------------------------------
  logic             chain_is_end, end_go, split_start, split_idle, split_active, bitonic_idle, bitonic_active;
  logic             group;  // su_select has filled the store
  logic [SlotW:0]   group_count;
  logic [KeyW-1:0]  group_min, group_max;
  logic             batch_valid, batch_ready, batch_last, item_valid, item_ready, item_end;
  logic [KeyW-1:0]  batch_key, item_key;
  logic [SlotW-1:0] batch_slot, item_slot;

  assign chain_is_end = chain_kind != pipegs_pkg::KindData;
  assign end_go       = chain_valid && chain_is_end && split_idle;  // the end of a layer is a batch of its own
  assign chain_ready  = split_idle && (!chain_is_end || batch_ready);
  assign split_start  = group || (chain_valid && !chain_is_end && split_idle);
  assign hungry       = chains == '0 && split_idle;

  su_split u_split (
    .clk_i, .rst_ni, .start_i(split_start),
    .head_i(group ? group_count[SlotW-1:0] - 1'b1 : chain_head), .count_i(group ? group_count : chain_count),
    .min_i(group ? group_min : {chain_bucket, (KeyW-BucketW)'(0)}),
    .max_i(group ? group_max : {chain_bucket, {(KeyW-BucketW){1'b1}}}),
    .idle_o(split_idle), .active_o(split_active),
    .key_read_o(split_read), .key_slot_o(split_slot), .key_i(stored_key),
    .link_i(link), .link_claim_o(split_claim), .link_write_o(split_link), .link_slot_o(split_link_slot), .link_o(split_link_to),
    .out_valid_o(batch_valid), .out_ready_i(batch_ready), .out_last_o(batch_last), .out_key_o(batch_key),
    .out_slot_o(batch_slot)
  );

  su_bitonic u_bitonic (
    .clk_i, .rst_ni,
    .in_valid_i(batch_valid || end_go), .in_ready_o(batch_ready), .in_last_i(batch_last || end_go), .in_end_i(end_go),
    .in_key_i(batch_key), .in_slot_i(end_go ? SlotW'(chain_kind) : batch_slot),
    .out_valid_o(item_valid), .out_ready_i(item_ready), .out_end_o(item_end), .out_key_o(item_key), .out_slot_o(item_slot),
    .idle_o(bitonic_idle), .active_o(bitonic_active)
  );

  // --- a set that spills ---------------------------------------------------------------------------------------------
  logic               divert, selecting, select_start, select_idle, select_active, spill_active, mark_first, all_sent;
  logic [NumberW-1:0] spill_count, record_line, keys_line;
  logic [KeyW-1:0]    spill_min, spill_max;
  logic               line_record_valid, line_record_ready, keys_valid, keys_ready, back_valid, back_ready;
  logic [SplatBits-1:0] line_record, back;
  logic [pipegs_pkg::MemoryW-1:0] keys, line;
  logic               select_read, emit_read, read_ready, line_valid, select_line_ready, emit_line_ready, select_turn;
  logic [NumberW-1:0] select_line, emit_line, select_number;
  logic               emit_valid, emit_ready, emit_is_end, emit_empty, emit_active, port_active, port_waits;

  assign drained = !mark_waits && (marks == '0 || mark_valid) && chains == '0 && split_idle && bitonic_idle && emit_empty;

  if (pipegs_pkg::Overflow != 0) begin : gen_overflow
    su_spill u_spill (
      .clk_i, .rst_ni, .start_i(spill_start), .drained_i(drained), .ended_i(ended), .job_valid_o(spill_job), .job_done_i(job_done),
      .divert_o(divert), .selecting_o(selecting), .select_start_o(select_start), .done_i(spill_done),
      .in_valid_i(record_valid), .in_ready_o(record_ready), .in_i(in_bits),
      .back_valid_i(back_valid), .back_ready_o(back_ready), .back_i(back),
      .count_o(spill_count), .min_o(spill_min), .max_o(spill_max),
      .record_valid_o(line_record_valid), .record_ready_i(line_record_ready), .record_line_o(record_line), .record_o(line_record),
      .keys_valid_o(keys_valid), .keys_ready_i(keys_ready), .keys_line_o(keys_line), .keys_o(keys), .active_o(spill_active)
    );

    su_select u_select (
      .clk_i, .rst_ni, .start_i(select_start), .count_i(spill_count), .min_i(spill_min), .max_i(spill_max),
      .idle_o(select_idle), .active_o(select_active),
      .read_valid_o(select_read), .read_ready_i(read_ready && select_read), .read_line_o(select_line),
      .line_valid_i(line_valid && select_turn), .line_ready_o(select_line_ready), .line_i(line),
      .write_claim_o(select_claim), .write_o(select_write), .write_slot_o(select_slot), .write_key_o(select_key), .write_number_o(select_number),
      .group_o(group), .group_count_o(group_count), .group_min_o(group_min), .group_max_o(group_max),
      .group_done_i(split_idle && bitonic_idle)
    );

    su_port u_port (
      .clk_i, .rst_ni, .overflow_i(frame_i.overflow), .unit_i,
      .record_valid_i(line_record_valid), .record_ready_o(line_record_ready), .record_line_i(record_line), .record_i(line_record),
      .keys_valid_i(keys_valid), .keys_ready_o(keys_ready), .keys_line_i(keys_line), .keys_i(keys),
      .read_valid_i(select_read || emit_read), .read_ready_o(read_ready), .read_keys_i(select_read),
      .read_line_i(select_read ? select_line : emit_line),
      .line_valid_o(line_valid), .line_ready_i(select_turn ? select_line_ready : emit_line_ready), .line_o(line),
      .mem_valid_o, .mem_ready_i, .mem_write_o, .mem_address_o, .mem_data_o, .rsp_valid_i, .rsp_data_i,
      .overflow_o, .waits_o(port_waits), .active_o(port_active)
    );
  end else begin : gen_room
    assign {spill_job, divert, selecting, select_start, record_ready, back_ready, spill_active} = '0;
    assign {spill_count, spill_min, spill_max, record_line, line_record, keys_line, keys, line_record_valid, keys_valid} = '0;
    assign {select_idle, select_active, select_read, select_line, select_line_ready} = '0;
    assign {select_claim, select_write, select_slot, select_key, select_number, group, group_count, group_min, group_max} = '0;
    assign {line_record_ready, keys_ready, read_ready, line_valid, line, port_waits, port_active} = '0;
    assign {mem_valid_o, mem_write_o, mem_address_o, mem_data_o, overflow_o} = '0;
    logic unused_overflow;
    assign unused_overflow = &{1'b0, unit_i, mem_ready_i, rsp_valid_i, rsp_data_i, in_bits, line, spill_start, ended, record_valid, spill_count, spill_min,
                               spill_max, record_line, line_record, line_record_valid, line_record_ready, keys, keys_line, keys_valid,
                               keys_ready, select_start, select_line, select_line_ready, emit_read, emit_line, emit_line_ready,
                               select_turn};
  end
  // The first line in flight is one of keys: all records that were asked for were sent.
  assign select_turn = selecting && emit_empty && split_idle && bitonic_idle;

  // Marks of a set that spilled were not released by su_buckets: each goes before the first splat of its bucket or a later
  // one, the end behind all.
  assign all_sent   = select_idle && !item_valid;
  assign mark_first = selecting && mark_valid && (all_sent || (!head_all && item_valid && head_bucket <= item_key[KeyW-1 -: BucketW]));
  assign spill_done = mark_first && head_all && emit_ready;
  assign mark_pop   = mark_first ? emit_ready : job_done && !spill_job;

  assign emit_valid  = mark_first || (item_valid && (!selecting || mark_valid));
  assign emit_is_end = mark_first || item_end;
  assign item_ready  = emit_ready && !mark_first && (!selecting || mark_valid);

  // --- output --------------------------------------------------------------------------------------------------------
  su_emit u_emit (
    .clk_i, .rst_ni,
    .item_valid_i(emit_valid), .item_ready_o(emit_ready), .item_end_i(emit_is_end), .item_key_i(item_key),
    .item_slot_i(mark_first ? SlotW'(head_kind) : item_slot), .spilled_i(selecting),
    .number_write_i(select_write), .number_slot_i(select_slot), .number_i(select_number),
    .read_valid_o(emit_read), .read_ready_i(read_ready && !select_read), .read_line_o(emit_line),
    .line_valid_i(line_valid), .line_ready_o(emit_line_ready), .line_i(line[SplatBits-1:0]),
    .record_read_o(payload_read), .record_slot_o(payload_slot), .record_i(payload),
    .out_valid_o(back_valid), .out_ready_i(divert ? back_ready : out_ready_i), .out_o(back),
    .free_o(free), .free_slot_o(free_slot), .empty_o(emit_empty), .active_o(emit_active)
  );
  assign out_valid_o = back_valid && !divert;
  assign out_o       = back;


  // --- what the unit does in this cycle: 0 busy, 1 starved, 2 blocked, 3 memory --------------------------------------
  logic moves;
  assign moves = collect_active || slots_active || buckets_active || split_start || (chains != '0 && !chain_valid) ||
                 (marks != '0 && !mark_valid) || end_go && batch_ready || split_active || bitonic_active || select_active ||
                 emit_active || spill_active;
  assign active_o = moves || port_active || (in_valid_i && in_ready_o);
  always_comb begin
    perf_o = 2'd1;
    if (out_valid_o && !out_ready_i) perf_o = 2'd2;
    if (port_waits) perf_o = 2'd3;
    if (moves) perf_o = 2'd0;
  end

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) select_start |-> empty);
  assert property (@(posedge clk_i) disable iff (!rst_ni) mark_push |-> mark_room || pipegs_pkg::Order != 2);
`else
  logic unused_empty;
  assign unused_empty = &{1'b0, empty};
`endif

endmodule
