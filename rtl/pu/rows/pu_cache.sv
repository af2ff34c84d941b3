// SPDX-License-Identifier: Apache-2.0
// pu_cache: the back of a PU that caches alphas: lines of 64 alphas to the alpha store, and a splat that says where.
//
// Paper   TSPP (Sec. 3.1): "precompute and cache the alphas"; Fig. 7, Table 2 (eight Row Units).
// Idea    allocate forks: queue -> rows -> spill (alpha store or memory) and color -> join, which holds a layer's end
//         back until both have it. The queue lets colours run on while a large Gaussian keeps the Row Units. Only
//         wiring here.
// Stream  tiles in; splat out; lines to the lane's alpha store; two ports to external memory.
// Pace    One Gaussian per four cycles, one region per 8 / PixelsPerRow cycles.
// Model   cpp_model/pu/rows/pu_allocate.hpp, pu_rows.hpp, pu_color.hpp

module pu_cache #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned LineW    = pipegs_pkg::LineW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::rotation_t                rotation_i,
  input  pipegs_pkg::span_t                    colors_i,     // the SH coefficients
  input  logic [pipegs_pkg::KindW-1:0]         sh_degree_i,  // of the scene
  input  pipegs_pkg::span_t                    overflow_i,
  input  pipegs_pkg::windows_t                 windows_i,
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,      // constant
  input  logic                                 restart_i,   // a frame begins; the PU is empty

  input  logic                                 tiles_valid_i,
  output logic                                 tiles_ready_o,
  input  pipegs_pkg::tiles_t                   tiles_i,
  input  pipegs_pkg::payload_t                 payload_i,   // of the Gaussian in tiles_i

  input  logic [Units*pipegs_pkg::Regions-1:0] done_i,      // from the RUs
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_y_i,
  input  logic                                 line_free_i,
  input  logic                                 layer_free_i,

  output logic                                 color_valid_o,  // SH coefficients
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

  output logic [pipegs_pkg::RegionW:0]         overflowed_o,
  output logic                                 full_o,           // see pu_spill
  output logic [AddressW-1:0]                  full_line_o,
  output logic                                 bad_o,            // see pu_color_fetch
  output logic [AddressW-1:0]                  bad_line_o,
  output logic                                 moved_o,          // a beat moved inside
  output logic                                 busy_o,           // something is inside
  output logic                                 rows_busy_o,      // Row Units compute
  output logic                                 color_busy_o,
  output logic                                 color_waiting_o,  // a colour waits for its coefficients
  output logic                                 waiting_o         // the alpha store has no room
);


  logic row_job_valid, row_job_ready, color_job_valid, color_job_ready, queued_valid, queued_ready;
  logic alphas_valid, alphas_ready, colored_valid, colored_ready, rows_end_valid, rows_end_ready;
  logic allocate_active, spill_active;
  logic [$clog2(pipegs_pkg::RowJobs+1)-1:0] job_count;
  pipegs_pkg::row_job_t    row_job, queued;
  pipegs_pkg::color_job_t  color_job;
  pipegs_pkg::alphas_t     alphas;
  pipegs_pkg::colored_t    colored;
  logic [LineW-1:0]        alphas_line;

  pu_allocate u_allocate (
    .clk_i,
    .rst_ni,
    .windows_i,
    .restart_i,
    .tiles_valid_i,
    .tiles_ready_o,
    .tiles_i,
    .payload_i,
    .row_job_valid_o(row_job_valid),
    .row_job_ready_i(row_job_ready),
    .row_job_o(row_job),
    .color_job_valid_o(color_job_valid),
    .color_job_ready_i(color_job_ready),
    .color_job_o(color_job),
    .done_i,
    .done_x_i,
    .done_y_i,
    .line_free_i,
    .layer_free_i,
    .overflowed_o,
    .waiting_o,
    .active_o(allocate_active)
  );

  pipegs_sram_fifo #(.DataW(pipegs_pkg::RowJobBits), .Depth(pipegs_pkg::RowJobs)) u_jobs (
    .clk_i,
    .rst_ni,
    .in_valid_i(row_job_valid),
    .in_ready_o(row_job_ready),
    .in_i(row_job),
    .out_valid_o(queued_valid),
    .out_ready_i(queued_ready),
    .out_o(queued),
    .count_o(job_count)
  );

  pu_rows u_rows (
    .clk_i,
    .rst_ni,
    .row_job_valid_i(queued_valid),
    .row_job_ready_o(queued_ready),
    .row_job_i(queued),
    .alphas_valid_o(alphas_valid),
    .alphas_ready_i(alphas_ready),
    .alphas_o(alphas),
    .line_o(alphas_line),
    .active_o(rows_busy_o)
  );

  pu_spill u_spill (
    .clk_i,
    .rst_ni,
    .overflow_i,
    .unit_i,
    .alphas_valid_i(alphas_valid),
    .alphas_ready_o(alphas_ready),
    .alphas_i(alphas),
    .line_i(alphas_line),
    .store_write_o,
    .store_address_o,
    .store_line_o,
    .mem_valid_o(spill_valid_o),
    .mem_ready_i(spill_ready_i),
    .mem_address_o(spill_address_o),
    .mem_data_o(spill_data_o),
    .rows_end_valid_o(rows_end_valid),
    .rows_end_ready_i(rows_end_ready),
    .rows_end_kind_o(),
    .full_o,
    .full_line_o,
    .active_o(spill_active)
  );

  pu_color u_color (
    .clk_i,
    .rst_ni,
    .rotation_i,
    .colors_i,
    .sh_degree_i,
    .job_valid_i(color_job_valid),
    .job_ready_o(color_job_ready),
    .job_i(color_job),
    .mem_valid_o(color_valid_o),
    .mem_ready_i(color_ready_i),
    .mem_address_o(color_address_o),
    .mem_halves_o(color_halves_o),
    .rsp_valid_i(color_rsp_valid_i),
    .rsp_data_i,
    .colored_valid_o(colored_valid),
    .colored_ready_i(colored_ready),
    .colored_o(colored),
    .bad_o,
    .bad_line_o,
    .busy_o(color_busy_o),
    .waiting_memory_o(color_waiting_o)
  );

  pu_join u_join (
    .clk_i,
    .rst_ni,
    .colored_valid_i(colored_valid),
    .colored_ready_o(colored_ready),
    .colored_i(colored),
    .rows_end_valid_i(rows_end_valid),
    .rows_end_ready_o(rows_end_ready),
    .splat_valid_o,
    .splat_ready_i,
    .splat_o
  );

  assign moved_o = (tiles_valid_i && tiles_ready_o) || (row_job_valid && row_job_ready) ||
                   (queued_valid && queued_ready) || (alphas_valid && alphas_ready) ||
                   (colored_valid && colored_ready) || rows_end_valid;
  assign busy_o  = allocate_active || rows_busy_o || job_count != '0 || spill_active || color_busy_o;

endmodule
