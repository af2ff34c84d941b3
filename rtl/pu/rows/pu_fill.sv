// SPDX-License-Identifier: Apache-2.0
// pu_fill: the back of a PU that makes lists of records with alphas: lines in memory, and the Row Units that fill them.
//
// Paper   the reproduced GSCore of Sec. 5 with cached alphas (tile sharing and pixel parallelism before the lists).
// Idea    pu_lines gives a record lines in the area of all alphas; the Row Units fill them, all of them in memory. Only
//         wiring here.
// Stream  tiles in; splat and its window's number out; writes to external memory.
// Pace    One region per 8 / PixelsPerRow cycles.
// Model   golden_lists in cpp_model/golden.cpp

module pu_fill #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned NumberW  = pipegs_pkg::ListWindowW
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  pipegs_pkg::span_t            overflow_i,
  input  logic [pipegs_pkg::UnitW-1:0] unit_i,      // constant
  input  logic                         restart_i,   // a frame begins; the PU is empty

  input  logic                         tiles_valid_i,
  output logic                         tiles_ready_o,
  input  pipegs_pkg::tiles_t           tiles_i,
  input  pipegs_pkg::listed_t          listed_i,    // of the Gaussian in tiles_i

  output logic                         spill_valid_o,  // lines of alphas
  input  logic                         spill_ready_i,
  output logic [AddressW-1:0]          spill_address_o,
  output logic [MemoryW-1:0]           spill_data_o,

  output logic                         splat_valid_o,
  input  logic                         splat_ready_i,
  output pipegs_pkg::splat_t           splat_o,
  output logic [NumberW-1:0]           number_o,       // of the splat's window

  output logic                         full_o,         // see pu_spill
  output logic [AddressW-1:0]          full_line_o,
  output logic                         moved_o,        // a beat moved inside
  output logic                         busy_o,         // something is inside
  output logic                         rows_busy_o     // Row Units compute
);

  localparam int unsigned JobDepth = pipegs_pkg::RowJobs;
  logic row_job_valid, row_job_ready, queued_valid, queued_ready, alphas_valid, alphas_ready, rows_end;
  logic lines_busy, spill_active, store_write;
  logic [$clog2(JobDepth+1)-1:0] job_count;
  logic [pipegs_pkg::AlphaAddressW-1:0] store_address;
  logic [pipegs_pkg::LineW-1:0] alphas_line, store_line;
  pipegs_pkg::row_job_t row_job, queued;
  pipegs_pkg::alphas_t  alphas;

  pu_lines u_lines (
    .clk_i,
    .rst_ni,
    .unit_i,
    .restart_i,
    .tiles_valid_i,
    .tiles_ready_o,
    .tiles_i,
    .listed_i,
    .row_job_valid_o(row_job_valid),
    .row_job_ready_i(row_job_ready),
    .row_job_o(row_job),
    .rows_end_i(rows_end),
    .splat_valid_o,
    .splat_ready_i,
    .splat_o,
    .window_o(number_o),
    .busy_o(lines_busy)
  );

  pipegs_sram_fifo #(.DataW(pipegs_pkg::RowJobBits), .Depth(JobDepth)) u_jobs (
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
    .store_write_o(store_write),
    .store_address_o(store_address),
    .store_line_o(store_line),
    .mem_valid_o(spill_valid_o),
    .mem_ready_i(spill_ready_i),
    .mem_address_o(spill_address_o),
    .mem_data_o(spill_data_o),
    .rows_end_valid_o(rows_end),
    .rows_end_ready_i(1'b1),
    .rows_end_kind_o(),
    .full_o,
    .full_line_o,
    .active_o(spill_active)
  );

  assign moved_o = (row_job_valid && row_job_ready) || (queued_valid && queued_ready) || (alphas_valid && alphas_ready);
  assign busy_o  = lines_busy || rows_busy_o || job_count != '0 || spill_active;

  logic unused_store;  // every line goes to memory
  assign unused_store = &{1'b0, store_write, store_address, store_line};

endmodule
