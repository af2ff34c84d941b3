// SPDX-License-Identifier: Apache-2.0
// pipegs_pu: one Preprocessing Unit: Gaussians of a window in, sorted-to-be splats and their lines of alphas out.
//
// Paper   Fig. 7 (PU), Sec. 4.2.1, Eq. 3, Table 2 (eight Row Units).
// Idea    front (fetch and cull) -> (pu_deal, shared by all PUs) -> queue -> shape (the projection, stage by stage) ->
//         back (regions, colour, alphas). Wiring, and the clock that stops when nothing moves. PuFronts of the PUs have
//         a front; the others take what pu_deal gives them, and the ends.
// Stream  chunk in; splat out; lines to the lane's alpha store; three ports to external memory.
// Pace    One Gaussian per cycle into the cull, one per Pace cycles, 8 or 4, behind it.
// Model   preprocess() in cpp_model/golden.cpp

module pipegs_pu #(
  parameter bit Front = 1'b1,
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned BurstW   = pipegs_pkg::BurstW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned LineW    = pipegs_pkg::LineW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::rotation_t                rotation_i,
  input  pipegs_pkg::quaternion_t              quaternion_i,
  input  pipegs_pkg::lens_t                    lens_i,
  input  pipegs_pkg::tables_t                  tables_i,
  input  pipegs_pkg::areas_t                   areas_i,     // their sizes
  input  pipegs_pkg::windows_t                 windows_i,
  input  pipegs_pkg::open_t                    open_i,      // what is still open
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,      // constant
  input  logic                                 restart_i,   // a frame begins; the PU is empty

  input  logic                                 chunk_valid_i,
  output logic                                 chunk_ready_o,
  output logic                                 chunk_room_o,  // for a chunk, whether or not one is shown
  input  pipegs_pkg::chunk_t                   chunk_i,

  output logic                                 culled_valid_o,  // survivors of this PU's cull, to pu_deal
  input  logic                                 culled_ready_i,
  output pipegs_pkg::visible_t                 culled_o,
  input  logic                                 visible_valid_i,  // Gaussians dealt to this PU
  output logic                                 visible_ready_o,
  output logic                                 visible_room_o,   // whether or not one is shown
  input  pipegs_pkg::visible_t                 visible_i,

  input  logic [Units*pipegs_pkg::Regions-1:0] done_i,      // from the RUs
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_y_i,
  input  logic                                 line_free_i,
  input  logic                                 layer_free_i,

  output logic                                 geometry_valid_o,
  input  logic                                 geometry_ready_i,
  output logic [AddressW-1:0]                  geometry_address_o,
  output logic [BurstW-1:0]                    geometry_lines_o,  // less one
  input  logic                                 geometry_rsp_valid_i,

  output logic                                 color_valid_o,
  input  logic                                 color_ready_i,
  output logic [AddressW-1:0]                  color_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]       color_halves_o,
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
  output logic                                 full_o,      // the area of its alphas: see pu_spill
  output logic [AddressW-1:0]                  full_line_o,
  output logic                                 bad_o,       // see pu_fetch, pu_color_fetch
  output logic [AddressW-1:0]                  bad_line_o,
  output logic                                 busy_o,      // something is inside
  output logic                                 active_o,    // needs a clock in this cycle
  output logic [1:0]                           perf_o       // 0 busy, 1 starved, 2 blocked, 3 memory
);

  localparam int unsigned VisibleDepth = pipegs_pkg::VisibleDepth;

  logic chunk_valid, chunk_ready, visible_valid, visible_ready, payload_valid;
  logic conic_valid, conic_ready;
  logic [$clog2(VisibleDepth+1)-1:0] visible_count;
  pipegs_pkg::visible_t   visible;
  pipegs_pkg::payload_t   payload;
  pipegs_pkg::conic_t     conic;
  pipegs_pkg::splat_t     splat;

  logic front_moved, front_idle, fetch_waiting, culls, shape_moved, shape_busy, regions_busy, busy;
  logic rows_busy, color_busy, color_waiting, back_moved, back_busy, back_waiting;
  logic moved, wake, work, asleep, geometry_bad, color_bad;
  logic [AddressW-1:0] geometry_bad_line, color_bad_line;

  if (pipegs_pkg::HasWatermarks) begin : gen_marks
    pu_marks u_marks (
      .clk_i,
      .rst_ni,
      .chunk_valid_i,
      .chunk_ready_o,
      .chunk_i,
      .chunk_valid_o(chunk_valid),
      .chunk_ready_i(chunk_ready),
      .splat_i(splat),
      .splat_o,
      .splat_taken_i(splat_valid_o && splat_ready_i)
    );
  end else begin : gen_no_marks
    assign chunk_valid   = chunk_valid_i;
    assign chunk_ready_o = chunk_ready;
    assign splat_o       = splat;
  end

  if (Front) begin : gen_front
    assign chunk_room_o = chunk_ready;
    pu_front u_front (
      .clk_i,
      .rst_ni,
      .rotation_i,
      .lens_i,
      .windows_i,
      .open_i,
      .gaussians_i({areas_i.gaussians, tables_i.gaussians}),
      .chunk_valid_i(chunk_valid),
      .chunk_ready_o(chunk_ready),
      .chunk_i,
      .geometry_valid_o,
      .geometry_ready_i,
      .geometry_address_o,
      .geometry_lines_o,
      .geometry_rsp_valid_i,
      .rsp_data_i,
      .visible_valid_o(culled_valid_o),
      .visible_ready_i(culled_ready_i),
      .visible_o(culled_o),
      .bad_o(geometry_bad),
      .bad_line_o(geometry_bad_line),
      .moved_o(front_moved),
      .waiting_o(fetch_waiting),
      .culls_o(culls),
      .idle_o(front_idle)
    );
  end else begin : gen_no_front
    logic unused_front;
    // Ends are shown to all PUs, and only pu_marks needs them here. A chunk comes to one that has room for it, so never
    // to this one.
    assign chunk_ready        = chunk_valid_i;
    assign chunk_room_o       = 1'b0;
    assign geometry_valid_o   = 1'b0;
    assign geometry_address_o = '0;
    assign geometry_lines_o   = '0;
    assign geometry_bad       = 1'b0;
    assign geometry_bad_line  = '0;
    assign culled_valid_o     = 1'b0;
    assign culled_o           = '0;
    assign front_moved        = 1'b0;
    assign fetch_waiting      = 1'b0;
    assign culls              = 1'b0;
    assign front_idle         = 1'b1;
    assign unused_front       = &{1'b0, chunk_i, chunk_valid, lens_i, windows_i, open_i, tables_i.gaussians,
                                  geometry_ready_i, geometry_rsp_valid_i, culled_ready_i};
  end

  pipegs_sram_fifo #(.DataW(pipegs_pkg::VisibleBits), .Depth(VisibleDepth)) u_visible (
    .clk_i,
    .rst_ni,
    .in_valid_i(visible_valid_i),
    .in_ready_o(visible_ready_o),
    .in_i(visible_i),
    .out_valid_o(visible_valid),
    .out_ready_i(visible_ready),
    .out_o(visible),
    .count_o(visible_count)
  );

  assign visible_room_o = visible_ready_o;

  pu_shape u_shape (
    .clk_i,
    .rst_ni,
    .quaternion_i,
    .lens_i,
    .tables_i,
    .visible_valid_i(visible_valid),
    .visible_ready_o(visible_ready),
    .visible_i(visible),
    .payload_valid_o(payload_valid),
    .payload_o(payload),
    .conic_valid_o(conic_valid),
    .conic_ready_i(conic_ready),
    .conic_o(conic),
    .moved_o(shape_moved),
    .busy_o(shape_busy)
  );

  pu_back u_back (
    .clk_i,
    .rst_ni,
    .rotation_i,
    .tables_i,
    .areas_i,
    .windows_i,
    .unit_i,
    .restart_i,
    .payload_valid_i(payload_valid),
    .payload_i(payload),
    .conic_valid_i(conic_valid),
    .conic_ready_o(conic_ready),
    .conic_i(conic),
    .done_i,
    .done_x_i,
    .done_y_i,
    .line_free_i,
    .layer_free_i,
    .color_valid_o,
    .color_ready_i,
    .color_address_o,
    .color_halves_o,
    .color_rsp_valid_i,
    .rsp_data_i,
    .spill_valid_o,
    .spill_ready_i,
    .spill_address_o,
    .spill_data_o,
    .store_write_o,
    .store_address_o,
    .store_line_o,
    .splat_valid_o,
    .splat_ready_i,
    .splat_o(splat),
    .number_o,
    .overflowed_o,
    .full_o,
    .full_line_o,
    .bad_o(color_bad),
    .bad_line_o(color_bad_line),
    .moved_o(back_moved),
    .regions_busy_o(regions_busy),
    .rows_busy_o(rows_busy),
    .color_busy_o(color_busy),
    .color_waiting_o(color_waiting),
    .waiting_o(back_waiting),
    .busy_o(back_busy)
  );

  pipegs_first_line #(.Ports(2)) u_bad (
    .valid_i({color_bad, geometry_bad}),
    .line_i({color_bad_line, geometry_bad_line}),
    .valid_o(bad_o),
    .line_o(bad_line_o)
  );

  // --- what it does, and whether it needs its clock ------------------------------------------------------------------
  assign busy  = culls || visible_count != '0 || shape_busy || regions_busy;
  assign moved = front_moved || (visible_valid && visible_ready) || shape_moved || back_moved;
  // What may come from outside.
  assign wake  = (chunk_valid_i && chunk_ready_o) || (culled_valid_o && culled_ready_i) ||
                 (visible_valid_i && visible_ready_o) || (splat_valid_o && splat_ready_i) ||
                 line_free_i || layer_free_i || restart_i || geometry_valid_o || color_valid_o || spill_valid_o ||
                 geometry_rsp_valid_i || color_rsp_valid_i;
  assign work  = chunk_valid_i || visible_valid_i || !front_idle || busy || back_busy;
  assign busy_o   = work;
  assign active_o = wake || (work && !asleep);

  pipegs_sleep #(.Patience(127)) u_sleep (
    .clk_i,
    .rst_ni,
    .moved_i(moved),
    .wake_i(wake),
    .asleep_o(asleep)
  );

  pu_state u_state (
    .rows_i(rows_busy),
    .front_i(busy),
    .color_i(color_busy),
    .memory_i(fetch_waiting || color_waiting || (spill_valid_o && !spill_ready_i)),
    .blocked_i(back_waiting || (splat_valid_o && !splat_ready_i)),
    .state_o(perf_o)
  );

endmodule
