// SPDX-License-Identifier: Apache-2.0
// pipegs_su: a Sorting Unit: collects splats and sends them nearest first.
//
// Paper   Sec. 4.2.2: MinMax Finder, Pivot-based Splitter, 16-channel Bitonic Sorter; Sec. 4.1 for the overlap of
//         layers.
// Idea    One pool of slots. su_gather gives a record a slot and puts it into its bucket of depth; an end releases the
//         buckets before it, nearest first, as chains: chain -> su_sort -> su_output, which frees the slots one by one.
//         Ends walk along in the same queues, so many layers live at once. A set that alone fills the pool goes to
//         external memory until the next end, and through the same path store by store (su_overflow); what the end does
//         not release returns as input. With Overflow 0 there is no such set.
//         Only wiring here.
// Stream  in: splats in any order, then an end beat. out: the same splats by {depth, index}, then the end beat. A
//         layer's end is a watermark if there are any: no later splat of the window is nearer than its depth; it comes
//         out behind the splats of nearer buckets. mem: only overflow. active_o low: nothing would change in this
//         cycle.
// Pace    2 to 4 cycles per splat over all (docs/units/su.md); the memory stays idle while sets fit the pool.
// Model   cpp_model/su/su.hpp

module pipegs_su (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  pipegs_pkg::span_t                overflow_i,  // constant while a set is inside
  input  logic [pipegs_pkg::UnitW-1:0]     unit_i,
  input  logic [pipegs_pkg::ExpW-1:0]      octave_i,    // in which the buckets of depth begin; constant in a frame

  input  logic                             in_valid_i,
  output logic                             in_ready_o,
  input  pipegs_pkg::splat_t               in_i,

  output logic                             out_valid_o,
  input  logic                             out_ready_i,
  output pipegs_pkg::splat_t               out_o,

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
  output logic                             full_o,      // an area of the overflow has no room: see su_port
  output logic [pipegs_pkg::AddressW-1:0]  full_line_o,
  output logic                             overflow_o  // a line was written to external memory
);

  localparam int unsigned KeyW      = pipegs_pkg::KeyW;
  localparam int unsigned RecordW   = pipegs_pkg::RecordW;
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits;

  // --- splats -> chains ---------------------------------------------------------------------------------------------
  logic                     write, free, empty, chain_valid, chain_ready, split_idle, link, link_ready;
  logic                     mark_valid, mark_first, mark_ready, drained, settled, gather_moves;
  logic                     spill_start, spill_valid, spill_ready, spill_ended, spill_sent, spill_done, job_valid;
  logic                     job_done, spill_stay, refills, returns, refill_ready;
  logic [RecordW-1:0]       slot, free_slot, link_slot, link_to;
  logic                     back_valid;
  pipegs_pkg::splat_t       record, emitted;
  pipegs_pkg::su_chain_t    chain;
  pipegs_pkg::su_mark_t     mark;

  su_gather u_gather (
    .clk_i,
    .rst_ni,
    .octave_i,
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .write_o(write),
    .slot_o(slot),
    .record_o(record),
    .free_i(free),
    .free_slot_i(free_slot),
    .empty_o(empty),
    .chain_valid_o(chain_valid),
    .chain_ready_i(chain_ready),
    .chain_o(chain),
    .split_idle_i(split_idle),
    .link_o(link),
    .link_ready_i(link_ready),
    .link_slot_o(link_slot),
    .link_to_o(link_to),
    .mark_valid_o(mark_valid),
    .mark_o(mark),
    .mark_first_i(mark_first),
    .mark_ready_i(mark_ready),
    .spilling_o,
    .spill_start_o(spill_start),
    .spill_valid_o(spill_valid),
    .spill_ready_i(spill_ready),
    .spill_ended_o(spill_ended),
    .spill_stay_i(spill_stay),
    .renew_i(refills),
    .returns_i(returns),
    .back_valid_i(back_valid),
    .back_ready_o(refill_ready),
    .back_i(emitted),
    .spill_done_i(spill_done),
    .job_valid_i(job_valid),
    .job_done_o(job_done),
    .drained_i(drained),
    .settled_o(settled),
    .moves_o(gather_moves)
  );

  // --- the stores ---------------------------------------------------------------------------------------------------
  logic                     sort_read, sort_claim, sort_write, payload_busy, payload_read;
  logic [RecordW-1:0]       sort_slot, sort_write_slot, sort_write_link, stored_link, payload_slot;
  logic [KeyW-1:0]          stored_key;
  logic [SplatBits-pipegs_pkg::KindW-KeyW-1:0] payload;
  pipegs_pkg::su_external_t external;

  su_stores u_stores (
    .clk_i,
    .rst_ni,
    .write_i(write),
    .slot_i(slot),
    .record_i(record),
    .external_i(external),
    .link_i(link),
    .link_ready_o(link_ready),
    .link_slot_i(link_slot),
    .link_to_i(link_to),
    .split_claim_i(sort_claim),
    .split_link_i(sort_write),
    .split_link_slot_i(sort_write_slot),
    .split_link_to_i(sort_write_link),
    .split_read_i(sort_read),
    .split_slot_i(sort_slot),
    .split_key_o(stored_key),
    .split_link_o(stored_link),
    .busy_o(payload_busy),
    .payload_read_i(payload_read),
    .payload_slot_i(payload_slot),
    .payload_o(payload)
  );

  // --- chains -> sorted keys ----------------------------------------------------------------------------------------
  logic                     group_valid, sorted_valid, item_valid, item_ready, sort_idle, sort_moves;
  pipegs_pkg::su_group_t    group;
  pipegs_pkg::su_item_t     sorted, item;

  su_sort u_sort (
    .clk_i,
    .rst_ni,
    .octave_i,
    .chain_valid_i(chain_valid),
    .chain_ready_o(chain_ready),
    .chain_i(chain),
    .group_valid_i(group_valid),
    .group_i(group),
    .read_o(sort_read),
    .slot_o(sort_slot),
    .key_i(stored_key),
    .link_i(stored_link),
    .claim_o(sort_claim),
    .write_o(sort_write),
    .write_slot_o(sort_write_slot),
    .write_link_o(sort_write_link),
    .item_valid_o(sorted_valid),
    .item_ready_i(item_ready),
    .item_o(sorted),
    .split_idle_o(split_idle),
    .idle_o(sort_idle),
    .moves_o(sort_moves)
  );

  // --- sorted keys -> splats ----------------------------------------------------------------------------------------
  logic                     merged_valid;  // the key comes from a merge in external memory; the sorter is empty then
  logic [KeyW-1:0]          merged_key;
  logic [RecordW-1:0]       merged_slot;
  logic                     divert, spilled, keep, all_sent, kept_valid, kept_ready, back_ready;
  logic                     output_empty, output_moves, emitted_valid, emitted_ready;
  logic                     read_valid, read_ready, line_valid, line_ready;
  logic [pipegs_pkg::SlotW-1:0] read_line, kept_number;
  logic [SplatBits-1:0]     line;

  assign item_valid = sorted_valid || merged_valid;
  assign item       = merged_valid ? {1'b0, merged_key, merged_slot} : sorted;

  su_output u_output (
    .clk_i,
    .rst_ni,
    .item_valid_i(item_valid),
    .item_ready_o(item_ready),
    .item_i(item),
    .spilled_i(spilled),
    .keep_i(keep),
    .all_sent_i(all_sent),
    .mark_valid_i(mark_valid),
    .mark_i(mark),
    .mark_first_o(mark_first),
    .mark_ready_o(mark_ready),
    .done_o(spill_sent),
    .kept_valid_o(kept_valid),
    .kept_ready_i(kept_ready),
    .kept_number_o(kept_number),
    .read_valid_o(read_valid),
    .read_ready_i(read_ready),
    .read_line_o(read_line),
    .line_valid_i(line_valid),
    .line_ready_o(line_ready),
    .line_i(line),
    .record_busy_i(payload_busy),
    .record_read_o(payload_read),
    .record_slot_o(payload_slot),
    .record_i(payload),
    .free_o(free),
    .free_slot_o(free_slot),
    .divert_i(divert || returns),
    .back_valid_o(back_valid),
    .back_ready_i(returns ? refill_ready : back_ready),
    .out_valid_o(emitted_valid),
    .out_ready_i(emitted_ready),
    .out_o(emitted),
    .empty_o(output_empty),
    .moves_o(output_moves)
  );
  assign drained = settled && sort_idle && output_empty;

  pipegs_skid #(.DataW(SplatBits)) u_skid (  // while the store of records is written, the next ones are there
    .clk_i,
    .rst_ni,
    .in_valid_i(emitted_valid),
    .in_ready_o(emitted_ready),
    .in_i(emitted),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );

  // --- a set that spills --------------------------------------------------------------------------------------------
  logic                     overflow_moves, port_active, port_waits;

  if (pipegs_pkg::Overflow != 0) begin : gen_overflow
    su_overflow u_overflow (
      .clk_i,
      .rst_ni,
      .octave_i,
      .overflow_i,
      .unit_i,
      .start_i(spill_start),
      .drained_i(drained),
      .empty_i(empty),
      .ended_i(spill_ended),
      .mark_valid_i(mark_valid),
      .mark_i(mark),
      .done_i(spill_sent),
      .stay_o(spill_stay),
      .refills_o(refills),
      .returns_o(returns),
      .end_o(spill_done),
      .job_valid_o(job_valid),
      .job_done_i(job_done),
      .divert_o(divert),
      .spilled_o(spilled),
      .keep_o(keep),
      .sent_o(all_sent),
      .record_valid_i(spill_valid),
      .record_ready_o(spill_ready),
      .record_i(record),
      .back_valid_i(back_valid),
      .back_ready_o(back_ready),
      .back_i(emitted),
      .external_o(external),
      .key_i(stored_key),
      .group_valid_o(group_valid),
      .group_o(group),
      .item_valid_o(merged_valid),
      .item_ready_i(item_ready),
      .item_key_o(merged_key),
      .item_slot_o(merged_slot),
      .kept_valid_i(kept_valid),
      .kept_ready_o(kept_ready),
      .kept_key_i(item.key),
      .kept_number_i(kept_number),
      .read_valid_i(read_valid),
      .read_ready_o(read_ready),
      .read_line_i(read_line),
      .line_valid_o(line_valid),
      .line_ready_i(line_ready),
      .line_o(line),
      .mem_valid_o,
      .mem_ready_i,
      .mem_write_o,
      .mem_address_o,
      .mem_data_o,
      .rsp_valid_i,
      .rsp_data_i,
      .full_o,
      .full_line_o,
      .written_o(overflow_o),
      .waits_o(port_waits),
      .moves_o(overflow_moves),
      .active_o(port_active)
    );
  end else begin : gen_room
    assign {job_valid, divert, spilled, keep, all_sent, spill_ready, kept_ready, back_ready, group_valid} = '0;
    assign {merged_valid, merged_key, merged_slot} = '0;
    assign {read_ready, line_valid, line, spill_stay, refills, returns, spill_done} = '0;
    assign {mem_valid_o, mem_write_o, mem_address_o, mem_data_o} = '0;
    assign {overflow_o, port_waits, overflow_moves, port_active} = '0;
    assign {full_o, full_line_o} = '0;
    assign external = '0;
    assign group    = '0;
    logic unused_overflow;
    assign unused_overflow = &{1'b0, overflow_i, unit_i, mem_ready_i, rsp_valid_i, rsp_data_i, record, job_done, empty,
                               spill_start, spill_ended, spill_sent, spill_valid, kept_valid, read_valid, read_line,
                               line_ready, kept_number};
  end

  // --- what the unit does in this cycle -----------------------------------------------------------------------------
  logic moves;
  assign moves    = gather_moves || sort_moves || output_moves || overflow_moves || (out_valid_o && out_ready_i);
  assign active_o = moves || port_active || (in_valid_i && in_ready_o);
  always_comb begin
    perf_o = pipegs_pkg::PerfStarved;
    if (out_valid_o && !out_ready_i) perf_o = pipegs_pkg::PerfBlocked;
    if (port_waits) perf_o = pipegs_pkg::PerfMemory;
    if (moves) perf_o = pipegs_pkg::PerfBusy;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!external.write || (!write && !link));
  always_ff @(posedge clk_i) if (rst_ni) assert (!external.read || !sort_read);
  always_ff @(posedge clk_i) if (rst_ni) assert (!merged_valid || !sorted_valid);
  pipegs_stream_check #(.DataW($bits(item))) u_check_item (
    .clk_i,
    .rst_ni,
    .valid_i(item_valid),
    .ready_i(item_ready),
    .beat_i(item)
  );
`endif

endmodule
