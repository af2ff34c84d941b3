// SPDX-License-Identifier: Apache-2.0
// pipegs_dopu: Dynamic Orthogonal Partitioning Unit: walks the scene by windows and layers and feeds the PUs.
//
// Paper   Sec. 3.2, Sec. 4.1, Fig. 7.
// Idea    dopu_axis and dopu_layer find the order of the slabs, dopu_windows the planes of each window or, where
//         dopu_load finds too much in it, of each of its parts, dopu_cells walks the cells, dopu_chunks finds their
//         chunks that can touch the window, dopu_origin brings these into view space, dopu_emit deals them out. Each
//         works ahead of the next; the walk of a window begins while the one before ends. Only wiring here.
// Stream  start_i with a constant frame_i; memory reads; chunk_o with one valid per PU. done_*: what the RUs have
//         finished. bad_o: the scene names what its tables do not hold; it stays, and the unit stops.
// Pace    One node test in three cycles; a chunk in ten.
// Model   cpp_model/dopu/dopu.hpp

module pipegs_dopu (
  input  logic                                             clk_i,
  input  logic                                             rst_ni,

  input  logic                                             start_i,   // one cycle, while not busy
  input  pipegs_pkg::frame_t                               frame_i,   // constant from start_i until the frame is done
  input  pipegs_pkg::areas_t                               areas_i,   // as frame_i
  output logic                                             busy_o,    // until the last end is taken
  output logic                                             active_o,  // needs a clock in this cycle
  output logic [1:0]                                       perf_o,    // 0 busy, 1 starved, 2 blocked, 3 memory
  output logic                                             bad_o,
  output logic [pipegs_pkg::AddressW-1:0]                  bad_line_o,  // of memory, which it concerns

  output logic                                             mem_valid_o,
  input  logic                                             mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]                  mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]                    mem_lines_o,  // less one
  input  logic                                             rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]                   rsp_data_i,

  input  logic [pipegs_pkg::Units*pipegs_pkg::Regions-1:0] done_i,    // of unit u: Regions bits from u * Regions on
  input  logic [pipegs_pkg::Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [pipegs_pkg::Units*pipegs_pkg::WindowW-1:0] done_y_i,
  input  pipegs_pkg::open_t                                open_i,    // the same as a rectangle

  output logic [pipegs_pkg::Units-1:0]                     chunk_valid_o,
  input  logic [pipegs_pkg::Units-1:0]                     chunk_ready_i,
  input  logic [pipegs_pkg::Units-1:0]                     chunk_room_i,  // PUs that one may choose for a chunk
  output pipegs_pkg::chunk_t                               chunk_o
);

  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned BurstW   = pipegs_pkg::BurstW;
  localparam int unsigned KindW    = pipegs_pkg::KindW;
  localparam int unsigned PlaceW   = pipegs_pkg::PlaceW;
  localparam int unsigned GridW    = pipegs_pkg::Grid > 1 ? $clog2(pipegs_pkg::Grid) : 1;
  localparam int unsigned NumberW  = pipegs_pkg::SlabCells > 1 ? $clog2(pipegs_pkg::SlabCells) : 1;
  localparam int unsigned CellW    = pipegs_pkg::TableCells > 1 ? $clog2(pipegs_pkg::TableCells) : 1;

  // --- the order of the slabs ---------------------------------------------------------------------------------------
  logic [1:0]         axis;
  logic               layer_ready, in_grid;
  logic [GridW:0]     step;
  logic [NumberW-1:0] number;
  logic [CellW-1:0]   cell_number;

  dopu_axis u_axis (
    .forward_x_i(frame_i.camera.rotation.w20),
    .forward_y_i(frame_i.camera.rotation.w21),
    .forward_z_i(frame_i.camera.rotation.w22),
    .axis_o(axis)
  );

  dopu_layer u_layer (
    .clk_i,
    .rst_ni,
    .start_i,
    .axis_i(axis),
    .position_i(frame_i.camera.position),
    .grid_i(frame_i.grid),
    .ready_o(layer_ready),
    .step_i(step),
    .inside_o(in_grid),
    .number_i(number),
    .cell_o(cell_number)
  );

  // --- windows and their planes: two sets, one ahead ----------------------------------------------------------------
  logic [1:0]           set_valid, set_last, set_done, set_ends, set_judges, set_given;
  logic [2*PlaceW-1:0]  set_place;
  logic [2*5*pipegs_pkg::PlaneBits-1:0] planes;
  logic                 window_walked, window_sent, done_news, judges, group_valid, counted, judged;
  logic                 split, parts;
  logic                 pair;  // both eyes are wanted
  logic [pipegs_pkg::CountW-1:0] group_chunks;
  logic [pipegs_pkg::LoadW-1:0]  group_near, group_far;

  dopu_windows u_windows (
    .clk_i,
    .rst_ni,
    .start_i,
    .rotation_i(frame_i.camera.rotation),
    .lens_i(frame_i.lens),
    .raster_i(frame_i.raster),
    .done_i,
    .done_x_i,
    .done_y_i,
    .open_i,
    .set_valid_o(set_valid),
    .set_last_o(set_last),
    .set_done_o(set_done),
    .done_news_o(done_news),
    .set_ends_o(set_ends),
    .set_place_o(set_place),
    .planes_o(planes),
    .walked_i(window_walked),
    .release_i(window_sent),
    .judges_i(judges),
    .set_judges_o(set_judges),
    .judged_i(judged),
    .split_i(split),
    .parts_i(parts),
    .set_given_o(set_given)
  );

  if (pipegs_pkg::HasWalks) begin : gen_load
    dopu_load u_load (
      .clk_i,
      .rst_ni,
      .most_i(frame_i.walk_most),
      .pair_i(pair),
      .judges_o(judges),
      .group_valid_i(group_valid),
      .group_chunks_i(group_chunks),
      .group_near_i(group_near),
      .group_far_i(group_far),
      .counted_i(counted),
      .judged_o(judged),
      .split_o(split),
      .parts_o(parts)
    );
  end else begin : gen_no_load
    assign judges = 1'b0;
    assign judged = 1'b0;
    assign split  = 1'b0;
    assign parts  = 1'b0;
    logic unused_load;
    assign unused_load = &{1'b0, group_valid, group_chunks, group_near, group_far, counted, pair};
  end

  // --- cells --------------------------------------------------------------------------------------------------------
  logic [2:0]            request, ready, answer;  // of memory: chunks, groups, cells
  typedef struct packed {logic [AddressW-1:0] cells, groups, chunks;} addresses_t;
  typedef struct packed {logic [BurstW-1:0] cells, groups, chunks;} lines_t;
  addresses_t            address;
  lines_t                lines;
  logic                  loading, walking, cell_valid, cell_ready, cell_set, cells_bad;
  logic [1:0]            nodes_bad;     // a cell, a group
  logic [2*AddressW-1:0] nodes_line;
  logic [KindW-1:0]      cell_kind;
  pipegs_pkg::node_t     cell_node;

  dopu_cells u_cells (
    .clk_i,
    .rst_ni,
    .start_i,
    .cells_i({areas_i.cells, frame_i.tables.cells}),
    .bad_o(cells_bad),
    .loading_o(loading),
    .mem_valid_o(request[2]),
    .mem_ready_i(ready[2]),
    .mem_address_o(address.cells),
    .mem_lines_o(lines.cells),
    .rsp_valid_i(answer[2]),
    .rsp_data_i,
    .layer_ready_i(layer_ready),
    .step_o(step),
    .inside_i(in_grid),
    .number_o(number),
    .cell_i(cell_number),
    .set_valid_i(set_valid),
    .set_last_i(set_last),
    .set_done_i(set_done),
    .walked_o(window_walked),
    .cell_valid_o(cell_valid),
    .cell_ready_i(cell_ready),
    .kind_o(cell_kind),
    .set_o(cell_set),
    .cell_o(cell_node),
    .walking_o(walking)
  );

  // --- cells -> chunks ----------------------------------------------------------------------------------------------
  logic                          awake, node_valid, node_ready, node_set, testing, waiting;
  logic [KindW-1:0]              node_kind;
  logic [pipegs_pkg::DepthW-1:0] node_mark;  // a layer end's watermark
  pipegs_pkg::node_t             node;

  logic [pipegs_pkg::StepW-1:0] lod;
  if (pipegs_pkg::Lod == 1) begin : gen_frame_lod
    assign lod = frame_i.lod;
  end else begin : gen_no_lod
    assign lod = '0;
  end

  logic [pipegs_pkg::TestEyesW-1:0]   test_eyes;
  logic [pipegs_pkg::ExpW-1:0]        eye_length;
  if (pipegs_pkg::Eyes > 1) begin : gen_eyes
    localparam int unsigned HalfW = pipegs_pkg::HalfEyeW;
    logic [1:0] one, eye;  // of either set of planes: for one eye alone, and for which
    for (genvar s = 0; s < 2; s += 1) begin : gen_set
      if (pipegs_pkg::HasWalks) begin : gen_walks
        assign one[s] = !pair || set_place[s*PlaceW + 2*pipegs_pkg::WindowW + 1];
        assign eye[s] = pair ? set_place[s*PlaceW + 2*pipegs_pkg::WindowW] : !frame_i.raster.eyes[0];
      end else begin : gen_whole
        assign one[s] = !pair;
        assign eye[s] = !frame_i.raster.eyes[0];
      end
    end
    assign pair       = frame_i.raster.eyes == '1;
    assign test_eyes  = {frame_i.eyes.length, frame_i.eyes.half_y[HalfW-1], frame_i.eyes.reach_y,
                         frame_i.eyes.half_x[HalfW-1], frame_i.eyes.reach_x, one, eye};
    assign eye_length = frame_i.eyes.length;
  end else begin : gen_one_eye
    assign pair       = 1'b0;
    assign test_eyes  = '0;
    assign eye_length = '0;
  end
  dopu_chunks u_chunks (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .position_i(frame_i.camera.position),
    .test_eyes_i(test_eyes),
    .near_plane_i(frame_i.lens.near_plane),
    .lod_i(lod),
    .groups_i({areas_i.groups, frame_i.tables.groups}),
    .chunks_i({areas_i.chunks, frame_i.tables.chunks}),
    .planes_i(planes),
    .set_done_i(set_done),
    .set_judges_i(set_judges),
    .cell_valid_i(cell_valid),
    .cell_ready_o(cell_ready),
    .cell_kind_i(cell_kind),
    .cell_set_i(cell_set),
    .cell_i(cell_node),
    .mem_valid_o(request[1:0]),
    .mem_ready_i(ready[1:0]),
    .mem_address_o({address.groups, address.chunks}),
    .mem_lines_o({lines.groups, lines.chunks}),
    .rsp_valid_i(answer[1:0]),
    .rsp_data_i,
    .chunk_valid_o(node_valid),
    .chunk_ready_i(node_ready),
    .chunk_kind_o(node_kind),
    .chunk_set_o(node_set),
    .chunk_o(node),
    .mark_o(node_mark),
    .group_valid_o(group_valid),
    .group_chunks_o(group_chunks),
    .group_near_o(group_near),
    .group_far_o(group_far),
    .counted_o(counted),
    .bad_o(nodes_bad),
    .bad_line_o(nodes_line),
    .testing_o(testing),
    .waiting_o(waiting)
  );

  pipegs_first_line #(.Ports(3)) u_bad (
    .valid_i({cells_bad, nodes_bad}),
    .line_i({frame_i.tables.cells, nodes_line}),
    .valid_o(bad_o),
    .line_o(bad_line_o)
  );

  dopu_memory u_memory (
    .clk_i,
    .rst_ni,
    .loading_i(loading),
    .request_i(request),
    .ready_o(ready),
    .address_i(address),
    .lines_i(lines),
    .answer_o(answer),
    .mem_valid_o,
    .mem_ready_i,
    .mem_address_o,
    .mem_lines_o,
    .rsp_valid_i
  );

  // --- chunks -> PUs ------------------------------------------------------------------------------------------------
  logic               chunk_valid, chunk_ready, last_end, walk_end, part_end;
  logic               given_up, to_origin, origin_ready, origin_active;
  pipegs_pkg::chunk_t chunk;

  dopu_origin u_origin (
    .clk_i,
    .rst_ni,
    .position_i(frame_i.camera.position),
    .rotation_i(frame_i.camera.rotation),
    .eye_length_i(eye_length),
    .node_valid_i(to_origin),
    .node_ready_o(origin_ready),
    .kind_i(part_end ? pipegs_pkg::KindPartEnd : node_kind),
    .place_i(node_set ? set_place[2*PlaceW-1:PlaceW] : set_place[PlaceW-1:0]),
    .node_i(node),
    .mark_i(node_mark),
    .chunk_valid_o(chunk_valid),
    .chunk_ready_i(chunk_ready),
    .chunk_o(chunk),
    .active_o(origin_active)
  );
  // Nothing of the walk needs its planes any more once its end has left the test.
  assign walk_end    = node_kind == pipegs_pkg::KindWindowEnd;
  assign part_end    = walk_end && !set_ends[node_set];
  assign given_up    = walk_end && set_given[node_set];  // nobody needs to know
  assign to_origin   = node_valid && !given_up;
  assign node_ready  = origin_ready || given_up;
  assign window_sent = node_valid && node_ready && walk_end;
  assign last_end    = chunk_valid && chunk_ready && chunk.kind == pipegs_pkg::KindWindowEnd
                       && (pipegs_pkg::HasLists || (chunk.window_x == frame_i.raster.windows.last_x &&
                           chunk.window_y == frame_i.raster.windows.last_y));

  dopu_emit u_emit (
    .clk_i,
    .rst_ni,
    .in_valid_i(chunk_valid),
    .in_ready_o(chunk_ready),
    .in_i(chunk),
    .chunk_valid_o,
    .chunk_ready_i,
    .chunk_room_i,
    .chunk_o
  );

  // --- busy, clock, counters ----------------------------------------------------------------------------------------
  dopu_activity u_activity (
    .clk_i,
    .rst_ni,
    .start_i,
    .moved_i(testing || walking || (node_valid && node_ready) || (chunk_valid && chunk_ready)),
    .memory_i(rsp_valid_i || (mem_valid_o && mem_ready_i)),
    .news_i(done_news),
    .waits_i(waiting || loading),
    .origin_i(origin_active),
    .chunk_valid_i(chunk_valid),
    .last_end_i(last_end),
    .out_valid_i(chunk_valid_o),
    .out_ready_i(chunk_ready_i),
    .out_room_i(chunk_room_i),
    .busy_o,
    .active_o,
    .perf_o
  );
  // Nothing else counts on a clock that stops. One that never does takes as many cycles this way.
  assign awake = pipegs_pkg::ClockGates != 0 || active_o;

  logic unused_areas;  // what others read
  assign unused_areas = &{1'b0, areas_i};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({node_kind, node_set, node}))) u_check_node (
    .clk_i,
    .rst_ni,
    .valid_i(to_origin),
    .ready_i(origin_ready),
    .beat_i({node_kind, node_set, node})
  );
`endif

endmodule
