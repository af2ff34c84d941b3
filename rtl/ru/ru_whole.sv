// SPDX-License-Identifier: Apache-2.0
// ru_whole: blends whole regions: lines of 64 alphas, sixteen lanes, the pixel buffer.
//
// Paper   Fig. 7, Table 2, Sec. 4.2.3.
// Idea    ru_source (lines of alphas) -> ru_lanes (blend) <-> pipegs_pixel_buffer. Only wiring here. With Quads ru_live
//         stands in its place.
// Stream  sorted_t in; alpha stores and external memory beside it; an end is taken when all before it is blended.
// Pace    Four cycles per region of alphas.
// Model   cpp_model/ru/ru.hpp

module ru_whole #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned Regions  = pipegs_pkg::Regions,
  localparam int unsigned LineW    = pipegs_pkg::LineW,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned Lanes    = 16,
  localparam int unsigned WordW    = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned Words    = Regions / Units * 4,
  localparam int unsigned AddrW    = $clog2(Words),
  localparam int unsigned SideW    = $clog2(pipegs_pkg::Window) + 1
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  logic [pipegs_pkg::TW-1:0]            rest_i,  // transmittance at which pixels stop, of the frame; 0: 1/TCut
  input  pipegs_pkg::span_t                  overflow_i,   // the overflow area
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,       // constant
  input  logic                                 restart_i,

  input  logic                                 in_valid_i,
  output logic                                 in_ready_o,
  input  pipegs_pkg::sorted_t                  in_i,

  output logic [Units-1:0]                     read_valid_o,    // to the alpha store of each unit
  input  logic [Units-1:0]                     read_ready_i,
  output logic [pipegs_pkg::AlphaAddressW-1:0] read_address_o,
  output logic                                 read_skip_o,     // the line is freed, not read
  input  logic [Units-1:0]                     answer_valid_i,  // one cycle after the request was taken
  input  logic [Units*LineW-1:0]               answer_i,

  output logic                                 load_valid_o,    // lines that found no room there
  input  logic                                 load_ready_i,
  output logic [AddressW-1:0]                  load_address_o,
  input  logic                                 rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]       rsp_data_i,

  input  logic [Regions-1:0]                   own_i,
  input  logic [Regions-1:0]                   outside_i,  // regions without a pixel inside the image
  input  logic [SideW-1:0]                     columns_i,  // pixels of the window inside the image
  input  logic [SideW-1:0]                     rows_i,
  output logic [Regions-1:0]                   done_o,     // own regions that need no more alphas

  input  logic                                 resolve_ready_i,
  input  logic                                 resolve_read_i,
  input  logic [AddrW-1:0]                     resolve_raddr_i,
  output logic [WordW-1:0]                     resolve_rdata_o,
  output logic                                 resolve_fresh_o,

  output logic                                 layer_done_o,
  output logic                                 window_done_o,
  output logic                                 issue_o,    // a quarter starts
  output logic                                 memory_o,   // the next line comes from memory
  output logic                                 waits_o,    // for an alpha store
  output logic                                 idle_o,

  output logic                                 tap_line_valid_o,  // a line is consumed
  output logic [pipegs_pkg::TapIndexW-1:0]     tap_line_index_o,
  output logic [pipegs_pkg::RegionW-1:0]       tap_line_region_o,
  output logic [LineW-1:0]                     tap_line_o,
  output logic                                 tap_word_valid_o,  // a word of sixteen pixels is written back
  output logic [pipegs_pkg::RegionW-1:0]       tap_word_region_o,
  output logic [1:0]                           tap_word_quarter_o,
  output logic [WordW-1:0]                     tap_word_o
);

  logic               blend_valid, blend_ready, source_idle, lanes_busy;
  pipegs_pkg::blend_t blend;
  logic [LineW-1:0]   line;
  logic [Regions-1:0] blended;
  logic               blend_read, blend_write, blend_fresh;
  logic [AddrW-1:0]   blend_raddr, blend_waddr;
  logic [WordW-1:0]   blend_rdata, blend_wdata;

  ru_source u_source (
    .clk_i,
    .rst_ni,
    .overflow_i,
    .unit_i,
    .done_i(done_o),
    .window_done_i(window_done_o),
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .read_valid_o,
    .read_ready_i,
    .read_address_o,
    .read_skip_o,
    .answer_valid_i,
    .answer_i,
    .mem_valid_o(load_valid_o),
    .mem_ready_i(load_ready_i),
    .mem_address_o(load_address_o),
    .rsp_valid_i,
    .rsp_data_i,
    .out_valid_o(blend_valid),
    .out_ready_i(blend_ready),
    .out_o(blend),
    .out_line_o(line),
    .memory_o,
    .waits_o,
    .idle_o(source_idle)
  );

  ru_lanes u_lanes (
    .clk_i,
    .rst_ni,
    .rest_i,
    .restart_i,
    .in_valid_i(blend_valid),
    .in_ready_o(blend_ready),
    .in_i(blend),
    .in_line_i(line),
    .columns_i,
    .rows_i,
    .done_o(blended),
    .read_o(blend_read),
    .raddr_o(blend_raddr),
    .rdata_i(blend_rdata),
    .fresh_i(blend_fresh),
    .write_o(blend_write),
    .waddr_o(blend_waddr),
    .wdata_o(blend_wdata),
    .resolve_ready_i,
    .layer_done_o,
    .window_done_o,
    .issue_o,
    .busy_o(lanes_busy),
    .tap_region_o(tap_word_region_o),
    .tap_quarter_o(tap_word_quarter_o)
  );

  pipegs_pixel_buffer #(.DataW(WordW), .Words(Words)) u_pixels (
    .clk_i,
    .rst_ni,
    .swap_i(window_done_o),
    .blend_read_i(blend_read),
    .blend_raddr_i(blend_raddr),
    .blend_rdata_o(blend_rdata),
    .blend_fresh_o(blend_fresh),
    .blend_write_i(blend_write),
    .blend_waddr_i(blend_waddr),
    .blend_wdata_i(blend_wdata),
    .resolve_read_i,
    .resolve_raddr_i,
    .resolve_rdata_o,
    .resolve_fresh_o
  );

  assign done_o = own_i & (blended | outside_i);
  assign idle_o = source_idle && !lanes_busy;

  assign tap_line_valid_o  = issue_o && blend_ready;
  assign tap_line_index_o  = blend.index;
  assign tap_line_region_o = blend.region;
  assign tap_line_o        = line;
  assign tap_word_valid_o  = blend_write;
  assign tap_word_o        = blend_wdata;

endmodule
