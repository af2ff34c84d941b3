// SPDX-License-Identifier: Apache-2.0
// dopu_nearest: from the cells of the walk down to the chunks that can touch the window, the nearest first.
//
// Paper   None: instead of dopu_descend, with watermarks.
// Idea    Best first: cells, groups and chunks that pass the test (dopu_rank) wait in dopu_bucket by depth; the nearest
//         cell and the nearest group are opened (dopu_open), the nearest chunk is sent (dopu_send). Opening runs ahead
//         of sending, so that the memory's latency hides, as long as few chunks wait; a chunk is sent when nothing that
//         is still closed, or being opened, can hide a nearer one. When the queue is full a node is not queued but sent
//         or opened at once: right too, only out of order. Scanning cells, opening cells, opening groups and sending
//         each go on to the next window when they are through with one, so two windows overlap. What belongs to a done
//         window is dropped wherever it stands. Of a window on trial (set_judges_i) groups are shown, and wait.
// Stream  cell in, and the window's end; chunk out: chunks, layer ends with a watermark, the window's end.
// Pace    One test a cycle; a node that passes costs the queue five.
// Model   cpp_model/dopu/nearest/dopu_nearest.hpp

module dopu_nearest #(
  parameter int unsigned Lines   = pipegs_pkg::NearestLines,
  parameter int unsigned Results = pipegs_pkg::NearestResults,
  parameter int unsigned Most    = pipegs_pkg::NearestOpen,
  parameter int unsigned Ahead   = pipegs_pkg::NearestAhead
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  awake_i,  // the unit's clock does not stand, or would not

  input  pipegs_pkg::position_t                 position_i,
  input  logic [pipegs_pkg::TestEyesW-1:0]        test_eyes_i,  // of dopu_test; one eye: 0
  input  logic [pipegs_pkg::WorldW-1:0]         near_plane_i,
  input  logic [pipegs_pkg::StepW-1:0]          lod_i,     // of the frame
  input  pipegs_pkg::span_t                     groups_i,  // the tables
  input  pipegs_pkg::span_t                     chunks_i,
  input  logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_i,
  input  logic [1:0]                            set_done_i,
  input  logic [1:0]                            set_judges_i,

  input  logic                                  cell_valid_i,
  output logic                                  cell_ready_o,
  input  logic [pipegs_pkg::KindW-1:0]          cell_kind_i,
  input  logic                                  cell_set_i,
  input  pipegs_pkg::node_t                     cell_i,

  output logic [1:0]                            mem_valid_o,   // 0: groups, 1: chunks
  input  logic [1:0]                            mem_ready_i,
  output logic [2*pipegs_pkg::AddressW-1:0]     mem_address_o,
  output logic [2*pipegs_pkg::BurstW-1:0]       mem_lines_o,     // less one
  input  logic [1:0]                            rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]        rsp_data_i,

  output logic                                  chunk_valid_o,
  input  logic                                  chunk_ready_i,
  output logic [pipegs_pkg::KindW-1:0]          chunk_kind_o,
  output logic                                  chunk_set_o,
  output pipegs_pkg::node_t                     chunk_o,
  output logic [pipegs_pkg::DepthW-1:0]         mark_o,        // a layer end's watermark

  output logic                                  group_valid_o,   // of a set on trial: a group passes, ...
  output logic [pipegs_pkg::CountW-1:0]         group_chunks_o,  // ... its chunks,
  output logic [pipegs_pkg::LoadW-1:0]          group_near_o,    // ... where in depth it begins,
  output logic [pipegs_pkg::LoadW-1:0]          group_far_o,     // ... and ends
  output logic                                  counted_o,       // all groups were shown
  output logic [1:0]                            bad_o,         // a cell, a group: see pipegs_line_reader
  output logic [2*pipegs_pkg::AddressW-1:0]     bad_line_o,
  output logic                                  testing_o,     // something moves inside
  output logic                                  waiting_o      // a level waits for the memory
);

  localparam int unsigned Levels = 3;       // cells, groups, chunks
  localparam int unsigned Lists = 2 * Levels;  // of the queue: of each level those of either set
  localparam int unsigned ListW = $clog2(Lists);
  localparam int unsigned BucketW = pipegs_pkg::BucketW;
  localparam int unsigned NodeBits = pipegs_pkg::NodeBits;
  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned CountW = pipegs_pkg::CountW;
  localparam int unsigned PlaceW = pipegs_pkg::NodePlaceW;
  localparam int unsigned RangeW = pipegs_pkg::ChildrenW + SlotW;  // of a parent's children; of a chunk's less
  localparam int unsigned ChunkRangeW = CountW + SlotW;
  localparam int unsigned DataW = ChunkRangeW + PlaceW;
  localparam int unsigned StepW = pipegs_pkg::StepW;
  localparam int unsigned ScaleW = pipegs_pkg::ScaleW;
  localparam int unsigned ReservedW = $clog2(Results + 1);
  localparam int unsigned WaitW = $clog2(pipegs_pkg::NearestNodes + 1);

  logic [StepW-1:0] near_step;
  dopu_depth #(.ValueW(pipegs_pkg::WorldW + 1), .Down(0)) u_near (
    .value_i({1'b0, near_plane_i}),
    .exponent_i('0),
    .step_o(near_step)
  );

  // --- each level works on one window's set, and then on the other's: 0 scans cells, 1 opens cells, 2 opens groups ---
  logic [Levels-1:0] set_q, through, working, level_done;  // the set at work; through: nothing of it is left here
  logic [1:0]        complete_q [Levels];                  // the levels that are through with a set
  logic              cells_in_q;                           // all cells of the window scanned have come
  logic              cell_here, send_set, window_end, judges, held_back;  // the set of level 1, of level 2 is on trial

  assign {held_back, judges} = {set_judges_i[set_q[2]], set_judges_i[set_q[1]]};
  assign cell_here = cell_valid_i && cell_set_i == set_q[0] && !cells_in_q && working[0];

  always_comb begin
    for (int unsigned l = 0; l < Levels; l += 1) begin
      working[l]    = !complete_q[l][set_q[l]];  // else the other set is still being sent
      level_done[l] = set_done_i[set_q[l]];
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      set_q      <= '0;
      cells_in_q <= 1'b0;
      for (int unsigned l = 0; l < Levels; l += 1) complete_q[l] <= '0;
    end else begin
      if (cell_here && cell_kind_i == pipegs_pkg::KindWindowEnd) cells_in_q <= 1'b1;
      else if (through[0]) cells_in_q <= 1'b0;
      for (int unsigned l = 0; l < Levels; l += 1) begin
        if (window_end) complete_q[l][send_set] <= 1'b0;
        if (through[l]) begin
          complete_q[l][set_q[l]] <= 1'b1;
          set_q[l] <= !set_q[l];
        end
      end
    end
  end

  // --- nodes to test: upper levels first, so that the memory always has work ----------------------------------------
  logic [Levels-1:0]    want, enter, drop, child_valid, child_last, missed, retired;
  logic [NodeBits-1:0]  child [Levels];
  logic [BucketW-1:0]   child_parent [Levels];
  logic [ReservedW-1:0] reserved_q [Levels];  // places for results
  logic                 rank_ready;
  logic [1:0]           level;

  assign child_valid[0]  = cell_here && cell_kind_i == pipegs_pkg::KindData;
  assign child_last[0]   = 1'b0;
  assign child_parent[0] = '0;
  assign child[0]        = cell_i;
  assign cell_ready_o    = enter[0] || drop[0] || (cell_here && cell_kind_i != pipegs_pkg::KindData);

  always_comb begin
    for (int unsigned l = 0; l < Levels; l += 1) begin
      // the last child goes on: its parent is open until then
      drop[l] = child_valid[l] && level_done[l] && !child_last[l];
      want[l] = child_valid[l] && !drop[l] && reserved_q[l] != ReservedW'(Results);
    end
    level = want[0] ? 2'd0 : want[1] ? 2'd1 : 2'd2;
    enter = '0;
    enter[level] = want[level] && rank_ready;
  end

  // Which box counts is known before it is known whose turn it is.
  logic [Levels-1:0]  tight;
  logic [ScaleW-1:0]  scale [Levels];
  for (genvar l = 0; l < Levels; l += 1) begin : gen_hull
    if (pipegs_pkg::TightBoxes != 0) begin : gen_tight
      dopu_hull u_hull (
        .node_i(child[l]),
        .near_step_i(near_step),
        .parent_i(child_parent[l]),
        .tight_o(tight[l]),
        .scale_o(scale[l])
      );
    end else begin : gen_means
      assign tight[l] = 1'b0;
      assign scale[l] = '0;
    end
  end

  logic               result_valid, result_pass, result_last, result_kept;
  logic [1:0]         result_level;
  logic [BucketW-1:0] result_bucket;
  logic [PlaceW-1:0]  result_place;
  logic [RangeW-1:0]  result_range;  // of a parent the children that are opened

  dopu_rank u_rank (
    .clk_i,
    .rst_ni,
    .awake_i,
    .position_i,
    .test_eyes_i,
    .near_plane_i,
    .planes_i,
    .near_step_i(near_step),
    .node_valid_i(want != '0),
    .node_ready_o(rank_ready),
    .node_i(child[level]),
    .set_i(set_q[level]),
    .parent_i(child_parent[level]),
    .tight_i(tight[level]),
    .scale_i(scale[level]),
    .last_i(child_last[level]),
    .level_i(level),
    .lod_i,
    .result_valid_o(result_valid),
    .result_pass_o(result_pass),
    .result_last_o(result_last),
    .result_level_o(result_level),
    .result_bucket_o(result_bucket),
    .result_far_o(group_far_o),
    .result_place_o(result_place),
    .result_range_o(result_range)
  );
  assign group_valid_o  = result_valid && result_pass && result_level == 2'd1 && judges;
  assign group_chunks_o = result_range[SlotW +: CountW];
  assign group_near_o   = result_bucket[BucketW-1 -: pipegs_pkg::LoadW];
  assign counted_o      = through[1] && judges;
  assign result_kept    = result_pass || result_last;

  // --- results: one queue per level, so that no level waits for one above it ----------------------------------------
  logic [Levels-1:0]  held_valid, held_pass, held_last, live, queue_ready, push;
  logic [BucketW-1:0] held_bucket [Levels];
  logic [DataW-1:0]   held [Levels];

  generate
    for (genvar l = 0; l < Levels; l += 1) begin : gen_results
      localparam int unsigned HeldW = l == 2 ? DataW : RangeW;  // of chunks the place matters, too
      logic [HeldW-1:0]     result_data, held_data;
      logic [BucketW-1:0]   bucket;
      logic [ReservedW-1:0] count;

      assign push[l]   = result_valid && result_level == 2'(l) && result_kept;
      assign missed[l] = result_valid && result_level == 2'(l) && !result_kept;
      if (l == 2) begin : gen_chunk
        assign result_data = {result_range[ChunkRangeW-1:0], result_place};
        assign held[l]     = held_data;
      end else begin : gen_parent
        assign result_data = result_range;
        assign held[l]     = {held_data, {(DataW - RangeW){1'b0}}};
      end

      pipegs_fifo #(.DataW(2 + BucketW + HeldW), .Depth(Results)) u_queue (
        .clk_i,
        .rst_ni,
        .in_valid_i(push[l]),
        .in_ready_o(queue_ready[l]),
        .in_i({result_last, result_pass, result_bucket, result_data}),
        .out_valid_o(held_valid[l]),
        .out_ready_i(retired[l]),
        .out_o({held_last[l], held_pass[l], bucket, held_data}),
        .count_o(count)
      );
      assign held_bucket[l] = bucket;
      assign live[l]        = held_valid[l] && held_pass[l] && !level_done[l];

      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) reserved_q[l] <= '0;
        else reserved_q[l] <= reserved_q[l] +
                              ReservedW'(enter[l]) - ReservedW'(missed[l]) - ReservedW'(held_valid[l] && retired[l]);
      end
      wire unused_bits = &{1'b0, count, held_last[l]};
    end
  endgenerate

  // --- the queue: live results go in; when it is full they are opened or sent at once -------------------------------
  logic                     insert_ready, full, crowded, pop_valid, pop_ready, out_valid, queue_idle, insert, out_done;
  logic [1:0]               insert_level, out_level;
  logic [ListW-1:0]         insert_list, pop_list, out_list;
  logic [BucketW-1:0]       out_bucket;
  logic [DataW-1:0]         out_data;
  logic [Lists-1:0]         first_valid;
  typedef struct packed {logic [Lists-1:0][BucketW-1:0] of;} buckets_t;
  buckets_t first_bucket;
  logic [Levels-1:0]        direct, some;      // some: cells that wait for level 1, groups for level 2, its chunks
  logic [BucketW-1:0]       first [Levels];
  logic                     direct_chunk, direct_ready, send_pop;
  logic [WaitW-1:0]         waiting_q [2];     // chunks of either set in the queue
  logic [1:0]               open_ready, open_valid, any_open, pop_open, reading;
  logic [BucketW-1:0]       open_nearest [2], open_bucket [2];
  logic [RangeW-1:0]        open_range [2];

  assign insert_level = live[2] ? 2'd2 : live[1] ? 2'd1 : 2'd0;
  assign insert_list  = {insert_level, set_q[insert_level]};
  assign insert       = live != '0 && insert_ready;

  dopu_bucket #(.Lists(Lists), .DataW(DataW)) u_bucket (
    .clk_i,
    .rst_ni,
    .insert_valid_i(live != '0),
    .insert_ready_o(insert_ready),
    .insert_list_i(insert_list),
    .insert_bucket_i(held_bucket[insert_level]),
    .insert_data_i(held[insert_level]),
    .full_o(full),
    .crowded_o(crowded),
    .pop_valid_i(pop_valid),
    .pop_ready_o(pop_ready),
    .pop_list_i(pop_list),
    .out_valid_o(out_valid),
    .out_list_o(out_list),
    .out_bucket_o(out_bucket),
    .out_data_o(out_data),
    .first_valid_o(first_valid),
    .first_bucket_o(first_bucket),
    .idle_o(queue_idle)
  );
  assign out_level = out_list[2:1];
  assign out_done  = set_done_i[out_list[0]];

  // A pop that is wanted goes first: it makes room. Nodes of the next window wait for their turn.
  assign direct_chunk = full && queue_idle && live[2] && set_q[2] == send_set;
  always_comb begin
    direct    = '0;
    direct[2] = direct_chunk && direct_ready;
    for (int unsigned l = 0; l < 2; l += 1) begin
      direct[l] = full && queue_idle && !pop_valid && live[l] && open_ready[l] && set_q[l] == set_q[l+1];
    end
    if (held_back) direct[1] = 1'b0;
    for (int unsigned l = 0; l < Levels; l += 1) begin
      retired[l] = held_valid[l] && (!live[l] || direct[l] || (insert && insert_level == 2'(l)));
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      for (int unsigned s = 0; s < 2; s += 1) waiting_q[s] <= '0;
    end else begin
      for (int unsigned s = 0; s < 2; s += 1) begin
        waiting_q[s] <= waiting_q[s] + WaitW'(insert && insert_list == ListW'(4 + s)) - WaitW'(out_valid &&
                        out_list == ListW'(4 + s));
      end
    end
  end

  // --- opening: the nearest cell, the nearest group; ahead while there is room, and always before the chunks behind --
  logic few, cell_first, group_first;
  always_comb begin
    for (int unsigned l = 0; l < Levels; l += 1) begin
      some[l]  = first_valid[{2'(l), set_q[l == 0 ? 1 : 2]}];
      first[l] = first_bucket.of[{2'(l), set_q[l == 0 ? 1 : 2]}];
    end
  end
  assign few         = 32'(waiting_q[set_q[2]]) < Ahead && !crowded;
  assign group_first = !some[2] || first[1] <= first[2];
  assign cell_first  = set_q[1] == set_q[2] && (!some[2] || first[0] <= first[2]) &&
                       (!some[1] || held_back || first[0] <= first[1]);
  assign pop_open[0] = some[0] && (level_done[1] || (open_ready[0] && (!crowded || cell_first)));
  assign pop_open[1] = some[1] && (level_done[2] || (!held_back && open_ready[1] && (few || group_first)));
  assign pop_valid   = send_pop || pop_open != '0;
  assign pop_list    = send_pop ? {2'd2, send_set} : pop_open[1] ? {2'd1, set_q[2]} : {2'd0, set_q[1]};
  typedef struct packed {  // of both readers
    logic [1:0][pipegs_pkg::AddressW-1:0] address, bad;
    logic [1:0][pipegs_pkg::BurstW-1:0]   lines;
  } ports_t;
  ports_t ports;
  assign {mem_address_o, bad_line_o, mem_lines_o} = ports;

  generate
    for (genvar l = 0; l < 2; l += 1) begin : gen_open
      assign open_valid[l]  = (out_valid && out_level == 2'(l) && !out_done) || direct[l];
      assign open_bucket[l] = out_valid ? out_bucket : held_bucket[l];
      assign open_range[l]  = out_valid ? out_data[DataW-1 -: RangeW] : held[l][DataW-1 -: RangeW];

      dopu_open #(.Most(Most), .Lines(Lines)) u_open (
        .clk_i,
        .rst_ni,
        .table_i(l == 0 ? groups_i : chunks_i),
        .open_valid_i(open_valid[l]),
        .open_ready_o(open_ready[l]),
        .open_bucket_i(open_bucket[l]),
        .open_first_i(open_range[l][SlotW-1:0]),
        .open_count_i(open_range[l][RangeW-1:SlotW]),
        .mem_valid_o(mem_valid_o[l]),
        .mem_ready_i(mem_ready_i[l]),
        .mem_address_o(ports.address[l]),
        .mem_lines_o(ports.lines[l]),
        .rsp_valid_i(rsp_valid_i[l]),
        .rsp_data_i,
        .child_valid_o(child_valid[l+1]),
        .child_ready_i(enter[l+1] || drop[l+1]),
        .child_o(child[l+1]),
        .child_parent_o(child_parent[l+1]),
        .child_last_o(child_last[l+1]),
        .settled_i(retired[l+1] && held_last[l+1]),
        .any_o(any_open[l]),
        .nearest_o(open_nearest[l]),
        .bad_o(bad_o[l]),
        .bad_line_o(ports.bad[l]),
        .waiting_o(reading[l])
      );
    end
  endgenerate

  assign through[0] = cells_in_q && reserved_q[0] == '0;
  assign through[1] = working[1] && complete_q[0][set_q[1]] && !some[0] && !any_open[0];
  assign through[2] = working[2] && complete_q[1][set_q[2]] && !some[1] && !any_open[1];

  // --- sending ------------------------------------------------------------------------------------------------------
  typedef struct packed {logic [BucketW-1:0] group_waiting, group_open, cell_waiting, cell_open;} unopened_t;
  unopened_t unopened;  // the nearest ones of the window sent

  always_comb begin
    unopened = {first[1], open_nearest[1], first[0], open_nearest[0]};
    if (complete_q[1][send_set]) {unopened.cell_waiting, unopened.cell_open} = '1;  // else levels 1 and 2 work on it
    if (!some[0]) unopened.cell_waiting = '1;
    if (!some[1]) unopened.group_waiting = '1;
    if (!complete_q[0][send_set]) unopened.cell_open = '0;  // cells are still to come
  end

  dopu_send u_send (
    .clk_i,
    .rst_ni,
    .near_step_i(near_step),
    .set_done_i,
    .set_o(send_set),
    .opened_i(complete_q[2][send_set]),
    .unopened_i(unopened),
    .window_end_o(window_end),
    .first_valid_i(first_valid[5:4]),
    .first_bucket_i({first_bucket.of[5], first_bucket.of[4]}),
    .pop_o(send_pop),
    .pop_ready_i(pop_ready),
    .popped_i(out_valid && out_level == 2'd2),
    .popped_data_i(out_data),
    .direct_valid_i(direct_chunk),
    .direct_ready_o(direct_ready),
    .direct_bucket_i(held_bucket[2]),
    .direct_data_i(held[2]),
    .chunk_valid_o,
    .chunk_ready_i,
    .chunk_kind_o,
    .chunk_set_o,
    .chunk_o,
    .mark_o
  );

  assign testing_o = want != '0 || drop != '0 || cell_ready_o || !queue_idle || retired != '0 || pop_valid ||
                     through != '0 || window_end;
  assign waiting_o = reading != '0;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert ((push & ~queue_ready) == '0 && (open_valid & ~open_ready) == '0);
`endif

endmodule
