// SPDX-License-Identifier: Apache-2.0
// ru_lanes: sixteen lanes blend a line of alphas into the 64 pixels of a region.
//
// Paper   Table 2: sixteen lanes (the paper's Rendering Units) per RU.
// Idea    A region takes four cycles: quarter q is its pixel rows 2q and 2q+1. Three stages lie between a word's read
//         and its write, and a word comes again after four cycles at the earliest, so regions follow each other
//         without a bubble.
//           cycle 0 read      1 weight = T * alpha      2 weight * colour      3 add, write
// Stream  blend_t and its line in. A word of the pixel buffer: done flags, T, colours (blue, green, red; red lowest)
//         of sixteen pixels, pixel 0 lowest in each. An end beat waits until all is written: then layer_done_o, and
//         for the end of a window also window_done_o, which needs resolve_ready_i.
// Pace    Four cycles per region.
// Model   cpp_model/ru/ru_lanes.hpp

module ru_lanes #(
  localparam int unsigned Lanes = 16,
  localparam int unsigned Words = pipegs_pkg::Regions / pipegs_pkg::Units * 4,
  localparam int unsigned WordW = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned AddrW = $clog2(Words),
  localparam int unsigned SideW = $clog2(pipegs_pkg::Window) + 1
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic [pipegs_pkg::TW-1:0]      rest_i,  // transmittance at which pixels stop, of the frame; 0: 1/TCut
  input  logic                           restart_i,

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  pipegs_pkg::blend_t             in_i,
  input  logic [pipegs_pkg::LineW-1:0]   in_line_i,

  input  logic [SideW-1:0]               columns_i,  // pixels of the window inside the image
  input  logic [SideW-1:0]               rows_i,
  output logic [pipegs_pkg::Regions-1:0] done_o,     // regions that became done by blending

  output logic                           read_o,
  output logic [AddrW-1:0]               raddr_o,
  input  logic [WordW-1:0]               rdata_i,
  input  logic                           fresh_i,
  output logic                           write_o,
  output logic [AddrW-1:0]               waddr_o,
  output logic [WordW-1:0]               wdata_o,

  input  logic                           resolve_ready_i,
  output logic                           layer_done_o,
  output logic                           window_done_o,

  output logic                           issue_o,     // a quarter starts
  output logic                           busy_o,      // a quarter is on its way

  output logic [pipegs_pkg::RegionW-1:0] tap_region_o,   // of the word that is written
  output logic [1:0]                     tap_quarter_o
);

  localparam int unsigned TW = pipegs_pkg::TW;
  localparam int unsigned RgbW = pipegs_pkg::RgbW;
  localparam int unsigned AlphaW = pipegs_pkg::AlphaW;
  localparam int unsigned ColorW = pipegs_pkg::ColorW;
  localparam int unsigned RegionW = pipegs_pkg::RegionW;
  localparam int unsigned PlaceW  = RegionW / 2;
  localparam int unsigned ColorsW = 3 * RgbW;
  localparam logic [TW-1:0] One = TW'(1) << (TW - 1);

  typedef struct packed {  // of a quarter
    logic [Lanes-1:0]              done;
    logic [Lanes-1:0][TW-1:0]      t;
    logic [Lanes-1:0][ColorsW-1:0] rgb;
  } word_t;
  typedef struct packed {logic [ColorW-1:0] blue, green, red;} color_t;
  typedef struct packed {logic [3:0][Lanes*AlphaW-1:0] of;} quarters_t;
  typedef struct packed {logic [Lanes-1:0][AlphaW-1:0] of;} codes_t;
  typedef struct packed {logic [Lanes-1:0][ColorsW-1:0] of;} pixels_t;

  logic                     valid_1_q, valid_2_q, valid_3_q;
  logic [RegionW-1:0]       region_1_q, region_2_q, region_3_q;
  logic [1:0]               quarter_q, quarter_1_q, quarter_2_q, quarter_3_q;
  logic [AddrW-1:0]         address_1_q, address_2_q, address_3_q;
  quarters_t                line;
  codes_t                   codes_1_q;
  color_t                   color_1_q, color_2_q;
  logic [Lanes-1:0]         outside_1_q;
  pixels_t                  rgb_2_q, rgb_3_q;
  word_t                    shown, blended;  // what the buffer shows, what goes back to it
  logic                     is_data, ended;
  logic [RegionW-1:0]       slot;
  logic [Lanes-1:0]         outside;

  // Cycle 0: the quarter, its word and which of its pixels lie outside the image.
  ru_slot u_slot (
    .region_i(in_i.region),
    .slot_o(slot)
  );

  assign is_data       = in_i.kind == pipegs_pkg::KindData;
  assign issue_o       = in_valid_i && is_data;
  assign busy_o        = valid_1_q || valid_2_q || valid_3_q;
  assign ended         = in_valid_i && !is_data && !busy_o &&
                         (in_i.kind != pipegs_pkg::KindWindowEnd || resolve_ready_i);
  assign layer_done_o  = ended;
  assign window_done_o = ended && in_i.kind == pipegs_pkg::KindWindowEnd;
  assign in_ready_o    = is_data ? quarter_q == 2'd3 : ended;
  assign read_o        = issue_o;
  assign raddr_o       = AddrW'({slot, quarter_q});

  logic [PlaceW-1:0] column, row;
  ru_place u_place (
    .region_i(in_i.region),
    .column_o(column),
    .row_o(row)
  );
  always_comb begin
    logic [SideW-1:0] left, top;
    logic [7:0]       columns_out;
    left        = SideW'(column) << 3;
    top         = (SideW'(row) << 3) + (SideW'(quarter_q) << 1);
    columns_out = columns_i <= left ? '1 : columns_i - left >= SideW'(8) ? '0 : 8'hff << (columns_i - left);
    outside     = {rows_i <= top + SideW'(1) ? 8'hff : columns_out, rows_i <= top ? 8'hff : columns_out};
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_1_q <= 1'b0;
      valid_2_q <= 1'b0;
      valid_3_q <= 1'b0;
      quarter_q <= '0;
    end else begin
      valid_1_q <= issue_o;
      valid_2_q <= valid_1_q;
      valid_3_q <= valid_2_q;
      if (issue_o) quarter_q <= quarter_q + 1'b1;
    end
  end

  assign line    = in_line_i;
  assign shown   = rdata_i;
  assign wdata_o = blended;

  always_ff @(posedge clk_i) begin
    if (issue_o) begin
      region_1_q  <= in_i.region;
      quarter_1_q <= quarter_q;
      address_1_q <= raddr_o;
      codes_1_q   <= line.of[quarter_q];
      color_1_q   <= {in_i.blue, in_i.green, in_i.red};
      outside_1_q <= outside;
    end
    if (valid_1_q) begin
      region_2_q  <= region_1_q;
      quarter_2_q <= quarter_1_q;
      address_2_q <= address_1_q;
      color_2_q   <= color_1_q;
      rgb_2_q     <= fresh_i ? '0 : shown.rgb;
    end
    if (valid_2_q) begin
      region_3_q  <= region_2_q;
      quarter_3_q <= quarter_2_q;
      address_3_q <= address_2_q;
      rgb_3_q     <= rgb_2_q;
    end
  end

  // Cycles 1 to 3: the lanes.
  for (genvar i = 0; i < Lanes; i += 1) begin : gen_lane
    ru_blend u_blend (
      .clk_i,
      .rest_i,
      .enable_1_i(valid_1_q),
      .code_i    (codes_1_q.of[i]),
      .t_i       (fresh_i ? One : shown.t[i]),
      .done_i    (fresh_i ? outside_1_q[i] : shown.done[i]),
      .enable_2_i(valid_2_q),
      .red_i     (color_2_q.red),
      .green_i   (color_2_q.green),
      .blue_i    (color_2_q.blue),
      .rgb_i     (rgb_3_q.of[i]),
      .rgb_o     (blended.rgb[i]),
      .t_o       (blended.t[i]),
      .done_o    (blended.done[i])
    );
  end

  if (pipegs_pkg::EarlyStop != 0) begin : gen_done
    logic [pipegs_pkg::Regions-1:0] done_q;
    logic                           all_q, all_done;  // all quarters of this region so far are done
    assign all_done = (quarter_3_q == 2'd0 || all_q) && blended.done == '1;
    assign done_o   = done_q;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) done_q <= '0;
      else if (restart_i || window_done_o) done_q <= '0;
      else if (valid_3_q && quarter_3_q == 2'd3 && all_done) done_q[region_3_q] <= 1'b1;
    end
    always_ff @(posedge clk_i) if (valid_3_q) all_q <= all_done;
  end else begin : gen_open
    assign done_o = '0;
    logic unused_restart;
    assign unused_restart = restart_i;
  end

  assign write_o       = valid_3_q;
  assign waddr_o       = address_3_q;
  assign tap_region_o  = region_3_q;
  assign tap_quarter_o = quarter_3_q;

  logic unused_in;
  assign unused_in = &{1'b0, in_i.ext, in_i.index};

endmodule
