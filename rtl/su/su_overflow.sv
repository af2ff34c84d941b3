// SPDX-License-Identifier: Apache-2.0
// su_overflow: the way of a set that does not fit the pool: to external memory, and back in parts that fit.
//
// Paper   None: its buffers hold every layer. Without it a scene could not be rendered whatever its layers hold.
// Idea    su_spill takes the set's records out, su_select brings their keys back store by store, su_port writes and
//         reads their lines. Only wiring here.
// Stream  records in; keys back into the stores; lines to su_select and su_emit. mem: one port that writes and reads.
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
  input  logic [AddressW-1:0]          overflow_i,  // first line of the overflow areas
  input  logic [pipegs_pkg::UnitW-1:0] unit_i,

  input  logic                         start_i,    // the present set spills
  input  logic                         drained_i,  // nothing older is inside
  input  logic                         empty_i,    // no slot is taken: so it is when the set comes back (asserted)
  input  logic                         ended_i,
  input  logic                         done_i,     // its last mark has left
  output logic                         job_valid_o,
  input  logic                         job_done_i,
  output logic                         divert_o,     // what su_emit gives goes to memory
  output logic                         selecting_o,  // the set comes back
  output logic                         all_sent_o,   // all of it has been selected

  input  logic                         record_valid_i,
  output logic                         record_ready_o,
  input  logic [SplatBits-1:0]         record_i,
  input  logic                         back_valid_i,
  output logic                         back_ready_o,
  input  logic [SplatBits-1:0]         back_i,

  output pipegs_pkg::su_selected_t     selected_o,     // to the stores
  output logic                         group_valid_o,  // the store is filled
  output pipegs_pkg::su_group_t        group_o,
  input  logic                         sorted_i,  // nothing is being sorted
  input  logic                         sent_i,    // nor sent

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
  output logic                         written_o,  // a line was written

  output logic                         waits_o,   // for memory
  output logic                         moves_o,
  output logic                         active_o   // of the port
);

  logic                 select_start, select_active, select_read, select_turn, select_line_ready;
  logic                 spill_active, read_ready, write_claim, write;
  logic                 line_record_valid, line_record_ready, keys_valid, keys_ready;
  logic [NumberW-1:0]   spill_count, record_line, keys_line, select_line, write_number;
  logic [RecordW-1:0]   write_slot;
  logic [RecordW:0]     group_count;
  logic [KeyW-1:0]      spill_min, spill_max, write_key, group_min, group_max;
  logic [SplatBits-1:0] line_record;
  logic [MemoryW-1:0]   keys, line;

  su_spill u_spill (
    .clk_i, .rst_ni, .start_i, .drained_i, .ended_i, .job_valid_o, .job_done_i,
    .divert_o, .selecting_o, .select_start_o(select_start), .done_i,
    .in_valid_i(record_valid_i), .in_ready_o(record_ready_o), .in_i(record_i),
    .back_valid_i, .back_ready_o, .back_i, .count_o(spill_count), .min_o(spill_min), .max_o(spill_max),
    .record_valid_o(line_record_valid), .record_ready_i(line_record_ready), .record_line_o(record_line),
    .record_o(line_record),
    .keys_valid_o(keys_valid), .keys_ready_i(keys_ready), .keys_line_o(keys_line), .keys_o(keys),
    .active_o(spill_active)
  );

  su_select u_select (
    .clk_i, .rst_ni, .start_i(select_start), .count_i(spill_count), .min_i(spill_min), .max_i(spill_max),
    .idle_o(all_sent_o), .active_o(select_active),
    .read_valid_o(select_read), .read_ready_i(read_ready && select_read), .read_line_o(select_line),
    .line_valid_i(line_valid_o && select_turn), .line_ready_o(select_line_ready), .line_i(line),
    .write_claim_o(write_claim), .write_o(write), .write_slot_o(write_slot), .write_key_o(write_key),
    .write_number_o(write_number), .group_o(group_valid_o), .group_count_o(group_count), .group_min_o(group_min),
    .group_max_o(group_max), .group_done_i(sorted_i)
  );
  assign selected_o = {write_claim, write, write_slot, write_key, write_number};
  assign group_o    = {group_count, group_min, group_max};

  su_port u_port (
    .clk_i, .rst_ni, .overflow_i, .unit_i,
    .record_valid_i(line_record_valid), .record_ready_o(line_record_ready), .record_line_i(record_line),
    .record_i(line_record),
    .keys_valid_i(keys_valid), .keys_ready_o(keys_ready), .keys_line_i(keys_line), .keys_i(keys),
    .read_valid_i(select_read || read_valid_i), .read_ready_o(read_ready), .read_keys_i(select_read),
    .read_line_i(select_read ? select_line : read_line_i),
    .line_valid_o, .line_ready_i(select_turn ? select_line_ready : line_ready_i), .line_o(line),
    .mem_valid_o, .mem_ready_i, .mem_write_o, .mem_address_o, .mem_data_o, .rsp_valid_i, .rsp_data_i,
    .overflow_o(written_o), .waits_o, .active_o
  );

  // The first line in flight is one of keys: all records that were asked for were sent.
  assign select_turn  = selecting_o && sent_i && sorted_i;
  assign read_ready_o = read_ready && !select_read;
  assign line_o       = line[SplatBits-1:0];
  assign moves_o      = select_active || spill_active;

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) select_start |-> empty_i);
`else
  logic unused_empty;
  assign unused_empty = empty_i;
`endif

endmodule
