// pu_list: what a PU has beside the projection when it makes lists: expansion and colour before pu_coeff, records behind.
//
// Paper   the reproduced GSCore of Sec. 5 (baseline) and its rungs: preprocessing of the whole frame, then rasterization.
// Idea    pu_expand asks for a Gaussian's colour once and makes a beat for each window; pu_coeff and pu_intersect see the
//         same beats as in the other machines. What leaves them is a record: with coefficients (Late) as it is, else
//         pu_lines gives it lines in memory and the Row Units fill them. Only wiring here.
// Stream  conic in, placed out to pu_coeff; tiles in; splat and its window's number out; two ports to external memory.
// Pace    One record per eight cycles (pu_coeff); alphas one region per 8 / PixelsPerRow cycles.
// Model   golden_lists in cpp_model/golden.cpp

module pu_list #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned NumberW  = pipegs_pkg::ListWindowW,
  localparam int unsigned ColorW   = pipegs_pkg::ColorW
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  pipegs_pkg::frame_t           frame_i,
  input  logic [pipegs_pkg::UnitW-1:0] unit_i,     // constant
  input  logic                         restart_i,  // a frame begins; the PU is empty

  input  logic                         conic_valid_i,
  output logic                         conic_ready_o,
  input  pipegs_pkg::conic_t           conic_i,

  output logic                         placed_valid_o,
  input  logic                         placed_ready_i,
  output pipegs_pkg::conic_t           placed_o,

  input  logic                         tiles_valid_i,
  output logic                         tiles_ready_o,
  input  pipegs_pkg::tiles_t           tiles_i,

  output logic                         color_valid_o,  // SH coefficients
  input  logic                         color_ready_i,
  output logic [AddressW-1:0]          color_address_o,
  input  logic                         color_rsp_valid_i,
  input  logic [MemoryW-1:0]           rsp_data_i,

  output logic                         spill_valid_o,  // lines of alphas
  input  logic                         spill_ready_i,
  output logic [AddressW-1:0]          spill_address_o,
  output logic [MemoryW-1:0]           spill_data_o,

  output logic                         splat_valid_o,
  input  logic                         splat_ready_i,
  output pipegs_pkg::splat_t           splat_o,
  output logic [NumberW-1:0]           number_o,       // of the splat's window

  output logic                         moved_o,        // a beat moved inside
  output logic                         busy_o,         // something is inside
  output logic                         rows_busy_o,    // Row Units compute
  output logic                         color_busy_o,
  output logic                         color_waiting_o // a colour waits for its coefficients
);

  logic                   color_job_valid, color_job_ready, colored_valid, colored_ready, expand_busy, back_moved, back_busy;
  pipegs_pkg::color_job_t color_job;
  pipegs_pkg::colored_t   colored;

  pu_expand u_expand (
    .clk_i, .rst_ni, .frame_i, .conic_valid_i, .conic_ready_o, .conic_i,
    .color_job_valid_o(color_job_valid), .color_job_ready_i(color_job_ready), .color_job_o(color_job),
    .colored_valid_i(colored_valid), .colored_ready_o(colored_ready), .colored_i(colored),
    .placed_valid_o, .placed_ready_i, .placed_o, .busy_o(expand_busy)
  );

  pu_color u_color (
    .clk_i, .rst_ni, .frame_i, .job_valid_i(color_job_valid), .job_ready_o(color_job_ready), .job_i(color_job),
    .mem_valid_o(color_valid_o), .mem_ready_i(color_ready_i), .mem_address_o(color_address_o),
    .rsp_valid_i(color_rsp_valid_i), .rsp_data_i,
    .colored_valid_o(colored_valid), .colored_ready_i(colored_ready), .colored_o(colored),
    .busy_o(color_busy_o), .waiting_memory_o(color_waiting_o)
  );

  if (pipegs_pkg::Late == 0) begin : gen_cache
    localparam int unsigned JobDepth = 4;
    logic row_job_valid, row_job_ready, queued_valid, queued_ready, alphas_valid, alphas_ready, rows_end;
    logic lines_busy, spill_active, store_write;
    logic [$clog2(JobDepth+1)-1:0] job_count;
    logic [pipegs_pkg::AlphaAddressW-1:0] store_address;
    logic [pipegs_pkg::LineW-1:0] alphas_line, store_line;
    pipegs_pkg::row_job_t row_job, queued;
    pipegs_pkg::alphas_t  alphas;

    pu_lines u_lines (
      .clk_i, .rst_ni, .unit_i, .restart_i, .tiles_valid_i, .tiles_ready_o, .tiles_i,
      .row_job_valid_o(row_job_valid), .row_job_ready_i(row_job_ready), .row_job_o(row_job), .rows_end_i(rows_end),
      .splat_valid_o, .splat_ready_i, .splat_o, .window_o(number_o), .busy_o(lines_busy)
    );

    sram_fifo #(.DataW(pipegs_pkg::RowJobBits), .Depth(JobDepth)) u_jobs (
      .clk_i, .rst_ni, .in_valid_i(row_job_valid), .in_ready_o(row_job_ready), .in_i(row_job),
      .out_valid_o(queued_valid), .out_ready_i(queued_ready), .out_o(queued), .count_o(job_count)
    );

    pu_rows u_rows (
      .clk_i, .rst_ni, .row_job_valid_i(queued_valid), .row_job_ready_o(queued_ready), .row_job_i(queued),
      .alphas_valid_o(alphas_valid), .alphas_ready_i(alphas_ready), .alphas_o(alphas), .line_o(alphas_line),
      .active_o(rows_busy_o)
    );

    pu_spill u_spill (
      .clk_i, .rst_ni, .frame_i, .unit_i, .alphas_valid_i(alphas_valid), .alphas_ready_o(alphas_ready), .alphas_i(alphas),
      .line_i(alphas_line), .store_write_o(store_write), .store_address_o(store_address), .store_line_o(store_line),
      .mem_valid_o(spill_valid_o), .mem_ready_i(spill_ready_i), .mem_address_o(spill_address_o), .mem_data_o(spill_data_o),
      .rows_end_valid_o(rows_end), .rows_end_ready_i(1'b1), .rows_end_kind_o(), .active_o(spill_active)
    );

    assign back_moved = (row_job_valid && row_job_ready) || (queued_valid && queued_ready) || (alphas_valid && alphas_ready);
    assign back_busy  = lines_busy || rows_busy_o || job_count != '0 || spill_active;
    logic unused_store;  // every line goes to memory
    assign unused_store = &{1'b0, store_write, store_address, store_line};
  end else begin : gen_late
    assign splat_valid_o = tiles_valid_i;
    assign tiles_ready_o = splat_ready_i;
    assign number_o      = tiles_i.slot[NumberW-1:0];
    always_comb begin
      splat_o.kind  = tiles_i.kind;
      splat_o.depth = tiles_i.depth;
      splat_o.index = pipegs_pkg::SplatIndexW'(tiles_i.index);
      splat_o.mask  = tiles_i.mask;
      splat_o.red   = tiles_i.dir_x[ColorW-1:0];
      splat_o.green = tiles_i.dir_y[ColorW-1:0];
      splat_o.blue  = tiles_i.dir_z[ColorW-1:0];
      splat_o.a     = tiles_i.a;
      splat_o.b     = tiles_i.b;
      splat_o.c     = tiles_i.c;
      splat_o.d     = tiles_i.d;
      splat_o.e     = tiles_i.e;
      splat_o.f     = tiles_i.f;
    end
    assign spill_valid_o   = 1'b0;
    assign spill_address_o = '0;
    assign spill_data_o    = '0;
    assign rows_busy_o     = 1'b0;
    assign back_moved      = 1'b0;
    assign back_busy       = 1'b0;
    logic unused_in;
    assign unused_in = &{1'b0, unit_i, restart_i, spill_ready_i, tiles_i};
  end

  assign moved_o = (color_job_valid && color_job_ready) || (colored_valid && colored_ready) ||
                   (placed_valid_o && placed_ready_i) || (tiles_valid_i && tiles_ready_o) || back_moved;
  assign busy_o  = expand_busy || color_busy_o || back_busy;

endmodule
