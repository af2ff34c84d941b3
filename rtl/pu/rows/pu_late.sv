// SPDX-License-Identifier: Apache-2.0
// pu_late: the back of a PU that caches coefficients: a splat takes A to F along, the Row Units stand in the RUs.
//
// Paper   Eq. 3; the paper caches alphas (pu_cache). Coefficients take 28 bytes a Gaussian and window instead of 64 a
//         region, and regions that close before the Gaussian's turn are never computed.
// Idea    Regions that are done leave the mask; a Gaussian without regions is dropped. Coefficients wait in a queue
//         beside the colour; both make the splat.
// Stream  tiles in; splat out, in order; one port to external memory. Ends pass behind the splats before them.
// Pace    One Gaussian per cycle; the colour sets the pace.
// Model   preprocess() in cpp_model/golden.cpp

module pu_late #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::rotation_t                rotation_i,
  input  logic [AddressW-1:0]                  colors_i,     // first line of the SH coefficients
  input  logic [pipegs_pkg::KindW-1:0]         sh_degree_i,  // of the scene
  input  pipegs_pkg::windows_t                 windows_i,
  input  logic                                 restart_i,   // a frame begins; the PU is empty

  input  logic                                 tiles_valid_i,
  output logic                                 tiles_ready_o,
  input  pipegs_pkg::tiles_t                   tiles_i,
  input  pipegs_pkg::payload_t                 payload_i,   // of the Gaussian in tiles_i

  input  logic [Units*pipegs_pkg::Regions-1:0] done_i,      // from the RUs
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_y_i,

  output logic                                 color_valid_o,  // SH coefficients
  input  logic                                 color_ready_i,
  output logic [AddressW-1:0]                  color_address_o,
  input  logic                                 color_rsp_valid_i,
  input  logic [MemoryW-1:0]                   rsp_data_i,

  output logic                                 splat_valid_o,
  input  logic                                 splat_ready_i,
  output pipegs_pkg::splat_t                   splat_o,

  output logic                                 moved_o,          // a beat moved inside
  output logic                                 busy_o,           // something is inside
  output logic                                 color_busy_o,
  output logic                                 color_waiting_o   // a colour waits for its coefficients
);

  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned AW      = pipegs_pkg::AW;
  localparam int unsigned BcW     = pipegs_pkg::BcW;
  localparam int unsigned DefW    = pipegs_pkg::DefW;
  localparam int unsigned CoeffsW = AW + 2 * BcW + 3 * DefW;
  localparam int unsigned Depth   = pipegs_pkg::LateDepth;

  logic                   valid_q, is_end, drop, take, leave, window_end;
  pipegs_pkg::tiles_t     tiles_q;
  pipegs_pkg::payload_t   payload_q;
  logic [Regions-1:0]     done;
  logic                   job_valid, job_ready, coeffs_room, coeffs_valid;
  logic                   colored_valid, colored_ready, colored_data;
  pipegs_pkg::color_job_t job;
  pipegs_pkg::colored_t   colored;
  logic [CoeffsW-1:0]     coeffs;
  logic [$clog2(Depth+1)-1:0] count;

  pu_done u_done (
    .clk_i, .rst_ni, .windows_i, .restart_i, .advance_i(window_end), .done_i, .done_x_i, .done_y_i, .done_o(done)
  );

  assign is_end        = tiles_q.kind != pipegs_pkg::KindData;
  assign drop          = valid_q && !is_end && tiles_q.mask == '0;
  assign job_valid     = valid_q && !drop && (is_end || coeffs_room);
  assign leave         = drop || (job_valid && job_ready);
  assign tiles_ready_o = !valid_q || leave;
  assign take          = tiles_valid_i && tiles_ready_o;
  assign window_end    = take && tiles_i.kind == pipegs_pkg::KindWindowEnd;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (tiles_ready_o) valid_q <= tiles_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      tiles_q      <= tiles_i;
      tiles_q.mask <= tiles_i.mask & ~done;
      payload_q    <= payload_i;
    end
  end

  always_comb begin
    job.kind    = tiles_q.kind;
    job.depth   = payload_q.depth;
    job.index   = pipegs_pkg::SplatIndexW'(payload_q.index);
    job.slot    = payload_q.slot;
    job.mask    = tiles_q.mask;
    job.address = '0;
    job.ext     = 1'b0;
    job.dir_x   = payload_q.dir_x;
    job.dir_y   = payload_q.dir_y;
    job.dir_z   = payload_q.dir_z;
    job.base_r  = payload_q.base_r;
    job.base_g  = payload_q.base_g;
    job.base_b  = payload_q.base_b;
  end

  sram_fifo #(.DataW(CoeffsW), .Depth(Depth)) u_coeffs (
    .clk_i, .rst_ni, .in_valid_i(job_valid && job_ready && !is_end), .in_ready_o(coeffs_room),
    .in_i({tiles_q.f, tiles_q.e, tiles_q.d, tiles_q.c, tiles_q.b, tiles_q.a}),
    .out_valid_o(coeffs_valid), .out_ready_i(colored_ready && colored_valid && colored_data),
    .out_o(coeffs), .count_o(count)
  );

  pu_color u_color (
    .clk_i, .rst_ni, .rotation_i, .colors_i, .sh_degree_i,
    .job_valid_i(job_valid), .job_ready_o(job_ready), .job_i(job),
    .mem_valid_o(color_valid_o), .mem_ready_i(color_ready_i), .mem_address_o(color_address_o),
    .rsp_valid_i(color_rsp_valid_i), .rsp_data_i,
    .colored_valid_o(colored_valid), .colored_ready_i(colored_ready), .colored_o(colored),
    .busy_o(color_busy_o), .waiting_memory_o(color_waiting_o)
  );

  assign colored_data  = colored.kind == pipegs_pkg::KindData;
  assign splat_valid_o = colored_valid && (!colored_data || coeffs_valid);
  assign colored_ready = splat_ready_i && (!colored_data || coeffs_valid);
  always_comb begin
    splat_o.kind  = colored.kind;
    splat_o.depth = colored.depth;
    splat_o.index = colored.index;
    splat_o.mask  = colored.mask;
    splat_o.red   = colored.red;
    splat_o.green = colored.green;
    splat_o.blue  = colored.blue;
    {splat_o.f, splat_o.e, splat_o.d, splat_o.c, splat_o.b, splat_o.a} = coeffs;
  end

  assign moved_o = take || leave || (splat_valid_o && splat_ready_i);
  assign busy_o  = valid_q || color_busy_o;

  logic unused_in;
  assign unused_in = &{1'b0, colored.address, colored.ext, count};

endmodule
