// SPDX-License-Identifier: Apache-2.0
// pu_back: from a Gaussian's conic to the splats of its windows or parts: regions, colour, lines of alphas.
//
// Paper   Fig. 7 (PU), Sec. 4.2.1, Eq. 3.
// Idea    pu_regions (coefficients and the regions that they reach), then pu_cache when the PUs compute alphas, else
//         pu_late. With lists (order 1) a Gaussian is worked on once for all windows: pu_list stands before pu_regions
//         and has the colour, and pu_fill or pu_record behind it make list entries. Only wiring here.
// Stream  conic in; its payload in, earlier, not refused; splat out; lines to an alpha store; a port to external
//         memory for SH coefficients, one for lines that found no room. What a machine does not have is 0.
// Pace    One Gaussian per Pace cycles, 8 or 4, or per region of its box.
// Model   golden_window, golden_lists in cpp_model/golden.cpp

module pu_back #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned LineW    = pipegs_pkg::LineW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::rotation_t                rotation_i,
  input  pipegs_pkg::tables_t                  tables_i,
  input  pipegs_pkg::areas_t                   areas_i,     // their sizes
  input  pipegs_pkg::windows_t                 windows_i,
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,      // constant
  input  logic                                 restart_i,   // a frame begins; the PU is empty

  input  logic                                 payload_valid_i,
  input  pipegs_pkg::payload_t                 payload_i,
  input  logic                                 conic_valid_i,
  output logic                                 conic_ready_o,
  input  pipegs_pkg::conic_t                   conic_i,

  input  logic [Units*pipegs_pkg::Regions-1:0] done_i,      // from the RUs
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_y_i,
  input  logic                                 line_free_i,
  input  logic                                 layer_free_i,

  output logic                                 color_valid_o,
  input  logic                                 color_ready_i,
  output logic [AddressW-1:0]                  color_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]       color_halves_o,
  input  logic                                 color_rsp_valid_i,
  input  logic [MemoryW-1:0]                   rsp_data_i,

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
  output logic                                 full_o,           // see pu_spill
  output logic [AddressW-1:0]                  full_line_o,
  output logic                                 bad_o,            // see pu_color_fetch
  output logic [AddressW-1:0]                  bad_line_o,
  output logic                                 moved_o,          // a beat moved
  output logic                                 regions_busy_o,   // a record is in pu_regions
  output logic                                 rows_busy_o,      // a region is being computed
  output logic                                 color_busy_o,     // a colour is being computed or fetched
  output logic                                 color_waiting_o,  // for external memory
  output logic                                 waiting_o,        // for room in the alpha store
  output logic                                 busy_o            // a record is behind pu_regions, or in pu_list
);

  localparam int unsigned PayloadW = pipegs_pkg::HasLists ? pipegs_pkg::ListedBits : pipegs_pkg::PartedBits;

  logic                placed_valid, placed_ready, tiles_valid, tiles_ready, beside_valid, regions_moved, back_moved;
  logic [PayloadW-1:0] beside_in, beside;  // with lists listed_t, else parted_t
  pipegs_pkg::conic_t  placed;
  pipegs_pkg::tiles_t  tiles;
  pipegs_pkg::span_t   colors, overflow;

  assign colors   = {areas_i.colors, tables_i.colors};
  assign overflow = {areas_i.overflow, tables_i.overflow};
  assign moved_o = regions_moved || back_moved;

  pu_regions #(.PayloadW(PayloadW)) u_regions (
    .clk_i,
    .rst_ni,
    .payload_valid_i(beside_valid),
    .payload_i(beside_in),
    .conic_valid_i(placed_valid),
    .conic_ready_o(placed_ready),
    .conic_i(placed),
    .tiles_valid_o(tiles_valid),
    .tiles_ready_i(tiles_ready),
    .tiles_o(tiles),
    .payload_o(beside),
    .moved_o(regions_moved),
    .busy_o(regions_busy_o)
  );

  if (pipegs_pkg::HasLists) begin : gen_list
    logic list_moved, list_busy;
    pu_list u_list (
      .clk_i,
      .rst_ni,
      .rotation_i,
      .colors_i(colors),
      .sh_degree_i(tables_i.sh_degree),
      .windows_i,
      .payload_valid_i,
      .payload_i,
      .conic_valid_i,
      .conic_ready_o,
      .conic_i,
      .listed_valid_o(beside_valid),
      .listed_o(beside_in),
      .placed_valid_o(placed_valid),
      .placed_ready_i(placed_ready),
      .placed_o(placed),
      .color_valid_o,
      .color_ready_i,
      .color_address_o,
      .color_halves_o,
      .color_rsp_valid_i,
      .rsp_data_i,
      .bad_o,
      .bad_line_o,
      .moved_o(list_moved),
      .busy_o(list_busy),
      .color_busy_o,
      .color_waiting_o
    );
    if (pipegs_pkg::CachesAlphas) begin : gen_fill
      logic fill_moved, fill_busy;
      pu_fill u_back (
        .clk_i,
        .rst_ni,
        .overflow_i(overflow),
        .unit_i,
        .restart_i,
        .tiles_valid_i(tiles_valid),
        .tiles_ready_o(tiles_ready),
        .tiles_i(tiles),
        .listed_i(beside),
        .spill_valid_o,
        .spill_ready_i,
        .spill_address_o,
        .spill_data_o,
        .splat_valid_o,
        .splat_ready_i,
        .splat_o,
        .number_o,
        .full_o,
        .full_line_o,
        .moved_o(fill_moved),
        .busy_o(fill_busy),
        .rows_busy_o
      );
      assign back_moved = list_moved || fill_moved;
      assign busy_o     = list_busy || fill_busy;
    end else begin : gen_record
      pu_record u_back (
        .tiles_i(tiles),
        .listed_i(beside),
        .splat_o,
        .number_o
      );
      assign splat_valid_o = tiles_valid;
      assign tiles_ready   = splat_ready_i;
      assign back_moved    = list_moved;
      assign busy_o        = list_busy;
      assign rows_busy_o   = 1'b0;
    end
    logic unused_done;
    assign unused_done = &{1'b0, done_i, done_x_i, done_y_i};
  end else begin : gen_window  // a Gaussian comes once for each window
    logic window_moved, window_busy, parts_moved, parts_busy;
    if (pipegs_pkg::Parts > 1) begin : gen_parts
      pu_parts u_parts (
        .clk_i,
        .rst_ni,
        .payload_valid_i,
        .payload_i,
        .conic_valid_i,
        .conic_ready_o,
        .conic_i,
        .parted_valid_o(beside_valid),
        .parted_o(beside_in),
        .placed_valid_o(placed_valid),
        .placed_ready_i(placed_ready),
        .placed_o(placed),
        .moved_o(parts_moved),
        .busy_o(parts_busy)
      );
    end else begin : gen_whole
      assign placed_valid  = conic_valid_i;
      assign conic_ready_o = placed_ready;
      assign placed        = conic_i;
      assign beside_valid  = payload_valid_i;
      assign beside_in     = payload_i;
      assign parts_moved   = 1'b0;
      assign parts_busy    = 1'b0;
    end
    assign back_moved = window_moved || parts_moved;
    assign busy_o     = window_busy || parts_busy;
    assign number_o   = '0;
    if (pipegs_pkg::CachesAlphas) begin : gen_cache
      pu_cache u_back (
        .clk_i,
        .rst_ni,
        .rotation_i,
        .colors_i(colors),
        .sh_degree_i(tables_i.sh_degree),
        .overflow_i(overflow),
        .windows_i,
        .unit_i,
        .restart_i,
        .tiles_valid_i(tiles_valid),
        .tiles_ready_o(tiles_ready),
        .tiles_i(tiles),
        .payload_i(beside),
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
        .splat_o,
        .overflowed_o,
        .full_o,
        .full_line_o,
        .bad_o,
        .bad_line_o,
        .moved_o(window_moved),
        .busy_o(window_busy),
        .rows_busy_o,
        .color_busy_o,
        .color_waiting_o,
        .waiting_o
      );
    end else begin : gen_late
      pu_late u_back (
        .clk_i,
        .rst_ni,
        .rotation_i,
        .colors_i(colors),
        .sh_degree_i(tables_i.sh_degree),
        .windows_i,
        .restart_i,
        .tiles_valid_i(tiles_valid),
        .tiles_ready_o(tiles_ready),
        .tiles_i(tiles),
        .parted_i(beside),
        .done_i,
        .done_x_i,
        .done_y_i,
        .color_valid_o,
        .color_ready_i,
        .color_address_o,
        .color_halves_o,
        .color_rsp_valid_i,
        .rsp_data_i,
        .splat_valid_o,
        .splat_ready_i,
        .splat_o,
        .bad_o,
        .bad_line_o,
        .moved_o(window_moved),
        .busy_o(window_busy),
        .color_busy_o,
        .color_waiting_o
      );
      assign rows_busy_o = 1'b0;
    end
  end

  if (!pipegs_pkg::HasStores) begin : gen_no_store
    assign store_write_o   = 1'b0;
    assign store_address_o = '0;
    assign store_line_o    = '0;
    assign overflowed_o    = '0;
    assign waiting_o       = 1'b0;
  end
  if (!pipegs_pkg::CachesAlphas) begin : gen_no_spill
    assign spill_valid_o   = 1'b0;
    assign spill_address_o = '0;
    assign spill_data_o    = '0;
    assign full_o          = 1'b0;
    assign full_line_o     = '0;
  end

  logic unused;  // what only some machines look at
  assign unused = &{1'b0, tables_i, areas_i, overflow, unit_i, restart_i, line_free_i, layer_free_i, spill_ready_i};

endmodule
