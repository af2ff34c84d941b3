// pu: one Preprocessing Unit: Gaussians of a window in, sorted-to-be splats and their lines of alphas out.
//
// Paper   Fig. 7 (PU), Sec. 4.2.1, Eq. 3, Table 2 (eight Row Units).
// Idea    fetch -> cull -> (pu_deal, shared by all PUs) -> queue -> project -> orient -> jacobian -> factors -> squares ->
//         covariance (-> compensate, with Antialias) -> conic -> coeff -> queue -> intersect -> back: pu_cache (alphas are cached) or pu_late (coefficients
//         are). With lists (Order 1) pu_list stands before coeff and behind intersect. Only wiring here.
// Stream  chunk in; splat out; lines to the lane's alpha store; three ports to external memory.
// Pace    One Gaussian per cycle into the cull, one per eight cycles behind it.
// Model   preprocess() in cpp_model/golden.cpp

module pu #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned LineW    = pipegs_pkg::LineW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::frame_t                   frame_i,
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,      // constant
  input  logic                                 restart_i,   // a frame begins; the PU is empty

  input  logic                                 chunk_valid_i,
  output logic                                 chunk_ready_o,
  input  pipegs_pkg::chunk_t                   chunk_i,

  output logic                                 culled_valid_o,  // survivors of this PU's cull, to pu_deal
  input  logic                                 culled_ready_i,
  output pipegs_pkg::visible_t                 culled_o,
  input  logic                                 visible_valid_i,  // Gaussians dealt to this PU
  output logic                                 visible_ready_o,
  input  pipegs_pkg::visible_t                 visible_i,

  input  logic [Units*pipegs_pkg::Regions-1:0] done_i,      // from the RUs
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_y_i,
  input  logic                                 layer_free_i,

  output logic                                 geometry_valid_o,
  input  logic                                 geometry_ready_i,
  output logic [AddressW-1:0]                  geometry_address_o,
  input  logic                                 geometry_rsp_valid_i,

  output logic                                 color_valid_o,
  input  logic                                 color_ready_i,
  output logic [AddressW-1:0]                  color_address_o,
  input  logic                                 color_rsp_valid_i,

  input  logic [MemoryW-1:0]                   rsp_data_i,  // of both reading ports

  output logic                                 spill_valid_o,  // writes of lines that found no room
  input  logic                                 spill_ready_i,
  output logic [AddressW-1:0]                  spill_address_o,
  output logic [MemoryW-1:0]                   spill_data_o,

  output logic                                 store_write_o,
  output logic [pipegs_pkg::AlphaAddressW-1:0] store_address_o,
  output logic [LineW-1:0]                     store_line_o,

  output logic                                 splat_valid_o,
  input  logic                                 splat_ready_i,
  output pipegs_pkg::splat_t                   splat_o,
  output logic [pipegs_pkg::ListWindowW-1:0]   number_o,    // of its window, with lists

  output logic [pipegs_pkg::RegionW:0]         overflowed_o,
  output logic                                 active_o,
  output logic [1:0]                           perf_o       // 0 busy, 1 starved, 2 blocked, 3 memory
);

  localparam int unsigned VisibleDepth = 4;   // short: what waits here cannot go to another PU
  localparam int unsigned WalkDepth    = 16;  // evens out pu_intersect, which takes 3 to 64 cycles where the others take 8

  logic fetched_valid, fetched_ready, visible_valid, visible_ready, projected_valid, projected_ready;
  logic oriented_valid, oriented_ready, jacobian_valid, jacobian_ready, factors_valid, factors_ready;
  logic squares_valid, squares_ready, covariance_valid, covariance_ready, conic_valid, conic_ready;
  logic compensated_valid, compensated_ready, compensate_busy;
  logic placed_valid, placed_ready, coeff_valid, coeff_ready, tiles_valid, tiles_ready;
  logic walk_valid, walk_ready;
  logic [$clog2(VisibleDepth+1)-1:0] visible_count;
  logic [$clog2(WalkDepth+1)-1:0]    walk_count;
  logic fetch_idle, fetch_waiting, color_busy, color_waiting, rows_busy, back_moved, back_busy, back_waiting;
  logic cull_busy, project_busy, orient_busy, jacobian_busy, factors_busy, squares_busy, covariance_busy;
  logic conic_busy, coeff_busy, intersect_busy, front_busy;
  logic moved, wake, work, asleep;
  pipegs_pkg::fetched_t    fetched;
  pipegs_pkg::visible_t    visible;
  pipegs_pkg::projected_t  projected;
  pipegs_pkg::oriented_t   oriented;
  pipegs_pkg::jacobian_t   jacobian;
  pipegs_pkg::factors_t    factors;
  pipegs_pkg::squares_t    squares;
  pipegs_pkg::covariance_t covariance, compensated;
  pipegs_pkg::conic_t      conic, placed;
  pipegs_pkg::coeff_t      coeff, walk;
  pipegs_pkg::tiles_t      tiles;

  // --- with Order 2 the watermark of a layer's end stays here until that end leaves the PU ----------------------------------
  logic                chunk_valid, chunk_ready;
  pipegs_pkg::splat_t  splat;

  if (pipegs_pkg::Order == 2) begin : gen_marks
    localparam int unsigned Marks = 16;
    localparam int unsigned DepthW = pipegs_pkg::DepthW;
    logic              chunk_is_end, splat_is_end, room, held;
    logic [DepthW-1:0] mark;
    logic [$clog2(Marks+1)-1:0] marks;
    assign chunk_is_end  = chunk_i.kind == pipegs_pkg::KindLayerEnd;
    assign splat_is_end  = splat.kind == pipegs_pkg::KindLayerEnd;
    assign chunk_valid   = chunk_valid_i && (room || !chunk_is_end);
    assign chunk_ready_o = chunk_ready && (room || !chunk_is_end || !chunk_valid_i);

    fifo #(.DataW(DepthW), .Depth(Marks)) u_marks (
      .clk_i, .rst_ni, .in_valid_i(chunk_valid_i && chunk_ready && chunk_is_end), .in_ready_o(room),
      .in_i(chunk_i.watermark),
      .out_valid_o(held), .out_ready_i(splat_valid_o && splat_ready_i && splat_is_end), .out_o(mark), .count_o(marks)
    );
    always_comb begin
      splat_o       = splat;
      splat_o.depth = splat_is_end ? mark : splat.depth;
    end
    logic unused_marks;
    assign unused_marks = &{1'b0, held, marks};
`ifndef SYNTHESIS
    assert property (@(posedge clk_i) disable iff (!rst_ni) splat_valid_o && splat_is_end |-> held);
`endif
  end else begin : gen_no_marks
    assign chunk_valid   = chunk_valid_i;
    assign chunk_ready_o = chunk_ready;
    assign splat_o       = splat;
  end

  pu_fetch u_fetch (
    .clk_i, .rst_ni, .gaussians_i(frame_i.gaussians), .chunk_valid_i(chunk_valid), .chunk_ready_o(chunk_ready), .chunk_i,
    .mem_valid_o(geometry_valid_o), .mem_ready_i(geometry_ready_i), .mem_address_o(geometry_address_o),
    .rsp_valid_i(geometry_rsp_valid_i), .rsp_data_i,
    .fetched_valid_o(fetched_valid), .fetched_ready_i(fetched_ready), .fetched_o(fetched),
    .waiting_memory_o(fetch_waiting), .idle_o(fetch_idle)
  );

  pu_cull u_cull (
    .clk_i, .rst_ni, .frame_i, .fetched_valid_i(fetched_valid), .fetched_ready_o(fetched_ready), .fetched_i(fetched),
    .visible_valid_o(culled_valid_o), .visible_ready_i(culled_ready_i), .visible_o(culled_o), .busy_o(cull_busy)
  );

  sram_fifo #(.DataW(pipegs_pkg::VisibleBits), .Depth(VisibleDepth)) u_visible (
    .clk_i, .rst_ni, .in_valid_i(visible_valid_i), .in_ready_o(visible_ready_o), .in_i(visible_i),
    .out_valid_o(visible_valid), .out_ready_i(visible_ready), .out_o(visible), .count_o(visible_count)
  );

  pu_project u_project (
    .clk_i, .rst_ni, .frame_i, .visible_valid_i(visible_valid), .visible_ready_o(visible_ready), .visible_i(visible),
    .projected_valid_o(projected_valid), .projected_ready_i(projected_ready), .projected_o(projected), .busy_o(project_busy)
  );

  pu_orient u_orient (
    .clk_i, .rst_ni, .frame_i, .projected_valid_i(projected_valid), .projected_ready_o(projected_ready),
    .projected_i(projected), .oriented_valid_o(oriented_valid), .oriented_ready_i(oriented_ready), .oriented_o(oriented),
    .busy_o(orient_busy)
  );

  pu_jacobian u_jacobian (
    .clk_i, .rst_ni, .frame_i, .oriented_valid_i(oriented_valid), .oriented_ready_o(oriented_ready), .oriented_i(oriented),
    .jacobian_valid_o(jacobian_valid), .jacobian_ready_i(jacobian_ready), .jacobian_o(jacobian), .busy_o(jacobian_busy)
  );

  pu_factors u_factors (
    .clk_i, .rst_ni, .jacobian_valid_i(jacobian_valid), .jacobian_ready_o(jacobian_ready), .jacobian_i(jacobian),
    .factors_valid_o(factors_valid), .factors_ready_i(factors_ready), .factors_o(factors), .busy_o(factors_busy)
  );

  pu_squares u_squares (
    .clk_i, .rst_ni, .factors_valid_i(factors_valid), .factors_ready_o(factors_ready), .factors_i(factors),
    .squares_valid_o(squares_valid), .squares_ready_i(squares_ready), .squares_o(squares), .busy_o(squares_busy)
  );

  pu_covariance u_covariance (
    .clk_i, .rst_ni, .squares_valid_i(squares_valid), .squares_ready_o(squares_ready), .squares_i(squares),
    .covariance_valid_o(covariance_valid), .covariance_ready_i(covariance_ready), .covariance_o(covariance),
    .busy_o(covariance_busy)
  );

  if (pipegs_pkg::Antialias == 1) begin : gen_compensate
    pu_compensate u_compensate (
      .clk_i, .rst_ni, .antialias_i(frame_i.antialias),
      .covariance_valid_i(covariance_valid), .covariance_ready_o(covariance_ready), .covariance_i(covariance),
      .compensated_valid_o(compensated_valid), .compensated_ready_i(compensated_ready), .compensated_o(compensated),
      .busy_o(compensate_busy)
    );
  end else begin : gen_sharp
    assign compensated_valid = covariance_valid;
    assign covariance_ready  = compensated_ready;
    assign compensated       = covariance;
    assign compensate_busy   = 1'b0;
  end

  pu_conic u_conic (
    .clk_i, .rst_ni, .covariance_valid_i(compensated_valid), .covariance_ready_o(compensated_ready), .covariance_i(compensated),
    .conic_valid_o(conic_valid), .conic_ready_i(conic_ready), .conic_o(conic), .busy_o(conic_busy)
  );

  pu_coeff u_coeff (
    .clk_i, .rst_ni, .conic_valid_i(placed_valid), .conic_ready_o(placed_ready), .conic_i(placed),
    .coeff_valid_o(coeff_valid), .coeff_ready_i(coeff_ready), .coeff_o(coeff), .busy_o(coeff_busy)
  );

  sram_fifo #(.DataW(pipegs_pkg::CoeffBits), .Depth(WalkDepth)) u_walks (
    .clk_i, .rst_ni, .in_valid_i(coeff_valid), .in_ready_o(coeff_ready), .in_i(coeff),
    .out_valid_o(walk_valid), .out_ready_i(walk_ready), .out_o(walk), .count_o(walk_count)
  );

  pu_intersect u_intersect (
    .clk_i, .rst_ni, .coeff_valid_i(walk_valid), .coeff_ready_o(walk_ready), .coeff_i(walk),
    .tiles_valid_o(tiles_valid), .tiles_ready_i(tiles_ready), .tiles_o(tiles), .busy_o(intersect_busy)
  );

  if (pipegs_pkg::Order != 1) begin : gen_window  // a Gaussian comes once for each window
    assign placed_valid = conic_valid;
    assign conic_ready  = placed_ready;
    assign placed       = conic;
    assign number_o     = '0;
  end

  if (pipegs_pkg::Order == 1) begin : gen_list
    pu_list u_back (
      .clk_i, .rst_ni, .frame_i, .unit_i, .restart_i,
      .conic_valid_i(conic_valid), .conic_ready_o(conic_ready), .conic_i(conic),
      .placed_valid_o(placed_valid), .placed_ready_i(placed_ready), .placed_o(placed),
      .tiles_valid_i(tiles_valid), .tiles_ready_o(tiles_ready), .tiles_i(tiles),
      .color_valid_o, .color_ready_i, .color_address_o, .color_rsp_valid_i, .rsp_data_i,
      .spill_valid_o, .spill_ready_i, .spill_address_o, .spill_data_o, .splat_valid_o, .splat_ready_i, .splat_o(splat), .number_o,
      .moved_o(back_moved), .busy_o(back_busy), .rows_busy_o(rows_busy), .color_busy_o(color_busy), .color_waiting_o(color_waiting)
    );
    assign store_write_o   = 1'b0;
    assign store_address_o = '0;
    assign store_line_o    = '0;
    assign overflowed_o    = '0;
    assign back_waiting    = 1'b0;
    logic unused_done;
    assign unused_done = &{1'b0, done_i, done_x_i, done_y_i};
  end else if (pipegs_pkg::Late == 0) begin : gen_cache
    pu_cache u_back (
      .clk_i, .rst_ni, .frame_i, .unit_i, .restart_i,
      .tiles_valid_i(tiles_valid), .tiles_ready_o(tiles_ready), .tiles_i(tiles),
      .done_i, .done_x_i, .done_y_i, .layer_free_i,
      .color_valid_o, .color_ready_i, .color_address_o, .color_rsp_valid_i, .rsp_data_i,
      .spill_valid_o, .spill_ready_i, .spill_address_o, .spill_data_o, .store_write_o, .store_address_o, .store_line_o,
      .splat_valid_o, .splat_ready_i, .splat_o(splat),
      .overflowed_o, .moved_o(back_moved), .busy_o(back_busy), .rows_busy_o(rows_busy), .color_busy_o(color_busy),
      .color_waiting_o(color_waiting), .waiting_o(back_waiting)
    );
  end else begin : gen_late
    pu_late u_back (
      .clk_i, .rst_ni, .frame_i, .unit_i, .restart_i,
      .tiles_valid_i(tiles_valid), .tiles_ready_o(tiles_ready), .tiles_i(tiles),
      .done_i, .done_x_i, .done_y_i, .layer_free_i,
      .color_valid_o, .color_ready_i, .color_address_o, .color_rsp_valid_i, .rsp_data_i,
      .spill_valid_o, .spill_ready_i, .spill_address_o, .spill_data_o, .store_write_o, .store_address_o, .store_line_o,
      .splat_valid_o, .splat_ready_i, .splat_o(splat),
      .overflowed_o, .moved_o(back_moved), .busy_o(back_busy), .rows_busy_o(rows_busy), .color_busy_o(color_busy),
      .color_waiting_o(color_waiting), .waiting_o(back_waiting)
    );
  end

  assign front_busy = cull_busy || project_busy || orient_busy || jacobian_busy || factors_busy || squares_busy ||
                      covariance_busy || compensate_busy || conic_busy || coeff_busy || intersect_busy || visible_count != '0 || walk_count != '0;
  // Beats that move inside, and what may come from outside.
  assign moved = (fetched_valid && fetched_ready) || (visible_valid && visible_ready) ||
                 (projected_valid && projected_ready) || (oriented_valid && oriented_ready) ||
                 (jacobian_valid && jacobian_ready) || (factors_valid && factors_ready) || (squares_valid && squares_ready) ||
                 (covariance_valid && covariance_ready) ||
                 (compensated_valid && compensated_ready) || (conic_valid && conic_ready) || (coeff_valid && coeff_ready) || (walk_valid && walk_ready) ||
                 (tiles_valid && tiles_ready) || back_moved;
  assign wake  = (chunk_valid_i && chunk_ready_o) || (culled_valid_o && culled_ready_i) || (visible_valid_i && visible_ready_o) ||
                 geometry_valid_o || color_valid_o || spill_valid_o ||
                 geometry_rsp_valid_i || color_rsp_valid_i || layer_free_i || restart_i || (splat_valid_o && splat_ready_i);
  assign work  = chunk_valid_i || visible_valid_i || !fetch_idle || front_busy || back_busy || tiles_valid;
  assign active_o = wake || (work && !asleep);

  pu_sleep u_sleep (.clk_i, .rst_ni, .moved_i(moved), .wake_i(wake), .asleep_o(asleep));

  pu_state u_state (
    .rows_i(rows_busy), .front_i(front_busy), .color_i(color_busy),
    .memory_i(fetch_waiting || color_waiting || (spill_valid_o && !spill_ready_i)),
    .blocked_i(back_waiting || (splat_valid_o && !splat_ready_i)), .state_o(perf_o)
  );

endmodule
