// pu: one Preprocessing Unit: Gaussians of a window in, sorted-to-be splats and their lines of alphas out.
//
// Paper   Fig. 7 (PU), Sec. 4.2.1, Eq. 3, Table 2 (eight Row Units).
// Idea    fetch -> cull -> project -> orient -> jacobian -> factors -> squares -> covariance -> conic -> coeff -> intersect ->
//         allocate, which forks: rows -> spill (alpha store or memory) and color -> splat; join holds ends back until both
//         have them. Only wiring here.
// Stream  chunk in; splat out; lines to the lane's alpha store; three ports to external memory.
// Pace    One Gaussian per cycle into the cull, one per eight cycles behind it, one region per 8 / PixelsPerRow cycles.
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

  output logic [pipegs_pkg::RegionW:0]         overflowed_o,
  output logic                                 active_o,
  output logic [1:0]                           perf_o       // 0 busy, 1 starved, 2 blocked, 3 memory
);

  logic fetched_valid, fetched_ready, visible_valid, visible_ready, queued_valid, queued_ready;
  logic projected_valid, projected_ready, oriented_valid, oriented_ready, jacobian_valid, jacobian_ready;
  logic factors_valid, factors_ready, squares_valid, squares_ready, covariance_valid, covariance_ready;
  logic conic_valid, conic_ready, coeff_valid, coeff_ready, tiles_valid, tiles_ready;
  logic row_job_valid, row_job_ready, color_job_valid, color_job_ready, alphas_valid, alphas_ready;
  logic colored_valid, colored_ready, rows_end_valid, rows_end_ready;
  pipegs_pkg::fetched_t    fetched;
  pipegs_pkg::visible_t    visible, queued;
  pipegs_pkg::projected_t  projected;
  pipegs_pkg::oriented_t   oriented;
  pipegs_pkg::jacobian_t   jacobian;
  pipegs_pkg::factors_t    factors;
  pipegs_pkg::squares_t    squares;
  pipegs_pkg::covariance_t covariance;
  pipegs_pkg::conic_t      conic;
  pipegs_pkg::coeff_t      coeff;
  pipegs_pkg::tiles_t      tiles;
  pipegs_pkg::row_job_t    row_job;
  pipegs_pkg::color_job_t  color_job;
  pipegs_pkg::alphas_t     alphas;
  pipegs_pkg::splat_t      colored;
  logic [LineW-1:0]        line;

  pu_fetch u_fetch (
    .clk_i, .rst_ni, .gaussians_i(frame_i.gaussians), .chunk_valid_i, .chunk_ready_o, .chunk_i,
    .mem_valid_o(geometry_valid_o), .mem_ready_i(geometry_ready_i), .mem_address_o(geometry_address_o),
    .rsp_valid_i(geometry_rsp_valid_i), .rsp_data_i,
    .fetched_valid_o(fetched_valid), .fetched_ready_i(fetched_ready), .fetched_o(fetched),
    .waiting_memory_o(fetch_waiting), .idle_o(fetch_idle)
  );

endmodule
