// SPDX-License-Identifier: Apache-2.0
// pu_color: the colour of a Gaussian seen from the camera, and the record that becomes a splat.
//
// Paper   SH colours of 3D Gaussian splatting (INRIA's order and constants).
// Idea    Two arms from the fetch meet in the sum: direction -> rotate -> normalise -> basis, and the line of memory.
// Stream  color_job -> colored, in order; an end beat passes in its turn with colour zero.
// Pace    One Gaussian in 8 cycles at SH degree 3, 7 at degree 1 and 2, 2 at degree 0.
// Model   cpp_model/pu/color/pu_color.hpp
// Wiring only. With ShDegree = 0 nothing of the SH hardware is built.

module pu_color #(
  parameter int unsigned Depth = pipegs_pkg::ColorDepth
) (
  input  logic                               clk_i,
  input  logic                               rst_ni,
  input  pipegs_pkg::rotation_t              rotation_i,
  input  pipegs_pkg::span_t                  colors_i,  // the SH coefficients
  input  logic [pipegs_pkg::KindW-1:0]       sh_degree_i,  // of the scene

  // from pu_allocate
  input  logic                               job_valid_i,
  output logic                               job_ready_o,
  input  pipegs_pkg::color_job_t             job_i,

  // external memory, reads only
  output logic                               mem_valid_o,
  input  logic                               mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]    mem_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]     mem_halves_o,  // see pu_color_fetch
  input  logic                               rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]     rsp_data_i,

  // to the SU
  output logic                               colored_valid_o,
  input  logic                               colored_ready_i,
  output pipegs_pkg::colored_t                 colored_o,

  output logic                               bad_o,            // see pu_color_fetch
  output logic [pipegs_pkg::AddressW-1:0]    bad_line_o,
  output logic                               busy_o,           // any job inside
  output logic                               waiting_memory_o  // the oldest job waits for its line
);

  logic                    task_valid, task_ready, line_valid, line_ready, basis_valid, basis_ready;
  logic                    fetch_busy, sum_busy;
  pipegs_pkg::color_task_t color_task;
  pipegs_pkg::sh_basis_t   basis;
  logic [pipegs_pkg::MemoryW-1:0] line;

  // A job's task without spherical harmonics: its base colour.
  pipegs_pkg::color_task_t base_task;
  always_comb begin
    base_task.kind    = job_i.kind;
    base_task.depth   = job_i.depth;
    base_task.index   = job_i.index;
    base_task.quarter = '0;
    base_task.mask    = job_i.mask;
    base_task.address = job_i.address;
    base_task.ext     = job_i.ext;
    base_task.base_r  = job_i.base_r;
    base_task.base_g  = job_i.base_g;
    base_task.base_b  = job_i.base_b;
  end

  if (pipegs_pkg::ShDegree != 0) begin : gen_shaded
    logic                         direction_valid, direction_ready, world_valid, world_ready, unit_valid, unit_ready;
    pipegs_pkg::view_direction_t  direction;
    pipegs_pkg::world_direction_t world;
    pipegs_pkg::unit_direction_t  unit_direction;

    pu_color_fetch #(.Depth(Depth)) u_fetch (
      .clk_i,
      .rst_ni,
      .colors_i,
      .sh_degree_i,
      .job_valid_i,
      .job_ready_o,
      .job_i,
      .mem_valid_o,
      .mem_ready_i,
      .mem_address_o,
      .mem_halves_o,
      .rsp_valid_i,
      .rsp_data_i,
      .task_valid_o     (task_valid),
      .task_ready_i     (task_ready),
      .task_o           (color_task),
      .direction_valid_o(direction_valid),
      .direction_ready_i(direction_ready),
      .direction_o      (direction),
      .line_valid_o     (line_valid),
      .line_ready_i     (line_ready),
      .line_o           (line),
      .bad_o,
      .bad_line_o,
      .busy_o           (fetch_busy)
    );

    pu_color_rotate u_rotate (
      .clk_i,
      .rst_ni,
      .rotation_i,
      .direction_valid_i(direction_valid),
      .direction_ready_o(direction_ready),
      .direction_i      (direction),
      .world_valid_o    (world_valid),
      .world_ready_i    (world_ready),
      .world_o          (world)
    );

    pu_color_normalise u_normalise (
      .clk_i,
      .rst_ni,
      .world_valid_i(world_valid),
      .world_ready_o(world_ready),
      .world_i      (world),
      .unit_valid_o (unit_valid),
      .unit_ready_i (unit_ready),
      .unit_o       (unit_direction)
    );

    pu_color_basis u_basis (
      .clk_i,
      .rst_ni,
      .unit_valid_i (unit_valid),
      .unit_ready_o (unit_ready),
      .unit_i       (unit_direction),
      .basis_valid_o(basis_valid),
      .basis_ready_i(basis_ready),
      .basis_o      (basis)
    );

    wire unused_task = &{1'b0, base_task};
  end else begin : gen_flat
    logic [1:0] count;

    pipegs_fifo #(.DataW(pipegs_pkg::ColorTaskBits), .Depth(2)) u_tasks (
      .clk_i,
      .rst_ni,
      .in_valid_i (job_valid_i),
      .in_ready_o (job_ready_o),
      .in_i       (base_task),
      .out_valid_o(task_valid),
      .out_ready_i(task_ready),
      .out_o      (color_task),
      .count_o    (count)
    );

    assign fetch_busy    = count != '0;
    assign mem_valid_o   = 1'b0;
    assign mem_address_o = '0;
    assign mem_halves_o  = '1;
    assign bad_o         = 1'b0;
    assign bad_line_o    = '0;
    assign line_valid    = 1'b0;
    assign line          = '0;
    assign basis_valid   = 1'b0;
    assign basis         = '0;

    wire unused_inputs = &{1'b0, rotation_i, colors_i, mem_ready_i, rsp_valid_i, rsp_data_i, job_i,
                           line_ready, basis_ready, Depth};
  end

  pu_color_sum u_sum (
    .clk_i,
    .rst_ni,
    .sh_degree_i,
    .task_valid_i (task_valid),
    .task_ready_o (task_ready),
    .task_i       (color_task),
    .line_valid_i (line_valid),
    .line_ready_o (line_ready),
    .line_i       (line),
    .basis_valid_i(basis_valid),
    .basis_ready_o(basis_ready),
    .basis_i      (basis),
    .colored_valid_o,
    .colored_ready_i,
    .colored_o,
    .busy_o       (sum_busy),
    .waiting_memory_o
  );

  assign busy_o = fetch_busy || sum_busy;

endmodule
