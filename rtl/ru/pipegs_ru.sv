// SPDX-License-Identifier: Apache-2.0
// pipegs_ru: one Rasterization Unit: blends the regions of a window that it owns, then writes their pixels.
//
// Paper   Fig. 7, Table 2 (RU: sixteen lanes, which it calls Rendering Units; double-buffered T and RGB).
// Idea    queue -> blending and its pixel buffer: ru_whole -> ru_resolve, or with Quads ru_live. ru_window knows where
//         in the frame the RU is; ru_join brings its rows together with those of the RU that shares their lines, in
//         raster order; ru_memory joins alpha reads and pixel writes. Only wiring here.
// Stream  sorted_t in; alpha stores and external memory beside it; done feedback to the DOPU and the PUs.
// Pace    Four cycles per region, or one per live quad of each group; pixels are written meanwhile.
// Model   cpp_model/ru/ru.hpp

module pipegs_ru #(
  localparam int unsigned Units = pipegs_pkg::Units,
  localparam int unsigned LineW = pipegs_pkg::LineW,
  localparam int unsigned TapLanes = pipegs_pkg::TapLanes,
  localparam int unsigned Slots = pipegs_pkg::Regions / pipegs_pkg::Units,
  localparam int unsigned Lanes = 16,
  localparam int unsigned WordW = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1)
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::raster_t                  raster_i,
  input  pipegs_pkg::picture_t                 picture_i,       // its base is that of the pixels in either format
  input  pipegs_pkg::span_t                    overflow_i,      // constant while a frame is inside
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,          // constant
  input  logic                                 restart_i,       // a frame begins; the RU is idle

  input  logic                                 in_valid_i,
  output logic                                 in_ready_o,
  input  pipegs_pkg::sorted_t                  in_i,

  output logic [Units-1:0]                     read_valid_o,    // to the alpha store of each unit
  input  logic [Units-1:0]                     read_ready_i,
  output logic [pipegs_pkg::AlphaAddressW-1:0] read_address_o,
  output logic                                 read_skip_o,     // the line is freed, not read
  input  logic [Units-1:0]                     answer_valid_i,  // one cycle after the request was taken
  input  logic [Units*LineW-1:0]               answer_i,

  output logic                                 mem_valid_o,
  input  logic                                 mem_ready_i,
  output logic                                 mem_write_o,
  output logic [pipegs_pkg::AddressW-1:0]      mem_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]       mem_halves_o,    // of the line: what a write changes
  output logic [pipegs_pkg::MemoryW-1:0]       mem_data_o,
  input  logic                                 rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]       rsp_data_i,

  // The RU with whose regions these share lines of a picture in raster order, see ru_join.
  output logic                                 pair_valid_o,    // a row waits
  output logic                                 pair_taken_o,    // the rows of both leave; from the even RU
  output logic [pipegs_pkg::MemoryW/2-1:0]     pair_row_o,
  output logic                                 pair_at_end_o,   // with Quads: nothing is left of the window
  output logic [Slots-1:0]                     pair_wanted_o,   // with Quads: what the next splat waits for
  input  logic                                 pair_valid_i,
  input  logic                                 pair_taken_i,
  input  logic [pipegs_pkg::MemoryW/2-1:0]     pair_row_i,
  input  logic                                 pair_at_end_i,
  input  logic [Slots-1:0]                     pair_wanted_i,

  output logic [pipegs_pkg::Regions-1:0]       done_o,          // owned regions that need no more alphas
  output logic [pipegs_pkg::WindowW-1:0]       done_x_o,        // the window they are of
  output logic [pipegs_pkg::WindowW-1:0]       done_y_o,
  output logic                                 layer_done_o,    // pulse: all lines of a layer are blended
  output logic                                 window_done_o,   // pulse: with it, the window is complete
  output logic                                 idle_o,          // nothing inside, all pixels written

  output logic                                 active_o,
  output logic [1:0]                           perf_o,          // 0 busy, 1 starved, 2 blocked, 3 memory

  output logic [TapLanes-1:0]                  tap_line_valid_o,  // alphas are consumed
  output logic [TapLanes*pipegs_pkg::TapIndexW-1:0] tap_line_index_o,  // of this Gaussian
  output logic [TapLanes*pipegs_pkg::RegionW-1:0] tap_line_region_o,
  output logic [TapLanes*2-1:0]                tap_line_quarter_o,  // of the region, with Quads
  output logic [TapLanes*pipegs_pkg::TapLineW-1:0] tap_line_o,
  output logic [TapLanes-1:0]                  tap_word_valid_o,  // pixels are written back
  output logic [TapLanes*pipegs_pkg::RegionW-1:0] tap_word_region_o,
  output logic [TapLanes*2-1:0]                tap_word_quarter_o,
  output logic [TapLanes*pipegs_pkg::TapWordW-1:0] tap_word_o
);

  localparam int unsigned Regions  = pipegs_pkg::Regions;
  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned Words    = Regions / Units * 4;
  localparam int unsigned AddrW    = $clog2(Words);

  // --- the queue: of a splat's mask one bit of Units, which this RU owns, where nobody counts the others -------------
  localparam int unsigned MaskW  = pipegs_pkg::MaskW;
  localparam int unsigned Shared = pipegs_pkg::Quads == 0 ? 1 : Units;  // bits of a mask that are kept as one
  localparam int unsigned KeptW  = MaskW / Shared;
  localparam int unsigned BelowW = pipegs_pkg::KindW + pipegs_pkg::TapDepthW + pipegs_pkg::PartW +
                                   pipegs_pkg::TapIndexW;  // of a splat below its mask
  localparam int unsigned AboveW = pipegs_pkg::SortedBits - MaskW - BelowW;
  localparam int unsigned QueueW = AboveW + KeptW + BelowW;
  logic                splat_valid, splat_ready;
  logic [AboveW-1:0]   above_in, above;
  logic [BelowW-1:0]   below_in, below;
  logic [MaskW-1:0]    mask_in, mask, part_own;
  logic [KeptW-1:0]    kept_in, kept;
  pipegs_pkg::sorted_t splat;
  logic [$clog2(pipegs_pkg::RuQueue+1)-1:0] queued;

  ru_own u_own (
    .unit_i,
    .own_o(part_own)
  );
  assign {above_in, mask_in, below_in} = in_i;
  assign splat = {above, mask, below};
  for (genvar i = 0; i < KeptW; i += 1) begin : gen_kept
    if (Shared > 1) begin : gen_own
      assign kept_in[i] = (mask_in[i*Shared +: Shared] & part_own[i*Shared +: Shared]) != '0;
      assign mask[i*Shared +: Shared] = {Shared{kept[i]}} & part_own[i*Shared +: Shared];
    end else begin : gen_all
      assign kept_in[i] = mask_in[i];
      assign mask[i]    = kept[i];
    end
  end
  pipegs_sram_fifo #(.DataW(QueueW), .Depth(pipegs_pkg::RuQueue)) u_queue (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_i({above_in, kept_in, below_in}),
    .out_valid_o(splat_valid),
    .out_ready_i(splat_ready),
    .out_o({above, kept, below}),
    .count_o(queued)
  );

  // --- where in the frame -------------------------------------------------------------------------------------------
  logic [Regions-1:0]                own, outside, unwritten;
  logic                              joined;  // rows leave together with those of the other RU
  logic [$clog2(pipegs_pkg::Window):0] columns, rows;
  logic [AddressW-1:0]               line;  // first one of the window's pixels

  assign own = {pipegs_pkg::Parts{part_own}};
  ru_window u_window (
    .clk_i,
    .rst_ni,
    .width_i(raster_i.width),
    .height_i(raster_i.height),
    .first_x_i(raster_i.windows.first_x),
    .first_y_i(raster_i.windows.first_y),
    .last_x_i(raster_i.windows.last_x),
    .picture_i,
    .restart_i,
    .advance_i(window_done_o),
    .x_o(done_x_o),
    .y_o(done_y_o),
    .columns_o(columns),
    .rows_o(rows),
    .outside_o(outside),
    .line_o(line)
  );
  assign joined = picture_i.format && Units > 1;
  for (genvar i = 0; i < Regions; i += 1) begin : gen_unwritten
    assign unwritten[i] = joined ? outside[i/2*2] : outside[i];  // the left one of two is outside: so is the other one
  end

  logic [pipegs_pkg::TW-1:0] rest;
  if (pipegs_pkg::EarlyStop != 0) begin : gen_rest
    assign rest = {1'b0, raster_i.rest};
  end else begin : gen_no_rest
    assign rest = '0;
  end

  // --- blending -----------------------------------------------------------------------------------------------------
  logic                load_valid, load_ready, store_valid, store_ready, issue, memory, waits, blend_idle;
  logic [AddressW-1:0] load_address, store_address;
  logic [pipegs_pkg::HalvesW-1:0] store_halves, write_halves;
  logic [pipegs_pkg::MemoryW-1:0] store_data, write_data;
  logic                           store_wide, write_valid, write_ready;

  if (pipegs_pkg::Quads == 0) begin : gen_whole
    logic             whole_idle, resolve_ready, resolve_read, resolve_fresh;
    logic [AddrW-1:0] resolve_raddr;
    logic [WordW-1:0] resolve_rdata;
    ru_whole u_blend (
      .clk_i,
      .rst_ni,
      .rest_i(rest),
      .overflow_i,
      .unit_i,
      .restart_i,
      .in_valid_i(splat_valid),
      .in_ready_o(splat_ready),
      .in_i(splat),
      .read_valid_o,
      .read_ready_i,
      .read_address_o,
      .read_skip_o,
      .answer_valid_i,
      .answer_i,
      .load_valid_o(load_valid),
      .load_ready_i(load_ready),
      .load_address_o(load_address),
      .rsp_valid_i,
      .rsp_data_i,
      .own_i(own),
      .outside_i(outside),
      .columns_i(columns),
      .rows_i(rows),
      .done_o,
      .resolve_ready_i(resolve_ready),
      .resolve_read_i(resolve_read),
      .resolve_raddr_i(resolve_raddr),
      .resolve_rdata_o(resolve_rdata),
      .resolve_fresh_o(resolve_fresh),
      .layer_done_o,
      .window_done_o,
      .issue_o(issue),
      .memory_o(memory),
      .waits_o(waits),
      .idle_o(whole_idle),
      .tap_line_valid_o,
      .tap_line_index_o,
      .tap_line_region_o,
      .tap_line_o,
      .tap_word_valid_o,
      .tap_word_region_o,
      .tap_word_quarter_o,
      .tap_word_o
    );
    ru_resolve u_resolve (
      .clk_i,
      .rst_ni,
      .unit_i,
      .raster_i(picture_i.format),
      .stride_i(picture_i.stride),
      .start_i(window_done_o),
      .ready_o(resolve_ready),
      .line_i(line),
      .columns_i(columns),
      .rows_i(rows),
      .outside_i(unwritten),
      .read_o(resolve_read),
      .raddr_o(resolve_raddr),
      .rdata_i(resolve_rdata),
      .fresh_i(resolve_fresh),
      .mem_valid_o(store_valid),
      .mem_ready_i(store_ready),
      .mem_address_o(store_address),
      .mem_halves_o(store_halves),
      .mem_wide_o(store_wide),
      .mem_data_o(store_data)
    );
    assign {pair_at_end_o, pair_wanted_o} = '0;
    logic unused_pair;
    assign unused_pair = &{1'b0, pair_at_end_i, pair_wanted_i};
    assign blend_idle         = whole_idle && resolve_ready;
    assign tap_line_quarter_o = '0;
  end else begin : gen_live
    ru_live u_blend (
      .clk_i,
      .rst_ni,
      .rest_i(rest),
      .restart_i,
      .in_valid_i(splat_valid),
      .in_ready_o(splat_ready),
      .in_i(splat),
      .own_i(own),
      .unwritten_i(unwritten),
      .columns_i(columns),
      .rows_i(rows),
      .done_o,
      .joined_i(joined),
      .pair_at_end_i,
      .pair_wanted_i,
      .at_end_o(pair_at_end_o),
      .wanted_o(pair_wanted_o),
      .raster_i(picture_i.format),
      .stride_i(picture_i.stride),
      .line_i(line),
      .store_valid_o(store_valid),
      .store_ready_i(store_ready),
      .store_address_o(store_address),
      .store_halves_o(store_halves),
      .store_wide_o(store_wide),
      .store_data_o(store_data),
      .layer_done_o,
      .window_done_o,
      .issue_o(issue),
      .idle_o(blend_idle),
      .tap_line_valid_o,
      .tap_line_index_o,
      .tap_line_region_o,
      .tap_line_quarter_o,
      .tap_line_o,
      .tap_word_valid_o,
      .tap_word_region_o,
      .tap_word_quarter_o,
      .tap_word_o
    );
    assign {read_valid_o, read_address_o, read_skip_o, load_valid, load_address, memory, waits} = '0;
    logic unused_lines;
    assign unused_lines = &{1'b0, overflow_i, read_ready_i, answer_valid_i, answer_i, load_ready, rsp_valid_i,
                            rsp_data_i};
  end

  ru_join u_join (
    .joined_i(joined),
    .odd_i(unit_i[0]),
    .wide_i(store_wide),
    .in_valid_i(store_valid),
    .in_ready_o(store_ready),
    .in_halves_i(store_halves),
    .in_data_i(store_data),
    .pair_valid_o,
    .pair_taken_o,
    .pair_row_o,
    .pair_valid_i,
    .pair_taken_i,
    .pair_row_i,
    .out_valid_o(write_valid),
    .out_ready_i(write_ready),
    .out_halves_o(write_halves),
    .out_data_o(write_data)
  );
  ru_memory u_memory (
    .clk_i,
    .rst_ni,
    .read_valid_i(load_valid),
    .read_ready_o(load_ready),
    .read_address_i(load_address),
    .write_valid_i(write_valid),
    .write_ready_o(write_ready),
    .write_address_i(store_address),
    .write_halves_i(write_halves),
    .write_data_i(write_data),
    .mem_valid_o,
    .mem_ready_i,
    .mem_write_o,
    .mem_address_o,
    .mem_halves_o,
    .mem_data_o
  );

  // --- what the unit does in this cycle -----------------------------------------------------------------------------
  assign idle_o   = queued == '0 && blend_idle && !mem_valid_o;
  assign active_o = in_valid_i || restart_i || !idle_o;

  // Busy: pixels are blended, a splat is taken or a line of pixels leaves. Memory: the next line, or room for pixels,
  // has to come from there. Blocked: an alpha store does not answer.
  logic moves;
  assign moves  = issue || layer_done_o || (splat_valid && splat_ready) || (store_valid && store_ready);
  assign perf_o = moves ? pipegs_pkg::PerfBusy
                : memory || store_valid || mem_valid_o ? pipegs_pkg::PerfMemory
                : waits ? pipegs_pkg::PerfBlocked : pipegs_pkg::PerfStarved;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({store_address, write_halves, write_data}))) u_check_write (
    .clk_i,
    .rst_ni,
    .valid_i(write_valid),
    .ready_i(write_ready),
    .beat_i({store_address, write_halves, write_data})
  );
`endif

endmodule
