// dopu: Dynamic Orthogonal Partitioning Unit: walks the scene window by window, layer by layer, and feeds the PUs.
//
// Paper   Sec. 3.2, Sec. 4.1, Fig. 7.
// Idea    dopu_axis and dopu_layer find the order of the slabs, dopu_windows the planes of each window, dopu_cells walks the
//         cells, dopu_descend finds their chunks that can touch the window (with Order 2 dopu_nearest, nearest first),
//         dopu_origin brings these into view space, dopu_emit deals them out. Each works ahead of the next; the walk of a window begins while the one before ends.
// Stream  start_i with a constant frame_i; memory reads; chunk_o with one valid per PU. done_*: what the RUs have finished.
// Pace    One node test in three cycles; a chunk in ten.
// Model   cpp_model/dopu/dopu.hpp

module dopu (
  input  logic                                             clk_i,
  input  logic                                             rst_ni,

  input  logic                                             start_i,   // one cycle, while not busy
  input  pipegs_pkg::frame_t                               frame_i,   // constant from start_i until the frame is done
  output logic                                             busy_o,    // until the last end is taken
  output logic                                             active_o,  // needs a clock in this cycle
  output logic [1:0]                                       perf_o,    // 0 busy, 1 starved, 2 blocked, 3 memory

  output logic                                             mem_valid_o,
  input  logic                                             mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]                  mem_address_o,
  input  logic                                             rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]                   rsp_data_i,

  input  logic [pipegs_pkg::Units*pipegs_pkg::Regions-1:0] done_i,    // of unit u: Regions bits from u * Regions on
  input  logic [pipegs_pkg::Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [pipegs_pkg::Units*pipegs_pkg::WindowW-1:0] done_y_i,

  output logic [pipegs_pkg::Units-1:0]                     chunk_valid_o,
  input  logic [pipegs_pkg::Units-1:0]                     chunk_ready_i,
  output pipegs_pkg::chunk_t                               chunk_o
);

  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned KindW = pipegs_pkg::KindW;
  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned GridW = pipegs_pkg::Grid > 1 ? $clog2(pipegs_pkg::Grid) : 1;
  localparam int unsigned Lines = pipegs_pkg::Order == 2 ? 64 : 32;  // of node tables in flight, each level
  localparam int unsigned Ports = 3;          // of memory: chunks, groups, cells
  localparam int unsigned Asked = 2 * Lines;  // answers of chunks and groups to come

  // --- the frame's geometry ---------------------------------------------------------------------------------------------
  logic [1:0]           axis;
  logic                 layer_ready, in_grid;
  logic [GridW:0]       step;
  logic [2*GridW-1:0]   number;
  logic [3*GridW-1:0]   cell_number;

  dopu_axis u_axis (.forward_x_i(frame_i.w20), .forward_y_i(frame_i.w21), .forward_z_i(frame_i.w22), .axis_o(axis));

  dopu_layer u_layer (
    .clk_i, .rst_ni, .start_i, .axis_i(axis), .frame_i, .ready_o(layer_ready),
    .step_i(step), .inside_o(in_grid), .number_i(number), .cell_o(cell_number)
  );

  logic [1:0]                          set_valid, set_last, set_done;
  logic [2*WindowW-1:0]                set_x, set_y;
  logic [2*5*pipegs_pkg::PlaneBits-1:0] planes;
  logic                                window_walked, window_sent, done_news;

  dopu_windows u_windows (
    .clk_i, .rst_ni, .start_i, .frame_i, .done_i, .done_x_i, .done_y_i,
    .set_valid_o(set_valid), .set_last_o(set_last), .set_done_o(set_done), .done_news_o(done_news), .set_x_o(set_x), .set_y_o(set_y),
    .planes_o(planes), .walked_i(window_walked), .release_i(window_sent)
  );

  // --- cells, groups, chunks -----------------------------------------------------------------------------------------------
  logic [Ports-1:0]          request, grant, request_ready;
  logic [Ports*AddressW-1:0] address;
  logic                      loading, cell_valid, cell_ready, cell_set, cells_rsp;
  logic [1:0]                level_rsp;
  logic [KindW-1:0]          cell_kind;
  pipegs_pkg::node_t         cell_node, chunk_node;
  logic                      node_valid, node_ready, node_set, testing, waiting, walking;
  logic [KindW-1:0]          node_kind;
  logic [pipegs_pkg::DepthW-1:0] node_mark;  // a layer end's watermark

  dopu_cells u_cells (
    .clk_i, .rst_ni, .start_i, .cells_i(frame_i.cells), .loading_o(loading),
    .mem_valid_o(request[2]), .mem_ready_i(request_ready[2]), .mem_address_o(address[2*AddressW +: AddressW]),
    .rsp_valid_i(cells_rsp), .rsp_data_i,
    .layer_ready_i(layer_ready), .step_o(step), .inside_i(in_grid), .number_o(number), .cell_i(cell_number),
    .set_valid_i(set_valid), .set_last_i(set_last), .set_done_i(set_done), .walked_o(window_walked),
    .cell_valid_o(cell_valid), .cell_ready_i(cell_ready), .kind_o(cell_kind), .set_o(cell_set), .cell_o(cell_node),
    .walking_o(walking)
  );

  if (pipegs_pkg::Order == 2) begin : gen_nearest
    dopu_nearest #(.Lines(Lines)) u_nearest (
      .clk_i, .rst_ni, .frame_i, .planes_i(planes), .set_done_i(set_done),
      .cell_valid_i(cell_valid), .cell_ready_o(cell_ready), .cell_kind_i(cell_kind), .cell_set_i(cell_set), .cell_i(cell_node),
      .mem_valid_o(request[1:0]), .mem_ready_i(request_ready[1:0]), .mem_address_o(address[0 +: 2*AddressW]),
      .rsp_valid_i(level_rsp), .rsp_data_i,
      .chunk_valid_o(node_valid), .chunk_ready_i(node_ready), .chunk_kind_o(node_kind), .chunk_set_o(node_set),
      .chunk_o(chunk_node), .mark_o(node_mark),
      .testing_o(testing), .waiting_o(waiting)
    );
  end else begin : gen_layers
    dopu_descend #(.Lines(Lines)) u_descend (
      .clk_i, .rst_ni, .frame_i, .planes_i(planes), .set_done_i(set_done),
      .cell_valid_i(cell_valid), .cell_ready_o(cell_ready), .cell_kind_i(cell_kind), .cell_set_i(cell_set), .cell_i(cell_node),
      .mem_valid_o(request[1:0]), .mem_ready_i(request_ready[1:0]), .mem_address_o(address[0 +: 2*AddressW]),
      .rsp_valid_i(level_rsp), .rsp_data_i,
      .chunk_valid_o(node_valid), .chunk_ready_i(node_ready), .chunk_kind_o(node_kind), .chunk_set_o(node_set),
      .chunk_o(chunk_node), .testing_o(testing), .waiting_o(waiting)
    );
    assign node_mark = '0;
  end

  // --- one memory port: the answers come back in the order of the requests ------------------------------------------------
  logic [1:0] granted, asked_level;
  logic       asked_valid, asked_ready;
  logic [$clog2(Asked+1)-1:0] asked_count;

  arbiter #(.Ports(Ports)) u_arbiter (
    .clk_i, .rst_ni, .request_i(request), .advance_i(mem_ready_i), .grant_o(grant), .port_o(granted)
  );
  assign mem_valid_o   = grant != '0;
  assign mem_address_o = granted == 2'd2 ? address[2*AddressW +: AddressW]
                       : granted == 2'd1 ? address[AddressW +: AddressW] : address[0 +: AddressW];
  assign request_ready = grant & {Ports{mem_ready_i}};

  fifo #(.DataW(2), .Depth(Asked)) u_asked (
    .clk_i, .rst_ni,
    .in_valid_i((request_ready[1:0]) != '0), .in_ready_o(asked_ready), .in_i(granted),
    .out_valid_o(asked_valid), .out_ready_i(rsp_valid_i && !loading), .out_o(asked_level), .count_o(asked_count)
  );
  assign cells_rsp = rsp_valid_i && loading;
  assign level_rsp = rsp_valid_i && !loading ? {asked_level[0], !asked_level[0]} : '0;

  // --- chunks to the PUs ----------------------------------------------------------------------------------------------------
  logic               chunk_valid, chunk_ready;
  pipegs_pkg::chunk_t chunk;

  dopu_origin u_origin (
    .clk_i, .rst_ni, .frame_i,
    .node_valid_i(node_valid), .node_ready_o(node_ready), .kind_i(node_kind),
    .window_x_i(node_set ? set_x[WindowW +: WindowW] : set_x[0 +: WindowW]),
    .window_y_i(node_set ? set_y[WindowW +: WindowW] : set_y[0 +: WindowW]), .node_i(chunk_node), .mark_i(node_mark),
    .chunk_valid_o(chunk_valid), .chunk_ready_i(chunk_ready), .chunk_o(chunk)
  );
  // Nothing of the window needs its planes any more once its end has left the test.
  assign window_sent = node_valid && node_ready && node_kind == pipegs_pkg::KindWindowEnd;

  dopu_emit u_emit (
    .clk_i, .rst_ni, .in_valid_i(chunk_valid), .in_ready_o(chunk_ready), .in_i(chunk),
    .chunk_valid_o, .chunk_ready_i, .chunk_o
  );

  // --- busy, clock, counters ----------------------------------------------------------------------------------------------
  // The frame is done when the end of its last window has been taken by every PU.
  logic busy_q, last_q, last_end;  // last_q: the last end stands at the output

  assign last_end = chunk_valid && chunk_ready && chunk.kind == pipegs_pkg::KindWindowEnd
                    && (pipegs_pkg::Order == 1 || (chunk.window_x == frame_i.last_x && chunk.window_y == frame_i.last_y));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      last_q <= 1'b0;
    end else if (start_i) begin
      busy_q <= 1'b1;
      last_q <= 1'b0;
    end else begin
      if (last_end) last_q <= 1'b1;
      if (last_q && (chunk_valid_o & ~chunk_ready_i) == '0) busy_q <= 1'b0;
    end
  end

  // Nothing inside lasts QuietCycles without a move, so after as many without one the unit waits for its surroundings,
  // and needs a clock only when these move.
  localparam int unsigned QuietCycles = 127;
  localparam int unsigned QuietW = $clog2(QuietCycles + 1);
  logic [QuietW-1:0] quiet_q;
  logic              moved, blocked, woken;

  assign moved    = testing || walking || (node_valid && node_ready) || (chunk_valid && chunk_ready);
  assign woken    = start_i || rsp_valid_i || (mem_valid_o && mem_ready_i) || (blocked && chunk_ready_i != '0) || done_news;
  assign blocked  = chunk_valid || chunk_valid_o != '0;
  assign busy_o   = busy_q;
  assign active_o = start_i || (busy_q && (moved || woken || quiet_q != QuietW'(QuietCycles)));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) quiet_q <= '0;
    else if (moved || woken) quiet_q <= '0;
    else if (quiet_q != QuietW'(QuietCycles)) quiet_q <= quiet_q + 1'b1;
  end

  assign perf_o   = moved ? 2'd0 : waiting || loading ? 2'd3 : blocked ? 2'd2 : 2'd1;

  logic unused;
  assign unused = &{1'b0, frame_i, asked_valid, asked_ready, asked_count, asked_level[1]};

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) rsp_valid_i && !loading |-> asked_valid);
  assert property (@(posedge clk_i) disable iff (!rst_ni) request_ready[1:0] != '0 |-> asked_ready);
`endif

endmodule
