// SPDX-License-Identifier: Apache-2.0
// dopu_descend: from the cells of the walk down to the chunks that can touch the window.
//
// Paper   Sec. 4.1.
// Idea    Three levels, cell, group, chunk, share one box test. A cell that passes sends for its groups, a group that
//         passes for its chunks (pipegs_line_reader: several lines in flight). Upper levels go first as long as their
//         results have room, so that the memory always has work; a node enters the test only when a place for its
//         result is reserved. Order is kept within each level, hence the chunks leave in the order of the nested loops.
//         Ends pass through all levels in their turn. What belongs to a done window is dropped wherever it stands, but
//         for a chunk that is shown already.
// Stream  cell in; chunk out: a chunk's node that passed, or an end, with its set of planes.
// Pace    One test in three cycles.
// Model   cpp_model/dopu/dopu.hpp (the inner loops)

module dopu_descend #(
  parameter int unsigned Lines   = pipegs_pkg::DescendLines,
  parameter int unsigned Results = pipegs_pkg::DescendResults
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  awake_i,  // the unit's clock does not stand, or would not

  input  pipegs_pkg::position_t                 position_i,
  input  logic [pipegs_pkg::TestEyesW-1:0]        test_eyes_i,  // of dopu_test; one eye: 0
  input  logic [pipegs_pkg::WorldW-1:0]         near_plane_i,
  input  pipegs_pkg::span_t                     groups_i,  // the tables
  input  pipegs_pkg::span_t                     chunks_i,
  input  logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_i,
  input  logic [1:0]                            set_done_i,

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

  output logic [1:0]                            bad_o,         // a cell, a group: see pipegs_line_reader
  output logic [2*pipegs_pkg::AddressW-1:0]     bad_line_o,
  output logic                                  testing_o,     // a node waits for its turn in the test, or is dropped
  output logic                                  waiting_o      // a level waits for the memory
);

  localparam int unsigned Levels = 3;
  localparam int unsigned NodeBits = pipegs_pkg::NodeBits;
  localparam int unsigned KindW = pipegs_pkg::KindW;
  localparam int unsigned BeatW = NodeBits + KindW + 1;  // set, kind, node
  localparam int unsigned ReservedW = $clog2(Results + 1);
  localparam int unsigned TagW = 2 + KindW + 1;          // level, set, kind

  // --- the three streams of nodes: cells, groups, chunks -----------------------------------------------------------
  logic [Levels-1:0] node_valid, node_ready, is_done, want, enter, drop, missed, popped;
  logic [BeatW-1:0]  beat [Levels];
  logic [ReservedW-1:0] reserved_q [Levels];
  logic [BeatW-1:0]  test_beat;
  logic [1:0]        test_level;
  logic              test_valid, test_ready;

  assign node_valid[0] = cell_valid_i;
  assign beat[0]       = {cell_set_i, cell_kind_i, cell_i};
  assign cell_ready_o  = node_ready[0];

  always_comb begin
    for (int unsigned l = 0; l < Levels; l += 1) begin
      is_done[l] = set_done_i[beat[l][BeatW-1]] && beat[l][BeatW-2:NodeBits] == pipegs_pkg::KindData;
      drop[l]    = node_valid[l] && is_done[l];
      want[l]    = node_valid[l] && !is_done[l] && reserved_q[l] != ReservedW'(Results);
    end
    enter      = '0;
    test_level = '0;
    test_beat  = beat[0];
    if (want[0]) begin
      enter[0] = test_ready;
    end else if (want[1]) begin
      enter[1]   = test_ready;
      test_level = 2'd1;
      test_beat  = beat[1];
    end else if (want[2]) begin
      enter[2]   = test_ready;
      test_level = 2'd2;
      test_beat  = beat[2];
    end
  end
  assign test_valid = want != '0;
  assign node_ready = enter | drop;
  assign testing_o  = test_valid || drop != '0;

  // --- the test -----------------------------------------------------------------------------------------------------
  logic              result_valid, result_pass;
  logic [TagW-1:0]   result_tag;
  logic [1:0]        result_level;
  logic [KindW-1:0]  result_kind;
  logic              result_set, result_kept;
  pipegs_pkg::node_t result_node;

  dopu_test #(.TagW(TagW)) u_test (
    .clk_i,
    .rst_ni,
    .awake_i,
    .position_i,
    .test_eyes_i,
    .near_plane_i,
    .planes_i,
    .node_valid_i(test_valid),
    .node_ready_o(test_ready),
    .node_i(test_beat[NodeBits-1:0]),
    .set_i(test_beat[BeatW-1]),
    .tight_i(1'b0),
    .scale_i('0),
    .tag_i({test_level, test_beat[BeatW-1:NodeBits]}),
    .result_valid_o(result_valid),
    .result_pass_o(result_pass),
    .result_node_o(result_node),
    .result_tag_o(result_tag),
    .result_nearest_o(),
    .result_farthest_o(),
    .result_exponent_o()
  );
  assign {result_level, result_set, result_kind} = result_tag;
  assign result_kept = result_pass || result_kind != pipegs_pkg::KindData;

  // --- results: one queue per level; a place is reserved from the entry into the test on ----------------------------
  logic [Levels-1:0] kept_valid, kept_ready, push, queue_ready;
  logic [BeatW-1:0]  kept [Levels];

  generate
    for (genvar l = 0; l < Levels; l += 1) begin : gen_results
      logic [ReservedW-1:0] held;
      assign push[l]   = result_valid && result_level == 2'(l) && result_kept;
      assign missed[l] = result_valid && result_level == 2'(l) && !result_kept;
      assign popped[l] = kept_valid[l] && kept_ready[l];

      pipegs_fifo #(.DataW(BeatW), .Depth(Results)) u_queue (
        .clk_i,
        .rst_ni,
        .in_valid_i(push[l]),
        .in_ready_o(queue_ready[l]),
        .in_i({result_set, result_kind, result_node}),
        .out_valid_o(kept_valid[l]),
        .out_ready_i(kept_ready[l]),
        .out_o(kept[l]),
        .count_o(held)
      );
      logic unused_held;
      assign unused_held = &{1'b0, held, queue_ready[l]};

      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) reserved_q[l] <= '0;
        else reserved_q[l] <= reserved_q[l] + ReservedW'(enter[l]) - ReservedW'(missed[l]) - ReservedW'(popped[l]);
      end
