// SPDX-License-Identifier: Apache-2.0
// su_external: merge sort in external memory of the keys of a set that does not fit the pool, up to a mark.
//
// Paper   None: its buffers hold every layer.
// Idea    su_runs sorts the keys before the mark pool by pool, su_lines writes what was sorted as runs, su_levels has
//         su_ways and su_tree merge them until the last merge sends its keys. What is left is read again for the next
//         mark, or shown to return to the pool. Only wiring here.
// Stream  A list of keys in; keys to and from the pool, and groups that are to be sorted there; item: keys of the merge
//         with their slots, nearest first. Both are kept in runs (kept) while keep_o.
// Pace    Of the splitter for each key, then its tree's for each merge.
// Model   The whole SU is tested against cpp_model/su/su.hpp.

module su_external #(
  localparam int unsigned KeyW    = pipegs_pkg::KeyW,
  localparam int unsigned RecordW = pipegs_pkg::RecordW,
  localparam int unsigned SlotW   = pipegs_pkg::SlotW,
  localparam int unsigned MemoryW = pipegs_pkg::MemoryW,
  localparam int unsigned WayW    = $clog2(pipegs_pkg::SuWays)
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [pipegs_pkg::ExpW-1:0] octave_i,

  input  logic                     start_i,   // a set begins to spill
  input  logic                     open_i,    // the pool is empty
  input  logic [SlotW-1:0]         listed_i,  // whole lines of its list that are in memory
  input  logic                     closed_i,  // the list is complete
  input  logic [SlotW-1:0]         count_i,   // keys of the list then
  input  logic                     mark_valid_i,
  input  pipegs_pkg::su_mark_t     mark_i,
  output logic                     sent_o,
  output logic [SlotW-1:0]         rest_o,    // keys that are left then
  input  logic                     again_i,   // the mark has left: what is left is read again, ...
  input  logic                     stay_i,    // ... for the next mark
  input  logic                     refill_i,  // ... to return to the pool
  input  logic                     end_i,     // nothing is left
  input  logic                     idle_i,    // nothing is behind the sorter
  output logic                     refills_o, // what returns is looked up
  output logic                     returns_o, // items are of what returns
  output logic                     returned_o,

  output logic                     read_valid_o,
  input  logic                     read_ready_i,
  output logic                     read_list_o,  // of the list, else of a run
  output logic                     read_area_o,
  output logic [SlotW-1:0]         read_line_o,
  output logic [WayW-1:0]          read_way_o,
  input  logic                     line_valid_i,
  output logic                     line_ready_o,
  input  logic [WayW-1:0]          line_way_i,
  input  logic [MemoryW-1:0]       line_i,

  output logic                     run_valid_o,  // a line of a run is written
  input  logic                     run_ready_i,
  output logic                     run_area_o,
  output logic [SlotW-1:0]         run_line_o,
  output logic [MemoryW-1:0]       run_o,

  output pipegs_pkg::su_external_t pool_o,
  input  logic [KeyW-1:0]          pool_key_i,
  output logic                     group_valid_o,
  output pipegs_pkg::su_group_t    group_o,

  output logic                     item_valid_o,
  input  logic                     item_ready_i,
  output logic [KeyW-1:0]          item_key_o,
  output logic [RecordW-1:0]       item_slot_o,

  output logic                     keep_o,
  input  logic                     kept_valid_i,
  output logic                     kept_ready_o,
  input  logic [KeyW-1:0]          kept_key_i,
  input  logic [SlotW-1:0]         kept_number_i,

  output logic                     active_o
);

  localparam int unsigned LevelW = $clog2(WayW + 1);

  logic               forms, lists, form_done, form_read, form_ready, form_write, form_active;
  logic [SlotW-1:0]   form_line, form_number, formed, run_line;
  logic [RecordW-1:0] form_slot, return_slot;
  logic [KeyW-1:0]    form_key;
  logic               restart, merge_begin, written, lines_active, return_valid;

  assign lists = forms || refill_i;

  su_runs u_runs (
    .clk_i,
    .rst_ni,
    .octave_i,
    .start_i,
    .again_i,
    .refill_i(!stay_i),
    .open_i,
    .listed_i,
    .closed_i,
    .count_i,
    .mark_valid_i,
    .mark_i,
    .done_o(form_done),
    .formed_o(formed),
    .rest_o,
    .read_valid_o(form_read),
    .read_ready_i(lists && read_ready_i),
    .read_line_o(form_line),
    .line_valid_i(lists && line_valid_i),
    .line_ready_o(form_ready),
    .line_i,
    .write_o(form_write),
    .write_slot_o(form_slot),
    .write_key_o(form_key),
    .write_number_o(form_number),
    .group_valid_o,
    .group_o,
    .written_i(written),
    .idle_i,
    .refills_o,
    .returns_o,
    .returned_o,
    .item_valid_o(return_valid),
    .item_ready_i,
    .item_slot_o(return_slot),
    .active_o(form_active)
  );

  logic               setup, merge, merged, levels_active;
  logic [WayW-1:0]    setup_way;
  logic [SlotW-1:0]   setup_line, setup_keys, merge_keys;
  logic [LevelW-1:0]  tree;

  su_levels u_levels (
    .clk_i,
    .rst_ni,
    .start_i(start_i || stay_i),
    .run_i(group_valid_o),
    .formed_i(form_done && open_i),
    .count_i(formed),
    .done_i(end_i),
    .setup_o(setup),
    .setup_way_o(setup_way),
    .setup_line_o(setup_line),
    .setup_keys_o(setup_keys),
    .merge_o(merge),
    .tree_o(tree),
    .merged_i(merged),
    .restart_o(restart),
    .begin_o(merge_begin),
    .begin_keys_o(merge_keys),
    .written_i(written),
    .written_lines_i(run_line),
    .way_i(read_way_o),
    .way_area_o(read_area_o),
    .write_area_o(run_area_o),
    .forms_o(forms),
    .keep_o,
    .sent_o,
    .active_o(levels_active)
  );

  logic               ways_read, ways_ready, ways_write, tree_read, tree_release, tree_valid, ways_active, tree_active;
  logic [1:0]         ready;
  logic [WayW-1:0]    way;
  logic [SlotW-1:0]   ways_line, ways_number;
  logic [RecordW-1:0] ways_slot, tree_slot, tree_item;
  logic [KeyW-1:0]    ways_key;

  su_ways u_ways (
    .clk_i,
    .rst_ni,
    .setup_i(setup),
    .setup_way_i(setup_way),
    .setup_line_i(setup_line),
    .setup_keys_i(setup_keys),
    .read_valid_o(ways_read),
    .read_ready_i(!lists && read_ready_i),
    .read_line_o(ways_line),
    .read_way_o,
    .line_valid_i(!lists && line_valid_i),
    .line_ready_o(ways_ready),
    .line_way_i,
    .line_i,
    .write_o(ways_write),
    .write_slot_o(ways_slot),
    .write_key_o(ways_key),
    .write_number_o(ways_number),
    .way_i(way),
    .ready_o(ready),
    .release_i(tree_release),
    .active_o(ways_active)
  );

  su_tree u_tree (
    .clk_i,
    .rst_ni,
    .setup_i(setup),
    .setup_way_i(setup_way),
    .setup_keys_i(setup_keys),
    .start_i(merge),
    .levels_i(tree),
    .way_o(way),
    .ready_i(ready),
    .release_o(tree_release),
    .read_o(tree_read),
    .read_slot_o(tree_slot),
    .key_i(pool_key_i),
    .item_valid_o(tree_valid),
    .item_ready_i,
    .item_key_o,
    .item_slot_o(tree_item),
    .idle_o(merged),
    .active_o(tree_active)
  );

  su_lines u_lines (
    .clk_i,
    .rst_ni,
    .restart_i(restart),
    .begin_i(group_valid_o || merge_begin),
    .count_i(forms ? SlotW'(group_o.count) : merge_keys),
    .key_valid_i(kept_valid_i),
    .key_ready_o(kept_ready_o),
    .key_i(kept_key_i),
    .number_i(kept_number_i),
    .line_valid_o(run_valid_o),
    .line_ready_i(run_ready_i),
    .line_number_o(run_line),
    .line_o(run_o),
    .idle_o(written),
    .active_o(lines_active)
  );

  assign read_valid_o = form_read || ways_read;
  assign read_list_o  = lists;
  assign read_line_o  = lists ? form_line : ways_line;
  assign line_ready_o = lists ? form_ready : ways_ready;
  assign run_line_o   = run_line;
  assign pool_o       = {form_write || ways_write, lists ? form_slot : ways_slot, lists ? form_key : ways_key,
                         lists ? form_number : ways_number, tree_read, tree_slot};
  assign item_valid_o = tree_valid || return_valid;
  assign item_slot_o  = returns_o ? return_slot : tree_item;
  assign active_o     = form_active || levels_active || ways_active || tree_active || lines_active;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(item_slot_o))) u_check_item (
    .clk_i,
    .rst_ni,
    .valid_i(item_valid_o),
    .ready_i(item_ready_i),
    .beat_i(item_slot_o)
  );
  pipegs_stream_check #(.DataW($bits({read_list_o, read_area_o, read_line_o, read_way_o}))) u_check_read (
    .clk_i,
    .rst_ni,
    .valid_i(read_valid_o),
    .ready_i(read_ready_i),
    .beat_i({read_list_o, read_area_o, read_line_o, read_way_o})
  );
  pipegs_stream_check #(.DataW($bits(line_i))) u_check_runs (
    .clk_i,
    .rst_ni,
    .valid_i(lists && line_valid_i),
    .ready_i(form_ready),
    .beat_i(line_i)
  );
  pipegs_stream_check #(.DataW($bits(line_i))) u_check_ways (
    .clk_i,
    .rst_ni,
    .valid_i(!lists && line_valid_i),
    .ready_i(ways_ready),
    .beat_i(line_i)
  );
`endif

endmodule
