// SPDX-License-Identifier: Apache-2.0
// su_sort: the keys of a chain, or of a group that comes back from memory, nearest first.
//
// Paper   Sec. 4.2.2 (MinMax Finder, Pivot-based Splitter, 16-channel Bitonic Sorter).
// Idea    su_split walks the chain and cuts it into batches of at most 16 keys, su_bitonic sorts each. An end is a
//         batch of its own, with its kind as slot. Only wiring here.
// Stream  in: chains, or a group (then no chain comes). out: keys with their slots, and ends.
// Pace    su_split's.
// Model   cpp_model/su/su.hpp

module su_sort #(
  localparam int unsigned KeyW    = pipegs_pkg::KeyW,
  localparam int unsigned RecordW = pipegs_pkg::RecordW
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic [pipegs_pkg::ExpW-1:0] octave_i,  // in which the buckets of depth begin

  input  logic                  chain_valid_i,
  output logic                  chain_ready_o,
  input  pipegs_pkg::su_chain_t chain_i,
  input  logic                  group_valid_i,
  input  pipegs_pkg::su_group_t group_i,

  output logic                  read_o,   // of the stores: a key and the link to the next one
  output logic [RecordW-1:0]    slot_o,
  input  logic [KeyW-1:0]       key_i,
  input  logic [RecordW-1:0]    link_i,
  output logic                  claim_o,  // new chains
  output logic                  write_o,
  output logic [RecordW-1:0]    write_slot_o,
  output logic [RecordW-1:0]    write_link_o,

  output logic                  item_valid_o,
  input  logic                  item_ready_i,
  output pipegs_pkg::su_item_t  item_o,

  output logic                  split_idle_o,
  output logic                  idle_o,
  output logic                  moves_o
);

  logic               is_end, end_go, start, split_active, bitonic_idle, bitonic_active;
  logic               batch_valid, batch_ready, batch_last, item_end;
  logic [KeyW-1:0]    batch_key, item_key, chain_min, chain_max;
  logic [RecordW-1:0] batch_slot, item_slot;

  assign is_end        = chain_i.kind != pipegs_pkg::KindData;
  assign end_go        = chain_valid_i && is_end && split_idle_o;
  assign chain_ready_o = split_idle_o && (!is_end || batch_ready);
  assign start         = group_valid_i || (chain_valid_i && !is_end && split_idle_o);

  su_range u_range (
    .octave_i,
    .bucket_i(chain_i.bucket),
    .min_o(chain_min),
    .max_o(chain_max)
  );

  su_split u_split (
    .clk_i,
    .rst_ni,
    .start_i(start),
    .head_i(group_valid_i ? group_i.count[RecordW-1:0] - 1'b1 : chain_i.head),
    .count_i(group_valid_i ? group_i.count : chain_i.count),
    .min_i(group_valid_i ? group_i.min : chain_min),
    .max_i(group_valid_i ? group_i.max : chain_max),
    .idle_o(split_idle_o),
    .active_o(split_active),
    .key_read_o(read_o),
    .key_slot_o(slot_o),
    .key_i,
    .link_i,
    .link_claim_o(claim_o),
    .link_write_o(write_o),
    .link_slot_o(write_slot_o),
    .link_o(write_link_o),
    .out_valid_o(batch_valid),
    .out_ready_i(batch_ready),
    .out_last_o(batch_last),
    .out_key_o(batch_key),
    .out_slot_o(batch_slot)
  );

  su_bitonic u_bitonic (
    .clk_i,
    .rst_ni,
    .in_valid_i(batch_valid || end_go),
    .in_ready_o(batch_ready),
    .in_last_i(batch_last || end_go),
    .in_end_i(end_go),
    .in_key_i(batch_key),
    .in_slot_i(end_go ? RecordW'(chain_i.kind) : batch_slot),
    .out_valid_o(item_valid_o),
    .out_ready_i(item_ready_i),
    .out_end_o(item_end),
    .out_key_o(item_key),
    .out_slot_o(item_slot),
    .idle_o(bitonic_idle),
    .active_o(bitonic_active)
  );

  assign item_o  = {item_end, item_key, item_slot};
  assign idle_o  = split_idle_o && bitonic_idle;
  assign moves_o = start || (end_go && batch_ready) || split_active || bitonic_active;

`ifndef SYNTHESIS
  pipegs_stream_check u_check_batch (
    .clk_i,
    .rst_ni,
    .valid_i(batch_valid || end_go),
    .ready_i(batch_ready),
    .beat_i(1'b0)
  );
`endif

endmodule
