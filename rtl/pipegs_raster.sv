// SPDX-License-Identifier: Apache-2.0
// pipegs_raster: from sorted splats to pixels: dispatch, RUs, and the alpha stores that the PUs fill and the RUs read.
//
// Paper   Fig. 7 (right), Sec. 4.2.3, Table 2.
// Idea    sorted -> ru_dispatch -> RU[j]; alpha store k lies between PU k and all RUs. Where the RUs compute alphas, or
//         lists keep them in memory, there is none. line_free_o tells PU k that a line of its store is free,
//         layer_free_o all PUs that all RUs have finished the oldest layer. A clock gate per unit. Only wiring here.
// Stream  sorted splats in, nearest first; pixels to external memory; progress_o to the front.
// Model   cpp_model/ru/ru.hpp

module pipegs_raster #(
  localparam int unsigned Units   = pipegs_pkg::Units,
  localparam int unsigned MemoryW = pipegs_pkg::MemoryW
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic                             scan_en_i,
  input  pipegs_pkg::raster_t              raster_i,
  input  pipegs_pkg::picture_t             picture_i,   // its base is that of the pixels in either format
  input  pipegs_pkg::span_t                overflow_i,  // the overflow area
  input  logic                             restart_i,

  input  logic                             sorted_valid_i,
  output logic                             sorted_ready_o,
  input  pipegs_pkg::sorted_t              sorted_i,
  input  pipegs_pkg::store_writes_t        store_i,

  output pipegs_pkg::memory_lanes_t        memory_o,
  output logic [Units*pipegs_pkg::HalvesW-1:0] halves_o,  // of the line of each: what a write changes
  input  pipegs_pkg::memory_lanes_answer_t memory_i,
  input  logic [MemoryW-1:0]               line_i,      // of the memory's answers

  output pipegs_pkg::progress_t            progress_o,
  output logic [Units-1:0]                 line_free_o,
  output logic                             layer_free_o,
  output logic [Units-1:0]                 layer_done_o,   // pulse: the RU has blended a layer
  output logic [Units-1:0]                 window_done_o,  // pulse: with it, the window is complete
  output logic                             busy_o,
  output logic [Units*2-1:0]               perf_o,
  output pipegs_pkg::raster_taps_t         taps_o
);

  localparam int unsigned AlphaAddressW = pipegs_pkg::AlphaAddressW;
  localparam int unsigned LineW         = pipegs_pkg::LineW;
  localparam int unsigned Regions       = pipegs_pkg::Regions;

  logic                            dispatch_active;
  logic [Units-1:0]                ru_active, splat_valid, splat_ready;
  pipegs_pkg::sorted_t             splat;

  localparam int unsigned HalfW = MemoryW / 2;
  localparam int unsigned Slots = Regions / Units;
  typedef struct packed {  // of each RU, to the one that shares its lines
    logic [Units-1:0][HalfW-1:0] row;
    logic [Units-1:0][Slots-1:0] wanted;
    logic [Units-1:0]            valid, taken, at_end;
  } pairs_t;
  typedef struct packed {  // between RUs and stores
    logic [Units*Units-1:0]              valid, ready, answered;  // [RU * Units + store]
    logic [Units-1:0][AlphaAddressW-1:0] address;                 // of each RU
    logic [Units-1:0]                    skip;
    logic [Units-1:0][LineW-1:0]         answer;                  // of each store
  } reads_t;
  typedef struct packed {  // of each RU
    logic [Units-1:0][pipegs_pkg::HalvesW-1:0] halves;
    logic [Units-1:0][1:0]                     perf;
  } outs_t;
  localparam int unsigned Kinds    = pipegs_pkg::AovKinds;
  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  logic [Kinds*AddressW-1:0] ahead;  // of each AOV: lines behind the pixels

  pairs_t pairs;
  reads_t reads;
  outs_t  outs;
  assign {halves_o, perf_o} = outs;

  ru_dispatch u_dispatch (
    .clk_i,
    .rst_ni,
    .in_valid_i(sorted_valid_i),
    .in_ready_o(sorted_ready_o),
    .in_i(sorted_i),
    .out_valid_o(splat_valid),
    .out_ready_i(splat_ready),
    .out_o(splat),
    .active_o(dispatch_active)
  );

  if (pipegs_pkg::HasAovs) begin : gen_aovs
    always_comb begin
      logic [AddressW-1:0] line;
      line = raster_i.aovs.base - picture_i.base;
      for (int unsigned i = 0; i < Kinds; i += 1) begin
        ahead[i*AddressW +: AddressW] = line;
        if (raster_i.aovs.wanted[i] && pipegs_pkg::AovsBuilt[i]) line += raster_i.aovs.lines;
      end
    end
  end else begin : gen_no_aovs
    assign ahead = '0;
  end

  for (genvar k = 0; k < Units; k += 1) begin : gen_unit
    // The RU with which this one shares lines, if there is another one.
    localparam int unsigned Other = Units > 1 ? (k % 2 == 0 ? k + 1 : k - 1) : 0;
    logic             other_valid, other_taken, other_at_end;
    logic [HalfW-1:0] other_row;
    logic [Slots-1:0] other_wanted;
    if (Units > 1) begin : gen_pair
      assign {other_valid, other_taken, other_at_end} = {pairs.valid[Other], pairs.taken[Other], pairs.at_end[Other]};
      assign other_row    = pairs.row[Other];
      assign other_wanted = pairs.wanted[Other];
    end else begin : gen_alone
      assign {other_valid, other_taken, other_at_end, other_row, other_wanted} = '0;
      logic unused_pair;
      assign unused_pair = &{1'b0, pairs};
    end

    logic ru_clk;
    pipegs_clock_gate u_ru_gate (
      .clk_i,
      .rst_ni,
      .scan_en_i,
      .enable_i(ru_active[k]),
      .clk_o(ru_clk)
    );
    pipegs_ru u_ru (
      .clk_i(ru_clk),
      .rst_ni,
      .raster_i,
      .picture_i,
      .ahead_i(ahead),
      .overflow_i,
      .unit_i(pipegs_pkg::UnitW'(k)),
      .restart_i,
      .in_valid_i(splat_valid[k]),
      .in_ready_o(splat_ready[k]),
      .in_i(splat),
      .read_valid_o(reads.valid[k*Units +: Units]),
      .read_ready_i(reads.ready[k*Units +: Units]),
      .read_address_o(reads.address[k]),
      .read_skip_o(reads.skip[k]),
      .answer_valid_i(reads.answered[k*Units +: Units]),
      .answer_i(reads.answer),
      .mem_valid_o(memory_o.valid[k]),
      .mem_ready_i(memory_i.ready[k]),
      .mem_write_o(memory_o.write[k]),
      .mem_address_o(memory_o.address[k]),
      .mem_halves_o(outs.halves[k]),
      .mem_data_o(memory_o.data[k]),
      .rsp_valid_i(memory_i.line[k]),
      .rsp_data_i(line_i),
      .pair_valid_o(pairs.valid[k]),
      .pair_taken_o(pairs.taken[k]),
      .pair_row_o(pairs.row[k]),
      .pair_at_end_o(pairs.at_end[k]),
      .pair_wanted_o(pairs.wanted[k]),
      .pair_valid_i(other_valid),
      .pair_taken_i(other_taken),
      .pair_row_i(other_row),
      .pair_at_end_i(other_at_end),
      .pair_wanted_i(other_wanted),
      .done_o(progress_o.done[k]),
      .done_x_o(progress_o.x[k]),
      .done_y_o(progress_o.y[k]),
      .layer_done_o(layer_done_o[k]),
      .window_done_o(window_done_o[k]),
      .idle_o(),
      .active_o(ru_active[k]),
      .perf_o(outs.perf[k]),
      .tap_line_valid_o(taps_o.alphas_valid[k]),
      .tap_line_index_o(taps_o.alphas_index[k]),
      .tap_line_region_o(taps_o.alphas_region[k]),
      .tap_line_quarter_o(taps_o.alphas_quarter[k]),
      .tap_line_o(taps_o.alphas[k]),
      .tap_word_valid_o(taps_o.pixels_valid[k]),
      .tap_word_region_o(taps_o.pixels_region[k]),
      .tap_word_quarter_o(taps_o.pixels_quarter[k]),
      .tap_word_o(taps_o.pixels[k])
    );

    if (pipegs_pkg::HasStores) begin : gen_store
      logic             store_clk, store_active;
      logic [Units-1:0] store_read_valid, store_read_ready, store_answer_valid;
      for (genvar j = 0; j < Units; j += 1) begin : gen_reader
        assign store_read_valid[j]       = reads.valid[j*Units+k];
        assign reads.ready[j*Units+k]    = store_read_ready[j];
        assign reads.answered[j*Units+k] = store_answer_valid[j];
      end
      pipegs_clock_gate u_store_gate (
        .clk_i,
        .rst_ni,
        .scan_en_i,
        .enable_i(store_active),
        .clk_o(store_clk)
      );
      pipegs_alpha_store u_store (
        .clk_i(store_clk),
        .rst_ni,
        .write_i(store_i.write[k]),
        .address_i(store_i.address[k]),
        .line_i(store_i.line[k]),
        .read_valid_i(store_read_valid),
        .read_ready_o(store_read_ready),
        .read_address_i(reads.address),
        .read_skip_i(reads.skip),
        .answer_valid_o(store_answer_valid),
        .answer_o(reads.answer[k]),
        .free_o(line_free_o[k]),
        .active_o(store_active)
      );
    end
  end
  if (!pipegs_pkg::HasStores) begin : gen_no_stores
    assign reads.ready    = '0;
    assign reads.answered = '0;
    assign reads.answer   = '0;
    assign line_free_o    = '0;
    logic unused_stores;
    assign unused_stores = &{1'b0, store_i, reads};
  end

  pipegs_layer_free u_layer_free (
    .clk_i,
    .rst_ni,
    .done_i(layer_done_o),
    .free_o(layer_free_o)
  );

  assign busy_o = ru_active != '0 || dispatch_active;

endmodule
