// su: a Sorting Unit: collects the splats of a layer and sends them nearest first.
//
// Paper   Sec. 4.2.2: MinMax Finder, Pivot-based Splitter, 16-channel Bitonic Sorter; Sec. 4.1 for the double buffer.
// Idea    The stores are a ring of layers: su_collect fills in the newest while the oldest goes su_split -> su_bitonic ->
//         su_emit and others wait; the nearest group leaves while farther ones are still whole. A layer that alone
//         does not fit the ring lies in external memory and goes through the same path store by store (su_select).
//         Here: wiring, the stores, the queue of complete layers, and the sequence of one layer.
// Stream  in: splats in any order, then an end beat. out: the same splats by {depth, index}, then the end beat. mem:
//         only overflow: lines written by the collector, lines read back. active_o low: nothing would change in this
//         cycle.
// Pace    3 to 5 cycles per splat over all (docs/units/su.md); the memory stays idle while layers fit the ring.
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
  localparam int unsigned SlotW = pipegs_pkg::RecordW;
  localparam int unsigned NumberW = pipegs_pkg::SlotW;
  localparam int unsigned LineNumberW = pipegs_pkg::SlotW;
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits;
  localparam int unsigned PayloadAt = pipegs_pkg::KindW + KeyW;
  localparam int unsigned PayloadW = SplatBits - PayloadAt;
  localparam int unsigned Layers = 8;  // complete layers that may wait for the sorter
  localparam int unsigned LayerW = pipegs_pkg::KindW + 2 * KeyW + SlotW + NumberW;

  logic unused_fields;  // only frame_i.overflow is needed; the key of in_i goes by its fields
  assign unused_fields = &{1'b0, frame_i, in_bits[PayloadAt-1:0]};

  // --- the layer that is being collected -----------------------------------------------------------------------------
  logic                    closed_valid, closed_ready, collect_write, collect_moved, collect_active, room;
  logic [NumberW-1:0]      closed_count;
  logic [KeyW-1:0]         closed_min, closed_max;
  logic [pipegs_pkg::KindW-1:0] closed_kind;
  logic [SlotW-1:0]        collect_slot, closed_base;
  logic                    append_read;
  logic [SlotW-1:0]        append_slot;
  logic                    record_valid, record_ready, keys_valid, keys_ready;
  logic [LineNumberW-1:0]  record_line, keys_line;
  logic [SplatBits-1:0]    record, in_bits;
  logic [pipegs_pkg::MemoryW-1:0] keys;
  logic                    release_layer;
  logic [SlotW:0]          used_q, release_slots;  // slots of layers that live
  logic [KeyW-1:0]         stored_key;
  logic                    select_write, sorter_idle;

  su_collect u_collect (
    .clk_i, .rst_ni, .in_valid_i, .in_ready_o, .in_i,
    .layer_valid_o(closed_valid), .layer_ready_i(closed_ready), .layer_count_o(closed_count), .layer_min_o(closed_min),
    .layer_max_o(closed_max), .layer_kind_o(closed_kind), .layer_base_o(closed_base),
    .room_i(room), .sorter_idle_i(sorter_idle),
    .write_o(collect_write), .slot_o(collect_slot),
    .key_read_o(append_read), .key_slot_o(append_slot), .key_i(stored_key),
    .record_valid_o(record_valid), .record_ready_i(record_ready), .record_line_o(record_line), .record_o(record),
    .keys_valid_o(keys_valid), .keys_ready_i(keys_ready), .keys_line_o(keys_line), .keys_o(keys),
    .moved_o(collect_moved), .active_o(collect_active)
  );
  assign in_bits = in_i;
  assign room    = used_q != (SlotW+1)'(pipegs_pkg::Records);

  // --- complete layers, oldest first ---------------------------------------------------------------------------------
  logic                    layer_valid, layer_ready;
  logic [NumberW-1:0]      layer_count;
  logic [KeyW-1:0]         layer_min, layer_max;
  logic [pipegs_pkg::KindW-1:0] layer_kind;
  logic [SlotW-1:0]        layer_base;
  logic [$clog2(Layers+1)-1:0] layers;

  sram_fifo #(.DataW(LayerW), .Depth(Layers)) u_layers (
    .clk_i, .rst_ni, .in_valid_i(closed_valid), .in_ready_o(closed_ready),
    .in_i({closed_kind, closed_max, closed_min, closed_base, closed_count}),
    .out_valid_o(layer_valid), .out_ready_i(layer_ready), .out_o({layer_kind, layer_max, layer_min, layer_base, layer_count}),
    .count_o(layers)
  );

  // --- the sequence of the layer that is being sorted ----------------------------------------------------------------
  typedef enum logic [1:0] {
    Idle,   // waits for a layer
    Sort,   // a layer in the store: waits until its last key went to su_emit
    Spill,  // an overflowed layer: su_select starts the splitter for each store
    End     // sends the end beat
  } state_e;
  state_e state_q;

  logic [SlotW-1:0]        base_q;   // first slot of the layer
  logic [SlotW:0]          slots_q;  // slots that it takes
  logic                    layer_spills, select_start, split_start, sent_all, end_ready;
  logic [pipegs_pkg::KindW-1:0] kind_q;
  logic                    split_idle, split_active, bitonic_idle, bitonic_active, select_idle, select_active;
  logic                    emit_empty, emit_active, port_active, port_waits;
  logic                    group;
  logic [SlotW:0]          group_count;
  logic [KeyW-1:0]         group_min, group_max;

  assign layer_spills = layer_count > NumberW'(pipegs_pkg::Records);
  assign layer_ready  = state_q == Idle && layer_valid;
  assign select_start = layer_ready && layer_spills;
  assign split_start  = (layer_ready && !layer_spills && layer_count != '0) || group;
  assign sent_all     = split_idle && bitonic_idle;
  assign sorter_idle  = state_q == Idle && layers == '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
      used_q  <= '0;
    end else begin
      unique case (state_q)
        Idle:    if (layer_ready) state_q <= layer_spills ? Spill : layer_count == '0 ? End : Sort;
        Sort:    if (sent_all) state_q <= End;
        Spill:   if (select_idle) state_q <= End;
        default: if (end_ready) state_q <= Idle;
      endcase
      used_q <= used_q + (SlotW+1)'(collect_write) - (release_layer ? release_slots : '0);
    end
  end
  always_ff @(posedge clk_i) begin
    if (layer_ready) begin
      kind_q  <= layer_kind;
      base_q  <= layer_base;
      slots_q <= layer_spills ? (SlotW+1)'(pipegs_pkg::Records) : layer_count[SlotW:0];
    end
  end

  // --- the stores -----------------------------------------------------------------------------------
  logic             split_read, payload_read;
  logic [SlotW-1:0] split_slot, select_slot, payload_slot;
  logic [KeyW-1:0]  select_key;
  logic [PayloadW-1:0] payload;

  sram #(.DataW(KeyW), .Depth(pipegs_pkg::Records)) u_keys (
    .clk_i,
    .write_i(select_write || collect_write),
    .waddr_i(select_write ? base_q + select_slot : collect_slot),
    .wdata_i(select_write ? select_key : {in_i.depth, in_i.index}),
    .read_i(split_read || append_read),
    .raddr_i(append_read ? append_slot : base_q + split_slot),
    .rdata_o(stored_key)
  );
  sram #(.DataW(PayloadW), .Depth(pipegs_pkg::Records)) u_records (
    .clk_i,
    .write_i(collect_write), .waddr_i(collect_slot), .wdata_i(in_bits[SplatBits-1:PayloadAt]),
    .read_i(payload_read), .raddr_i(payload_slot), .rdata_o(payload)
  );

  // --- sorting -------------------------------------------------------------------------------------------------------
  logic             group_valid, group_ready, group_last, item_valid, item_ready;
  logic [KeyW-1:0]  group_key, item_key;
  logic [SlotW-1:0] group_slot, item_slot;

  su_split u_split (
    .clk_i, .rst_ni, .start_i(split_start), .count_i(group ? group_count : layer_count[SlotW:0]),
    .min_i(group ? group_min : layer_min), .max_i(group ? group_max : layer_max),
    .idle_o(split_idle), .active_o(split_active),
    .key_read_o(split_read), .key_slot_o(split_slot), .key_i(stored_key),
    .out_valid_o(group_valid), .out_ready_i(group_ready), .out_last_o(group_last), .out_key_o(group_key),
    .out_slot_o(group_slot)
  );

  su_bitonic u_bitonic (
    .clk_i, .rst_ni,
    .in_valid_i(group_valid), .in_ready_o(group_ready), .in_last_i(group_last), .in_key_i(group_key),
    .in_slot_i(group_slot),
    .out_valid_o(item_valid), .out_ready_i(item_ready), .out_key_o(item_key), .out_slot_o(item_slot),
    .idle_o(bitonic_idle), .active_o(bitonic_active)
  );

  // --- overflow and output -------------------------------------------------------------------------------------------
  logic                    select_read, emit_read, read_ready, line_valid, select_line_ready, emit_line_ready;
  logic [LineNumberW-1:0]  select_line, emit_line;
  logic [NumberW-1:0]      select_number;
  logic [pipegs_pkg::MemoryW-1:0] line;
  logic                    select_turn;  // the first line in flight is one of keys: all records asked for were sent

  su_select u_select (
    .clk_i, .rst_ni, .start_i(select_start), .count_i(layer_count), .min_i(layer_min), .max_i(layer_max),
    .idle_o(select_idle), .active_o(select_active),
    .read_valid_o(select_read), .read_ready_i(read_ready && select_read), .read_line_o(select_line),
    .line_valid_i(line_valid && select_turn), .line_ready_o(select_line_ready), .line_i(line),
    .write_o(select_write), .write_slot_o(select_slot), .write_key_o(select_key), .write_number_o(select_number),
    .group_o(group), .group_count_o(group_count), .group_min_o(group_min), .group_max_o(group_max),
    .group_done_i(sent_all)
  );
  assign select_turn = state_q == Spill && emit_empty && sent_all;

  su_emit u_emit (
    .clk_i, .rst_ni,
    .item_valid_i(item_valid), .item_ready_o(item_ready), .item_key_i(item_key), .item_slot_i(item_slot),
    .end_valid_i(state_q == End), .end_ready_o(end_ready), .end_kind_i(kind_q),
    .base_i(base_q), .slots_i(slots_q), .spilled_i(state_q == Spill),
    .number_write_i(select_write), .number_slot_i(select_slot), .number_i(select_number),
    .read_valid_o(emit_read), .read_ready_i(read_ready && !select_read), .read_line_o(emit_line),
    .line_valid_i(line_valid), .line_ready_o(emit_line_ready), .line_i(line[SplatBits-1:0]),
    .record_read_o(payload_read), .record_slot_o(payload_slot), .record_i(payload),
    .out_valid_o, .out_ready_i, .out_o,
    .release_o(release_layer), .release_slots_o(release_slots), .empty_o(emit_empty), .active_o(emit_active)
  );

  su_port u_port (
    .clk_i, .rst_ni, .overflow_i(frame_i.overflow), .unit_i,
    .record_valid_i(record_valid), .record_ready_o(record_ready), .record_line_i(record_line), .record_i(record),
    .keys_valid_i(keys_valid), .keys_ready_o(keys_ready), .keys_line_i(keys_line), .keys_i(keys),
    .read_valid_i(select_read || emit_read), .read_ready_o(read_ready), .read_keys_i(select_read),
    .read_line_i(select_read ? select_line : emit_line),
    .line_valid_o(line_valid), .line_ready_i(select_turn ? select_line_ready : emit_line_ready), .line_o(line),
    .mem_valid_o, .mem_ready_i, .mem_write_o, .mem_address_o, .mem_data_o, .rsp_valid_i, .rsp_data_i,
    .overflow_o, .waits_o(port_waits), .active_o(port_active)
  );

  // --- what the unit does in this cycle: 0 busy, 1 starved, 2 blocked, 3 memory --------------------------------------
  assign active_o = collect_active || layer_ready || (layers != '0 && (state_q == Idle || !layer_valid)) || (state_q == Sort && sent_all) ||
                    (state_q == Spill && select_idle) || (state_q == End && end_ready) || split_active ||
                    bitonic_active || select_active || emit_active || port_active;
  always_comb begin
    perf_o = 2'd1;
    if (out_valid_o && !out_ready_i) perf_o = 2'd2;
    if (port_waits) perf_o = 2'd3;
    if (collect_moved || closed_valid || (state_q == Idle && layers != '0) || split_active || bitonic_active || select_active || emit_active) perf_o = 2'd0;
  end

endmodule
