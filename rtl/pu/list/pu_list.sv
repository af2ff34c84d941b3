// SPDX-License-Identifier: Apache-2.0
// pu_list: what a PU has before pu_coeff when it makes lists: a Gaussian's colour, and a beat for each of its windows.
//
// Paper   the reproduced GSCore of Sec. 5 (baseline) and its rungs: preprocessing of the whole frame, then
//         rasterization.
// Idea    pu_expand asks for a Gaussian's colour once and makes a beat for each window; pu_coeff and pu_intersect see
//         the same beats as in the other machines. What leaves them becomes a record in pu_record or pu_fill. Only
//         wiring here.
// Stream  conic in, placed out to pu_coeff; a port to external memory.
// Pace    One beat per Pace cycles, 8 or 4 (pu_coeff).
// Model   golden_lists in cpp_model/golden.cpp

module pu_list #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  pipegs_pkg::rotation_t        rotation_i,
  input  pipegs_pkg::span_t            colors_i,     // the SH coefficients
  input  logic [pipegs_pkg::KindW-1:0] sh_degree_i,  // of the scene
  input  pipegs_pkg::windows_t         windows_i,

  input  logic                         payload_valid_i,  // of a Gaussian, some time before its conic; not refused
  input  pipegs_pkg::payload_t         payload_i,
  input  logic                         conic_valid_i,
  output logic                         conic_ready_o,
  input  pipegs_pkg::conic_t           conic_i,

  output logic                         listed_valid_o,   // of a Gaussian in a window, just before its beat
  output pipegs_pkg::listed_t          listed_o,
  output logic                         placed_valid_o,
  input  logic                         placed_ready_i,
  output pipegs_pkg::conic_t           placed_o,

  output logic                         color_valid_o,  // SH coefficients
  input  logic                         color_ready_i,
  output logic [AddressW-1:0]          color_address_o,
  output logic [pipegs_pkg::HalvesW-1:0] color_halves_o,
  input  logic                         color_rsp_valid_i,
  input  logic [MemoryW-1:0]           rsp_data_i,

  output logic                         bad_o,           // see pu_color_fetch
  output logic [AddressW-1:0]          bad_line_o,
  output logic                         moved_o,         // a beat moved inside, or a window was passed over
  output logic                         busy_o,          // something is inside
  output logic                         color_busy_o,
  output logic                         color_waiting_o  // a colour waits for its coefficients
);

  logic                   color_job_valid, color_job_ready, colored_valid, colored_ready, expand_passes, expand_busy;
  pipegs_pkg::color_job_t color_job;
  pipegs_pkg::colored_t   colored;

  // The payload of a Gaussian waits for its conic, is its colour's job here, and ends: a window's list gets its own.
  localparam int unsigned Places = pipegs_pkg::ShapePlaces;
  logic                        payload_room, payload_held, payload_take;
  logic [$clog2(Places+1)-1:0] payload_count;
  pipegs_pkg::payload_t        payload;

  pipegs_sram_fifo #(.DataW(pipegs_pkg::PayloadBits), .Depth(Places)) u_payload (
    .clk_i,
    .rst_ni,
    .in_valid_i(payload_valid_i),
    .in_ready_o(payload_room),
    .in_i(payload_i),
    .out_valid_o(payload_held),
    .out_ready_i(payload_take),
    .out_o(payload),
    .count_o(payload_count)
  );
  logic unused_payload;
  assign unused_payload = &{1'b0, payload_room, payload_held, payload_count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!payload_valid_i || payload_room)
    else $error("more Gaussians than places for their payloads");
  always_ff @(posedge clk_i) if (rst_ni)
    assert (!(conic_valid_i && conic_i.kind == pipegs_pkg::KindData) || payload_held)
    else $error("a payload is not there in time");
`endif

  pu_expand u_expand (
    .clk_i,
    .rst_ni,
    .windows_i,
    .conic_valid_i,
    .conic_ready_o,
    .conic_i,
    .payload_i(payload),
    .payload_take_o(payload_take),
    .color_job_valid_o(color_job_valid),
    .color_job_ready_i(color_job_ready),
    .color_job_o(color_job),
    .colored_valid_i(colored_valid),
    .colored_ready_o(colored_ready),
    .colored_i(colored),
    .placed_valid_o,
    .placed_ready_i,
    .placed_o,
    .listed_valid_o,
    .listed_o,
    .passes_o(expand_passes),
    .busy_o(expand_busy)
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

  assign moved_o = (color_job_valid && color_job_ready) || (colored_valid && colored_ready) ||
                   (placed_valid_o && placed_ready_i) || expand_passes;
  assign busy_o  = expand_busy || color_busy_o;

endmodule