`ifndef SYNTHESIS
      always_ff @(posedge clk_i) if (rst_ni) assert (!push[l] || queue_ready[l]);
`endif
    end
  endgenerate

  // --- readers: a cell's groups, a group's chunks -------------------------------------------------------------------
  logic [1:0]        waiting, idle;
  pipegs_pkg::node_t parent_cell, parent_group;
  logic [pipegs_pkg::SlotW-1:0]  first [2];
  logic [pipegs_pkg::CountW-1:0] count [2];

  assign parent_cell  = kept[0][NodeBits-1:0];
  assign parent_group = kept[1][NodeBits-1:0];
  assign first[0]     = parent_cell.first;
  assign first[1]     = parent_group.first;
  assign count[0]     = parent_cell.count;
  assign count[1]     = parent_group.count;

  typedef struct packed {  // of both readers
    logic [1:0][pipegs_pkg::AddressW-1:0] address, bad;
    logic [1:0][pipegs_pkg::BurstW-1:0]   lines;
  } ports_t;
  ports_t ports;
  assign {mem_address_o, bad_line_o, mem_lines_o} = ports;

  generate
    for (genvar l = 0; l < 2; l += 1) begin : gen_readers
      logic              parent_data, parent_done, job_ready, out_read;
      logic [KindW:0]    out_tag;
      logic [pipegs_pkg::SlotW-1:0] out_index;
      logic              out_last;
      logic [NodeBits-1:0] out_node;

      assign parent_data = kept[l][BeatW-2:NodeBits] == pipegs_pkg::KindData;
      assign parent_done = parent_data && set_done_i[kept[l][BeatW-1]];
      assign kept_ready[l] = job_ready || parent_done;

      pipegs_line_reader #(.TagW(KindW + 1), .ItemW(NodeBits), .ItemsPerLine(2), .Lines(Lines),
        .Jobs(pipegs_pkg::DescendJobs)) u_reader (
        .clk_i,
        .rst_ni,
        .table_i(l == 0 ? groups_i : chunks_i),
        .job_valid_i(kept_valid[l] && !parent_done),
        .job_ready_o(job_ready),
        .job_read_i(parent_data),
        .job_first_i(first[l]),
        .job_count_i(count[l]),
        .job_tag_i(kept[l][BeatW-1:NodeBits]),
        .mem_valid_o(mem_valid_o[l]),
        .mem_ready_i(mem_ready_i[l]),
        .mem_address_o(ports.address[l]),
        .mem_lines_o(ports.lines[l]),
        .rsp_valid_i(rsp_valid_i[l]),
        .rsp_data_i,
        .out_valid_o(node_valid[l+1]),
        .out_ready_i(node_ready[l+1]),
        .out_read_o(out_read),
        .out_index_o(out_index),
        .out_last_o(out_last),
        .out_tag_o(out_tag),
        .out_item_o(out_node),
        .bad_o(bad_o[l]),
        .bad_line_o(ports.bad[l]),
        .waiting_o(waiting[l]),
        .idle_o(idle[l])
      );
      assign beat[l+1] = {out_tag, out_node};

      logic unused_reader;
      assign unused_reader = &{1'b0, out_read, out_index, out_last};
    end
  endgenerate
  assign waiting_o = waiting != '0;

  // --- chunks that passed -------------------------------------------------------------------------------------------
  logic chunk_done, shown_q;  // shown: a chunk once shown is not taken back, even if its window is done now
  assign chunk_kind_o  = kept[2][BeatW-2:NodeBits];
  assign chunk_set_o   = kept[2][BeatW-1];
  assign chunk_o       = kept[2][NodeBits-1:0];
  assign chunk_done    = chunk_kind_o == pipegs_pkg::KindData && set_done_i[chunk_set_o] && !shown_q;
  assign chunk_valid_o = kept_valid[2] && !chunk_done;
  assign kept_ready[2] = chunk_ready_i || chunk_done;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) shown_q <= 1'b0;
    else shown_q <= chunk_valid_o && !chunk_ready_i;
  end

  logic unused;
  assign unused = &{1'b0, idle, parent_cell, parent_group};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({chunk_kind_o, chunk_set_o, chunk_o}))) u_check_chunk (
    .clk_i,
    .rst_ni,
    .valid_i(chunk_valid_o),
    .ready_i(chunk_ready_i),
    .beat_i({chunk_kind_o, chunk_set_o, chunk_o})
  );
`endif

endmodule
