// SPDX-License-Identifier: Apache-2.0
// pipegs_top: the whole machine: pipegs_front, pipegs_sorting and pipegs_raster behind one port to external memory.
//
// Paper   Fig. 7, Table 2.
// Idea    scene -> pipegs_front (DOPU, PUs) -> splats -> pipegs_sorting (SUs, merge) -> sorted -> pipegs_raster (RUs)
//         -> pixels. While the RUs blend layer i, the SUs sort behind them and the PUs already work on layer i + 1,
//         across windows too.
//         The front works on the frame in front_q, the back on the one in back_q: the same, or the one before.
//         Every unit has a clock of its own that stops while it has nothing to do. Only wiring here.
// Stream  frame_i, areas_i and picture_i are taken with frame_valid_i and frame_ready_o; scene and pixels lie outside,
//         in areas of the sizes areas_i. done_o: pulse, the oldest frame inside is complete. busy_o: a frame is inside.
//         error_o: pulses, {bad_scene, area_full}: nothing more is asked of memory, all frames inside are given up, and
//         a reset ends that.
//         perf_o: cycles busy, starved, blocked, memory of each unit, in the order DOPU, PUs, SUs, RUs.
// Model   cpp_model/golden.hpp

module pipegs_top #(
  localparam int unsigned Units      = pipegs_pkg::Units,
  localparam int unsigned PerfW      = pipegs_pkg::PerfW,
  localparam int unsigned PerfUnits  = 1 + 3 * Units,
  localparam int unsigned MemoryW    = pipegs_pkg::MemoryW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  logic                                 scan_en_i,  // every clock runs: scan test of the silicon, else 0

  input  logic                                 frame_valid_i,
  output logic                                 frame_ready_o,
  input  pipegs_pkg::frame_t                   frame_i,
  input  pipegs_pkg::areas_t                   areas_i,
  input  pipegs_pkg::picture_t                 picture_i,  // format 0: pixels by windows, at frame_i.tables.pixels
  output logic                                 done_o,
  output logic                                 busy_o,
  output logic [1:0]                           error_o,
  output logic [2*pipegs_pkg::AddressW-1:0]    error_line_o,  // of each the line of memory that it concerns

  output logic                                 mem_valid_o,
  input  logic                                 mem_ready_i,
  output pipegs_pkg::memory_request_t          mem_request_o,
  output logic [MemoryW-1:0]                   mem_data_o,
  input  logic                                 mem_rsp_valid_i,
  input  logic [pipegs_pkg::TagW-1:0]          mem_rsp_tag_i,
  input  logic [MemoryW-1:0]                   mem_rsp_data_i,

  output logic [PerfW-1:0]                     cycles_o,             // these and perf_o: since it was last empty
  output logic [PerfW-1:0]                     preprocess_cycles_o,  // of cycles_o, before the first list is read
  output logic [PerfW-1:0]                     overflow_lines_o,
  output logic [PerfUnits*4*PerfW-1:0]         perf_o
);

  localparam int unsigned SplatBits = pipegs_pkg::SplatBits;

  pipegs_pkg::frame_t                       front_q;
  pipegs_pkg::areas_t                       areas_q;        // of the front's frame
  pipegs_pkg::span_t                        overflow;
  pipegs_pkg::raster_t                      back_raster_q;
  pipegs_pkg::picture_t                     front_picture_q, back_picture, back_picture_q;
  logic                                     front_take, front_restart, back_take, back_restart, same;
  logic                                     hold, listen, begins, running, written;
  logic                                     front_busy, sorting_busy, raster_busy, memory_busy, storing;
  logic [Units-1:0]                         splat_valid, splat_ready;
  logic [Units*SplatBits-1:0]               splat;
  logic [Units*pipegs_pkg::ListWindowW-1:0] number;
  logic                                     sorted_valid, sorted_ready, raster_ready, sorted_taken;
  pipegs_pkg::sorted_t                      sorted;
  pipegs_pkg::store_writes_t                store;
  pipegs_pkg::progress_t                    progress, heard;
  logic                                     layer_free;
  logic [Units-1:0]                         line_free;
  logic [Units-1:0]                         layer_done, window_done, overflow_sort;
  logic [Units*(pipegs_pkg::RegionW+1)-1:0] overflow_alpha;
  logic                                     alphas_full, sorting_full, scene_bad, stop;
  logic [pipegs_pkg::AddressW-1:0]          pixels_room;  // lines
  logic [pipegs_pkg::AddressW-1:0]          alphas_full_line, sorting_full_line, scene_bad_line;
  typedef struct packed {logic [PerfUnits-1:0][1:0] of;} states_t;
  typedef struct packed {logic [PerfUnits-1:0][4*PerfW-1:0] of;} counts_t;
  states_t                                  perf_state;
  counts_t                                  counts;
  logic [2*(1+Units)-1:0]                   front_perf;
  logic [2*Units-1:0]                       sorting_perf, raster_perf;

  pipegs_pkg::memory_reads_t                reads;
  pipegs_pkg::memory_reads_answer_t         reads_answer;
  pipegs_pkg::memory_lanes_t                spill, sort, pixels;
  logic [Units*pipegs_pkg::HalvesW-1:0]     halves;
  pipegs_pkg::memory_lanes_answer_t         spill_answer, sort_answer, pixels_answer;
  pipegs_pkg::memory_lists_t                lists;
  pipegs_pkg::memory_lists_answer_t         lists_answer;
  logic [MemoryW-1:0]                       line;

  pipegs_pkg::raster_taps_t                 taps;
  logic [Units-1:0]                         tap_splat_valid, tap_chunk_valid;
  logic [Units*SplatBits-1:0]               tap_splat;
  pipegs_pkg::chunk_t                       tap_chunk;

  // --- frames -------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) begin
    if (front_take) {front_picture_q, areas_q, front_q} <= {picture_i, areas_i, frame_i};
    if (back_take) {back_picture_q, back_raster_q} <= {back_picture, front_q.raster};
  end
  // One base for the pixels, whatever their format.
  always_comb begin
    back_picture = front_picture_q;
    if (!front_picture_q.format) back_picture.base = front_q.tables.pixels;
  end
  // The SUs work for both: where they spill and where depths begin must be one.
  assign same         = frame_i.tables.overflow == front_q.tables.overflow && areas_i.overflow == areas_q.overflow &&
                        frame_i.lens.near_plane == front_q.lens.near_plane;
  assign overflow     = {areas_q.overflow, front_q.tables.overflow};
  assign running      = busy_o && !begins;
  assign sorted_ready = raster_ready && !hold;
  assign sorted_taken = sorted_valid && sorted_ready;

  pipegs_scheduler u_scheduler (
    .clk_i,
    .rst_ni,
    .frame_valid_i,
    .frame_ready_o,
    .same_i(same),
    .windows_i(front_q.raster.windows),
    .front_busy_i(front_busy),
    .back_busy_i(raster_busy),
    .storing_i(storing),
    .idle_i(!front_busy && !sorting_busy && !raster_busy && !memory_busy),
    .end_i(sorted_taken && sorted.kind == pipegs_pkg::KindWindowEnd),
    .window_done_i(window_done),
    .written_i(written),
    .overflow_sort_i(overflow_sort),
    .overflow_alpha_i(overflow_alpha),
    .front_take_o(front_take),
    .front_restart_o(front_restart),
    .back_take_o(back_take),
    .back_restart_o(back_restart),
    .hold_o(hold),
    .listen_o(listen),
    .begin_o(begins),
    .done_o,
    .busy_o,
    .cycles_o,
    .preprocess_cycles_o,
    .overflow_lines_o
  );

  // --- the machine --------------------------------------------------------------------------------------------------
  always_comb begin
    heard      = progress;
    heard.done = listen ? progress.done : '0;
  end

  pipegs_front u_front (
    .clk_i,
    .rst_ni,
    .scan_en_i,
    .frame_i(front_q),
    .areas_i(areas_q),
    .restart_i(front_restart),
    .reads_o(reads),
    .reads_i(reads_answer),
    .spill_o(spill),
    .spill_i(spill_answer),
    .line_i(line),
    .progress_i(heard),
    .line_free_i(line_free),
    .layer_free_i(layer_free),
    .store_o(store),
    .splat_valid_o(splat_valid),
    .splat_ready_i(splat_ready),
    .splat_o(splat),
    .number_o(number),
    .full_o(alphas_full),
    .full_line_o(alphas_full_line),
    .bad_o(scene_bad),
    .bad_line_o(scene_bad_line),
    .overflow_o(overflow_alpha),
    .busy_o(front_busy),
    .perf_o(front_perf),
    .tap_chunk_valid_o(tap_chunk_valid),
    .tap_chunk_o(tap_chunk)
  );

  pipegs_sorting u_sorting (
    .clk_i,
    .rst_ni,
    .scan_en_i,
    .windows_i(front_q.raster.windows),
    .overflow_i(overflow),
    .near_plane_i(front_q.lens.near_plane),
    .restart_i(front_restart),
    .made_valid_i(splat_valid),
    .made_ready_o(splat_ready),
    .made_i(splat),
    .number_i(number),
    .sorted_valid_o(sorted_valid),
    .sorted_ready_i(sorted_ready),
    .sorted_o(sorted),
    .sort_o(sort),
    .sort_i(sort_answer),
    .lists_o(lists),
    .lists_i(lists_answer),
    .line_i(line),
    .full_o(sorting_full),
    .full_line_o(sorting_full_line),
    .written_o(written),
    .overflow_o(overflow_sort),
    .busy_o(sorting_busy),
    .perf_o(sorting_perf),
    .tap_splat_valid_o(tap_splat_valid),
    .tap_splat_o(tap_splat)
  );

  pipegs_raster u_raster (
    .clk_i,
    .rst_ni,
    .scan_en_i,
    .raster_i(back_raster_q),
    .picture_i(back_picture_q),
    .overflow_i(overflow),
    .restart_i(back_restart),
    .sorted_valid_i(sorted_valid && !hold),
    .sorted_ready_o(raster_ready),
    .sorted_i(sorted),
    .store_i(store),
    .memory_o(pixels),
    .halves_o(halves),
    .memory_i(pixels_answer),
    .line_i(line),
    .progress_o(progress),
    .line_free_o(line_free),
    .layer_free_o(layer_free),
    .layer_done_o(layer_done),
    .window_done_o(window_done),
    .busy_o(raster_busy),
    .perf_o(raster_perf),
    .taps_o(taps)
  );

  pipegs_memory_ports u_memory (
    .clk_i,
    .rst_ni,
    .spill_i(spill),
    .spill_o(spill_answer),
    .sort_i(sort),
    .sort_o(sort_answer),
    .raster_i(pixels),
    .halves_i(halves),
    .raster_o(pixels_answer),
    .lists_i(lists),
    .lists_o(lists_answer),
    .reads_i(reads),
    .reads_o(reads_answer),
    .stop_i(stop),
    .line_o(line),
    .storing_o(storing),
    .busy_o(memory_busy),
    .mem_valid_o,
    .mem_ready_i,
    .mem_request_o,
    .mem_data_o,
    .mem_rsp_valid_i,
    .mem_rsp_tag_i,
    .mem_rsp_data_i
  );

  assign pixels_room = front_picture_q.format ? areas_q.picture : areas_q.pixels;
  pipegs_errors u_errors (
    .clk_i,
    .rst_ni,
    .restart_i(front_restart),
    .raster_i(front_q.raster),
    .by_windows_i(!front_picture_q.format),
    .stride_i(front_picture_q.stride),
    .pixels_i({pixels_room, back_picture.base}),
    .full_i({sorting_full, alphas_full}),
    .full_line_i({sorting_full_line, alphas_full_line}),
    .bad_i(scene_bad),
    .bad_line_i(scene_bad_line),
    .error_o,
    .error_line_o,
    .stop_o(stop)
  );

  assign perf_state = {raster_perf, sorting_perf, front_perf};
  assign perf_o = counts;
  for (genvar i = 0; i < PerfUnits; i += 1) begin : gen_perf
    pipegs_perf u_perf (
      .clk_i,
      .rst_ni,
      .restart_i(begins),
      .running_i(running),
      .state_i(perf_state.of[i]),
      .counts_o(counts.of[i])
    );
  end

  // The simulated machine (sim/rtl/pipegs_sim.sv) looks at what moves on the streams by name.
  logic unused_taps;
  assign unused_taps = &{1'b0, tap_splat_valid, tap_splat, tap_chunk_valid, tap_chunk, taps, layer_done};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(sorted))) u_check_sorted (
    .clk_i,
    .rst_ni,
    .valid_i(sorted_valid && !hold),
    .ready_i(raster_ready),
    .beat_i(sorted)
  );
`endif

endmodule
