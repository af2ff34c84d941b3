// SPDX-License-Identifier: Apache-2.0
// su_overflow: the way of a set that does not fit the pool: to external memory, sorted there, and back.
//
// Paper   None: its buffers hold every layer. Without it a scene could not be rendered whatever its layers hold.
// Idea    su_spill takes the set's records out, su_external sorts their keys up to the mark that ends the spill,
//         su_port writes and reads their lines. Only wiring here.
// Stream  records in; keys to and from the pool; sorted keys (item) out; lines to su_external and su_emit. mem: one
//         port that writes and reads.
// Pace    su_port's: one request in two cycles.
// Model   cpp_model/su/su.hpp: the order of what comes out does not depend on it.

module su_overflow #(
  localparam int unsigned KeyW      = pipegs_pkg::KeyW,
  localparam int unsigned RecordW   = pipegs_pkg::RecordW,
  localparam int unsigned NumberW   = pipegs_pkg::SlotW,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW   = pipegs_pkg::MemoryW
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic [pipegs_pkg::ExpW-1:0]  octave_i,
  input  pipegs_pkg::span_t            overflow_i,
  input  logic [pipegs_pkg::UnitW-1:0] unit_i,

  input  logic                         start_i,    // the present set spills
  input  logic                         drained_i,  // nothing older is inside
  input  logic                         empty_i,    // no slot is taken: so it is when keys come back (asserted)
  input  logic                         ended_i,
  input  logic                         mark_valid_i,
  input  pipegs_pkg::su_mark_t         mark_i,
  input  logic                         done_i,     // the mark has left
  output logic                         stay_o,     // the set goes on spilling ...
  output logic                         refills_o,  // ... or what is left is looked up, then ...
  output logic                         returns_o,  // ... what is left comes out of su_emit, and goes to the pool
  output logic                         end_o,      // ... or nothing of it is in memory
  output logic                         job_valid_o,
  input  logic                         job_done_i,
  output logic                         divert_o,   // what su_emit gives goes to memory
  output logic                         spilled_o,  // the sorter's keys are of this set ...
  output logic                         keep_o,     // ... which is still being sorted
  output logic                         sent_o,     // all its keys have left

  input  logic                         record_valid_i,
  output logic                         record_ready_o,
  input  logic [SplatBits-1:0]         record_i,
  input  logic                         back_valid_i,
  output logic                         back_ready_o,
  input  logic [SplatBits-1:0]         back_i,

  output pipegs_pkg::su_external_t     external_o,     // to the stores
  input  logic [KeyW-1:0]              key_i,          // a key that was read there
  output logic                         group_valid_o,  // keys there are to be sorted
  output pipegs_pkg::su_group_t        group_o,
  output logic                         item_valid_o,   // sorted keys of the last merge, or what returns
  input  logic                         item_ready_i,
  output logic [KeyW-1:0]              item_key_o,
  output logic [RecordW-1:0]           item_slot_o,
  input  logic                         kept_valid_i,   // sorted keys before it, with their records' numbers
  output logic                         kept_ready_o,
  input  logic [KeyW-1:0]              kept_key_i,
  input  logic [NumberW-1:0]           kept_number_i,

  input  logic                         read_valid_i,  // su_emit reads a record
  output logic                         read_ready_o,
  input  logic [NumberW-1:0]           read_line_i,
  output logic                         line_valid_o,
  input  logic                         line_ready_i,
  output logic [SplatBits-1:0]         line_o,

  output logic                         mem_valid_o,
  input  logic                         mem_ready_i,
  output logic                         mem_write_o,
  output logic [AddressW-1:0]          mem_address_o,
  output logic [MemoryW-1:0]           mem_data_o,
  input  logic                         rsp_valid_i,
  input  logic [MemoryW-1:0]           rsp_data_i,
  output logic                         full_o,     // see su_port
  output logic [AddressW-1:0]          full_line_o,
  output logic                         written_o,  // a line was written

  output logic                         waits_o,   // for memory
  output logic                         moves_o,
  output logic                         active_o   // of the port
);

  localparam int unsigned WayW = $clog2(pipegs_pkg::SuWays);

  logic                 open, closed, again, refill, returned, external_active, spill_active, fetch_list, fetch_area;
  logic                 line_record_valid, line_record_ready, keys_valid, keys_ready, run_valid, run_ready, run_area;
  logic                 fetch_valid, fetch_ready, line_taken, line_shown, line_fetch, fetched_taken;
  logic [WayW-1:0]      fetch_way, line_way;
  logic [NumberW-1:0]   spill_count, listed, rest, record_line, keys_line, run_line, fetch_line;
  logic [SplatBits-1:0] line_record;
  logic [MemoryW-1:0]   keys, run, line;

  su_spill u_spill (
    .clk_i,
    .rst_ni,
    .start_i,
    .drained_i,
    .ended_i,
    .job_valid_o,
    .job_done_i,
    .divert_o,
    .open_o(open),
    .listed_o(listed),
    .closed_o(closed),
    .done_i,
    .mark_all_i(mark_i.all),
    .rest_i(rest),
    .again_o(again),
    .stay_o,
    .refill_o(refill),
    .returned_i(returned),
    .end_o,
    .in_valid_i(record_valid_i),
    .in_ready_o(record_ready_o),
    .in_i(record_i),
    .back_valid_i,
    .back_ready_o,
    .back_i,
    .count_o(spill_count),
    .record_valid_o(line_record_valid),
    .record_ready_i(line_record_ready),
    .record_line_o(record_line),
    .record_o(line_record),
    .keys_valid_o(keys_valid),
    .keys_ready_i(keys_ready),
    .keys_line_o(keys_line),
    .keys_o(keys),
    .active_o(spill_active)
  );
  assign spilled_o = open;

  su_external u_external (
    .clk_i,
    .rst_ni,
    .octave_i,
    .start_i,
    .open_i(open),
    .listed_i(listed),
    .closed_i(closed),
    .count_i(spill_count),
    .mark_valid_i,
    .mark_i,
    .sent_o,
    .rest_o(rest),
    .again_i(again),
    .stay_i(stay_o),
    .refill_i(refill),
    .end_i(end_o),
    .idle_i(drained_i),
    .refills_o,
    .returns_o,
    .returned_o(returned),
    .read_valid_o(fetch_valid),
    .read_ready_i(fetch_ready),
    .read_list_o(fetch_list),
    .read_area_o(fetch_area),
    .read_line_o(fetch_line),
    .read_way_o(fetch_way),
    .line_valid_i(line_shown && line_fetch),
    .line_ready_o(fetched_taken),
    .line_way_i(line_way),
    .line_i(line),
    .run_valid_o(run_valid),
    .run_ready_i(run_ready),
    .run_area_o(run_area),
    .run_line_o(run_line),
    .run_o(run),
    .pool_o(external_o),
    .pool_key_i(key_i),
    .group_valid_o,
    .group_o,
    .item_valid_o,
    .item_ready_i,
    .item_key_o,
    .item_slot_o,
    .keep_o,
    .kept_valid_i,
    .kept_ready_o,
    .kept_key_i,
    .kept_number_i,
    .active_o(external_active)
  );

  su_port u_port (
    .clk_i,
    .rst_ni,
    .overflow_i,
    .unit_i,
    .record_valid_i(line_record_valid),
    .record_ready_o(line_record_ready),
    .record_line_i(record_line),
    .record_i(line_record),
    .keys_valid_i(keys_valid),
    .keys_ready_o(keys_ready),
    .keys_line_i(keys_line),
    .keys_i(keys),
    .run_valid_i(run_valid),
    .run_ready_o(run_ready),
    .run_area_i(run_area),
    .run_line_i(run_line),
    .run_i(run),
    .fetch_valid_i(fetch_valid),
    .fetch_ready_o(fetch_ready),
    .fetch_list_i(fetch_list),
    .fetch_area_i(fetch_area),
    .fetch_line_i(fetch_line),
    .fetch_way_i(fetch_way),
    .read_valid_i,
    .read_ready_o,
    .read_line_i,
    .line_valid_o(line_shown),
    .line_ready_i(line_taken),
    .line_fetch_o(line_fetch),
    .line_way_o(line_way),
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
    .overflow_o(written_o),
    .waits_o,
    .active_o
  );
  assign line_valid_o = line_shown && !line_fetch;
  assign line_taken   = line_fetch ? fetched_taken : line_ready_i;
  assign line_o       = line[SplatBits-1:0];
  assign moves_o      = external_active || spill_active;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!group_valid_o || empty_i);
  pipegs_stream_check #(.DataW($bits(line_o))) u_check_line (
    .clk_i,
    .rst_ni,
    .valid_i(line_valid_o),
    .ready_i(line_ready_i),
    .beat_i(line_o)
  );
  pipegs_stream_check #(.DataW($bits(line))) u_check_fetched (
    .clk_i,
    .rst_ni,
    .valid_i(line_shown && line_fetch),
    .ready_i(fetched_taken),
    .beat_i(line)
  );
`else
  logic unused_empty;
  assign unused_empty = empty_i;
`endif

endmodule
