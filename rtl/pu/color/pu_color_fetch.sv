// SPDX-License-Identifier: Apache-2.0
// pu_color_fetch: asks for the SH line of each colour job and keeps the job until the line is here.
//
// Idea    Three queues of one size: tasks, directions and lines. Every direction and every line (asked for or here)
//         belongs to a task that is still queued, so a free place for the task is a free place for all three: no
//         credits, and an answer of the memory always finds room. The directions leave early, and are evaluated
//         while the line travels. A line that the table does not hold is not asked for, nor is any behind it (bad_o).
// Stream  color_job -> color_task; for each data beat of a frame with SH also a view_direction and a 64-byte line.
//         Degree 1 has four Gaussians in a line, degree 2 and 3 one; if Coded twice as many, and the half of the line
//         that holds the Gaussian is asked for: nothing is said of the other one in the answer.
// Pace    One job per cycle without SH, one in two cycles with (the request register is emptied first).
// Model   cpp_model/pu/color/pu_color_fetch.hpp

module pu_color_fetch #(
  parameter int unsigned Depth = pipegs_pkg::ColorDepth
) (
  input  logic                               clk_i,
  input  logic                               rst_ni,
  input  pipegs_pkg::span_t                  colors_i,  // the SH coefficients
  input  logic [pipegs_pkg::KindW-1:0]       sh_degree_i,  // of the scene

  input  logic                               job_valid_i,
  output logic                               job_ready_o,
  input  pipegs_pkg::color_job_t             job_i,

  output logic                               mem_valid_o,
  input  logic                               mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]    mem_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]     mem_halves_o,
  input  logic                               rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]     rsp_data_i,

  output logic                               task_valid_o,
  input  logic                               task_ready_i,
  output pipegs_pkg::color_task_t            task_o,

  output logic                               direction_valid_o,
  input  logic                               direction_ready_i,
  output pipegs_pkg::view_direction_t        direction_o,

  output logic                               line_valid_o,
  input  logic                               line_ready_i,
  output logic [pipegs_pkg::MemoryW-1:0]     line_o,

  output logic                               bad_o,  // stays
  output logic [pipegs_pkg::AddressW-1:0]    bad_line_o,
  output logic                               busy_o  // a job is queued
);

  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned CountW = $clog2(Depth + 1);

  logic                        room, take, ask;
  logic                        mem_valid_q;
  logic [AddressW-1:0]         mem_address_q, number;  // number: of the line in the table
  logic                        bad_q;
  logic                        direction_room, line_room;
  logic [CountW-1:0]           task_count, direction_count, line_count;
  pipegs_pkg::color_task_t     head;
  pipegs_pkg::view_direction_t direction;

  localparam int unsigned QuarterW = pipegs_pkg::QuarterW;
  logic one;  // degree 1
  assign one         = sh_degree_i == pipegs_pkg::KindW'(1);
  assign job_ready_o = room && !mem_valid_q && !bad_q;
  assign number      = one ? AddressW'(job_i.slot[pipegs_pkg::SlotW-1:QuarterW]) :
                       AddressW'(job_i.slot[pipegs_pkg::SlotW-1:QuarterW-2]);
  assign take        = job_valid_i && job_ready_o;
  assign ask         = take && job_i.kind == pipegs_pkg::KindData && sh_degree_i != '0;

  always_comb begin
    head.kind    = job_i.kind;
    head.depth   = job_i.depth;
    head.index   = job_i.index;
    head.quarter = job_i.slot[QuarterW-1:0];
    head.mask    = job_i.mask;
    head.address = job_i.address;
    head.ext     = job_i.ext;
    head.base_r  = job_i.base_r;
    head.base_g  = job_i.base_g;
    head.base_b  = job_i.base_b;
    direction.x  = job_i.dir_x;
    direction.y  = job_i.dir_y;
    direction.z  = job_i.dir_z;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      mem_valid_q <= 1'b0;
      bad_q       <= 1'b0;
    end else begin
      if (ask) mem_valid_q <= number < colors_i.lines;
      else if (mem_ready_i) mem_valid_q <= 1'b0;
      if (ask && number >= colors_i.lines) bad_q <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) if (ask) mem_address_q <= colors_i.first + number;
  if (pipegs_pkg::Coded) begin : gen_half
    logic upper_q;
    always_ff @(posedge clk_i) if (ask) upper_q <= one ? job_i.slot[QuarterW-1] : job_i.slot[0];
    assign mem_halves_o = {upper_q, !upper_q};
  end else begin : gen_whole
    assign mem_halves_o = '1;
  end
  assign bad_o         = bad_q;
  assign bad_line_o    = mem_address_q;
  assign mem_valid_o   = mem_valid_q;
  assign mem_address_o = mem_address_q;
  assign busy_o        = task_count != '0;

  pipegs_sram_fifo #(.DataW(pipegs_pkg::ColorTaskBits), .Depth(Depth)) u_tasks (
    .clk_i,
    .rst_ni,
    .in_valid_i (take),
    .in_ready_o (room),
    .in_i       (head),
    .out_valid_o(task_valid_o),
    .out_ready_i(task_ready_i),
    .out_o      (task_o),
    .count_o    (task_count)
  );

  pipegs_sram_fifo #(.DataW(pipegs_pkg::ViewDirectionBits), .Depth(Depth)) u_directions (
    .clk_i,
    .rst_ni,
    .in_valid_i (ask),
    .in_ready_o (direction_room),
    .in_i       (direction),
    .out_valid_o(direction_valid_o),
    .out_ready_i(direction_ready_i),
    .out_o      (direction_o),
    .count_o    (direction_count)
  );

  pipegs_sram_fifo #(.DataW(pipegs_pkg::MemoryW), .Depth(Depth)) u_lines (
    .clk_i,
    .rst_ni,
    .in_valid_i (rsp_valid_i),
    .in_ready_o (line_room),
    .in_i       (rsp_data_i),
    .out_valid_o(line_valid_o),
    .out_ready_i(line_ready_i),
    .out_o      (line_o),
    .count_o    (line_count)
  );

  wire unused_fields = &{1'b0, direction_room, line_room, direction_count, line_count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!ask || direction_room)
    else $error("no room for a direction");
  always_ff @(posedge clk_i) if (rst_ni) assert (!rsp_valid_i || line_room)
    else $error("a line came that nobody waits for");
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_halves_o}))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_halves_o})
  );
`endif

endmodule
