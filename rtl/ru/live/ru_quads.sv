// SPDX-License-Identifier: Apache-2.0
// ru_quads: a group of four lanes, which blend the quads of 2x2 pixels that it owns, one in a cycle.
//
// Paper   Eq. 2; four of the sixteen lanes of Table 2.
// Idea    Pixels of different quads have no order, so each group has a queue and goes at its own pace. A quad comes
//         back four cycles later at the earliest: one that is on its way holds its group up.
//           cycle 0 choose  1 exponential  2 code, read  3 weight  4 weight * colour  5 add, write
//         A job of ru_drain takes the place of a quad: its word is read, and written as T = 1, black.
// Stream  halves of regions in, with up to two live quads. A word of pixels is four, row by row: done flags, T,
//         colours (blue, green, red; red lowest). clear_i: a window begins; outside_i is known then.
// Pace    One quad per cycle.
// Model   cpp_model/ru/ru_quads.hpp

module ru_quads #(
  parameter  int unsigned Group     = 0,
  localparam int unsigned Lanes     = 4,
  localparam int unsigned Words     = pipegs_pkg::Regions / pipegs_pkg::Units * 4,
  localparam int unsigned AddrW     = $clog2(Words),
  localparam int unsigned WordW     = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned ColorsW   = 3 * pipegs_pkg::ColorW,
  localparam int unsigned ExponentW = pipegs_pkg::ExponentBits,
  localparam int unsigned PairW     = 8 * ExponentW,
  localparam int unsigned SideW     = $clog2(pipegs_pkg::Window) + 1
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic [pipegs_pkg::TW-1:0]        rest_i,  // transmittance at which pixels stop, of the frame; 0: 1/TCut

  input  logic                             in_valid_i,
  output logic                             in_ready_o,
  input  logic [1:0]                       in_live_i,    // which of the two quads
  input  logic [PairW-1:0]                 in_i,         // their exponents, the first quad's lowest
  input  logic                             in_half_i,
  input  logic [pipegs_pkg::RegionW-1:0]   in_region_i,
  input  logic [ColorsW-1:0]               in_color_i,
  input  logic [pipegs_pkg::TapIndexW-1:0] in_index_i,

  input  logic                             drain_i,      // a finished word is read, and cleared
  input  logic [AddrW-1:0]                 drain_address_i,

  input  logic                             clear_i,
  input  logic [Words-1:0]                 outside_i,  // quads without a pixel inside the image
  input  logic [SideW-1:0]                 columns_i,  // pixels of the window inside the image
  input  logic [SideW-1:0]                 rows_i,
  output logic [Words-1:0]                 stopped_o,  // quads of which all pixels have stopped

  output logic                             read_o,
  output logic [AddrW-1:0]                 raddr_o,
  input  logic [WordW-1:0]                 rdata_i,
  output logic                             write_o,
  output logic [AddrW-1:0]                 waddr_o,
  output logic [WordW-1:0]                 wdata_o,

  output logic                             issue_o,    // a quad starts
  output logic                             busy_o,     // something is inside

  output logic                             tap_quad_valid_o,  // a quad's codes are known
  output logic [pipegs_pkg::TapIndexW-1:0] tap_quad_index_o,
  output logic [pipegs_pkg::RegionW-1:0]   tap_quad_region_o,
  output logic [1:0]                       tap_quad_row_o,
  output logic [Lanes*pipegs_pkg::AlphaW-1:0] tap_quad_o,
  output logic                             tap_word_valid_o,  // a quad is written back
  output logic [pipegs_pkg::RegionW-1:0]   tap_word_region_o,
  output logic [1:0]                       tap_word_row_o
);

  localparam int unsigned TW        = pipegs_pkg::TW;
  localparam int unsigned RgbW      = pipegs_pkg::RgbW;
  localparam int unsigned AlphaW    = pipegs_pkg::AlphaW;
  localparam int unsigned ColorW    = pipegs_pkg::ColorW;
  localparam int unsigned RegionW   = pipegs_pkg::RegionW;
  localparam int unsigned TapIndexW = pipegs_pkg::TapIndexW;
  localparam int unsigned PlaceW    = RegionW / 2;
  localparam int unsigned PixelsW   = 3 * RgbW;
  localparam int unsigned Depth     = pipegs_pkg::RuHalves;
  localparam int unsigned QueuedW   = 2 + PairW + 1 + RegionW + ColorsW + TapIndexW;
  localparam logic [TW-1:0] One = TW'(1) << (TW - 1);
  typedef struct packed {  // of a quad
    logic [Lanes-1:0]              done;
    logic [Lanes-1:0][TW-1:0]      t;
    logic [Lanes-1:0][PixelsW-1:0] rgb;
  } word_t;
  typedef struct packed {logic [ColorW-1:0] blue, green, red;} color_t;
  typedef struct packed {logic [Lanes-1:0][ExponentW-1:0] of;} exponents_t;
  typedef struct packed {logic [Lanes-1:0][AlphaW-1:0] of;} codes_t;
  typedef struct packed {logic [Lanes-1:0][PixelsW-1:0] of;} pixels_t;
  localparam logic [WordW-1:0] Clear = {Lanes'(0), {Lanes{One}}, (Lanes*PixelsW)'(0)};

  // --- the queue, and the quad that is next --------------------------------------------------------------------------
  logic                       half_valid, half, second_q, second, pop;
  logic [1:0]                 live, row;
  logic [PairW-1:0]           pair;
  logic [RegionW-1:0]         region, slot;
  logic [ColorsW-1:0]         color;
  logic [TapIndexW-1:0]       index;
  logic [$clog2(Depth+1)-1:0] count;
  logic [AddrW-1:0]           address;
  logic                       conflict;

  pipegs_sram_fifo #(.DataW(QueuedW), .Depth(Depth)) u_queue (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_i({in_live_i, in_i, in_half_i, in_region_i, in_color_i, in_index_i}),
    .out_valid_o(half_valid),
    .out_ready_i(pop),
    .out_o({live, pair, half, region, color, index}),
    .count_o(count)
  );

  ru_slot u_slot (
    .region_i(region),
    .slot_o(slot)
  );
  assign second  = second_q || !live[0];
  assign row     = {half, second};
  assign address = AddrW'({slot, row});
  assign issue_o = half_valid && !conflict && !drain_i;
  assign pop     = issue_o && (second || !live[1]);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (issue_o) second_q <= !pop;
  end

  // --- the quads on their way ----------------------------------------------------------------------------------------
  logic                      valid_1_q, valid_2_q, valid_3_q, valid_4_q, valid_5_q;
  logic                      drain_1_q, drain_2_q, drain_3_q, drain_4_q, drain_5_q;  // instead of a quad
  logic [RegionW-1:0]        region_1_q, region_2_q, region_3_q, region_4_q, region_5_q;
  logic [1:0]                row_1_q, row_2_q, row_3_q, row_4_q, row_5_q;
  logic [AddrW-1:0]          address_1_q, address_2_q, address_3_q, address_4_q, address_5_q;
  color_t                    color_1_q, color_2_q, color_3_q, color_4_q;
  logic [TapIndexW-1:0]      index_1_q, index_2_q;
  exponents_t                exponents_1_q;
  codes_t                    codes, codes_3_q;
  logic [Lanes-1:0]          outside, outside_3_q;
  pixels_t                   rgb_4_q, rgb_5_q;
  word_t                     shown, blended;  // what the bank shows, what goes back to it

  assign conflict = (valid_1_q && address_1_q == address) || (valid_2_q && address_2_q == address) ||
                    (valid_3_q && address_3_q == address);
  assign busy_o   = count != '0 || valid_1_q || valid_2_q || valid_3_q || valid_4_q || valid_5_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_1_q <= 1'b0;
      valid_2_q <= 1'b0;
      valid_3_q <= 1'b0;
      valid_4_q <= 1'b0;
      valid_5_q <= 1'b0;
    end else begin
      valid_1_q <= issue_o || drain_i;
      valid_2_q <= valid_1_q;
      valid_3_q <= valid_2_q;
      valid_4_q <= valid_3_q;
      valid_5_q <= valid_4_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (issue_o || drain_i) begin
      drain_1_q   <= drain_i;
      address_1_q <= drain_i ? drain_address_i : address;
    end
    if (issue_o) begin
      region_1_q    <= region;
      row_1_q       <= row;
      color_1_q     <= color;
      index_1_q     <= index;
      exponents_1_q <= second ? pair[PairW-1:PairW/2] : pair[PairW/2-1:0];
    end
    if (valid_1_q) begin
      region_2_q  <= region_1_q;
      row_2_q     <= row_1_q;
      address_2_q <= address_1_q;
      drain_2_q   <= drain_1_q;
      color_2_q   <= color_1_q;
      index_2_q   <= index_1_q;
    end
    if (valid_2_q) begin
      region_3_q  <= region_2_q;
      row_3_q     <= row_2_q;
      address_3_q <= address_2_q;
      drain_3_q   <= drain_2_q;
      color_3_q   <= color_2_q;
      codes_3_q   <= codes;
      outside_3_q <= outside;
    end
    if (valid_3_q) begin
      region_4_q  <= region_3_q;
      row_4_q     <= row_3_q;
      address_4_q <= address_3_q;
      drain_4_q   <= drain_3_q;
      color_4_q   <= color_3_q;
      rgb_4_q     <= shown.rgb;
    end
    if (valid_4_q) begin
      region_5_q  <= region_4_q;
      row_5_q     <= row_4_q;
      address_5_q <= address_4_q;
      drain_5_q   <= drain_4_q;
      rgb_5_q     <= rgb_4_q;
    end
  end

  // Cycle 2: which pixels of the quad lie outside the image.
  logic [1:0] column;  // Group + 2 row, modulo 4
  logic [PlaceW-1:0] region_column, region_row;
  ru_place u_place (
    .region_i(region_2_q),
    .column_o(region_column),
    .row_o(region_row)
  );
  assign column = 2'(Group) ^ {row_2_q[0], 1'b0};
  always_comb begin
    logic [SideW-1:0] left, top;
    left    = (SideW'(region_column) << 3) + (SideW'(column) << 1);
    top     = (SideW'(region_row) << 3) + (SideW'(row_2_q) << 1);
    outside = {columns_i <= left + SideW'(1) || rows_i <= top + SideW'(1),
               columns_i <= left || rows_i <= top + SideW'(1),
               columns_i <= left + SideW'(1) || rows_i <= top, columns_i <= left || rows_i <= top};
  end
  assign read_o  = valid_2_q;
  assign raddr_o = address_2_q;

  // --- the lanes -----------------------------------------------------------------------------------------------------
  assign shown = rdata_i;
  for (genvar i = 0; i < Lanes; i += 1) begin : gen_lane
    pu_code u_code (
      .clk_i,
      .enable_i(valid_1_q),
      .exponent_i(exponents_1_q.of[i]),
      .code_o(codes.of[i])
    );
    ru_blend u_blend (
      .clk_i,
      .rest_i,
      .enable_1_i(valid_3_q),
      .code_i    (codes_3_q.of[i]),
      .t_i       (shown.t[i]),
      .done_i    (outside_3_q[i] || shown.done[i]),
      .enable_2_i(valid_4_q),
      .red_i     (color_4_q.red),
      .green_i   (color_4_q.green),
      .blue_i    (color_4_q.blue),
      .rgb_i     (rgb_5_q.of[i]),
      .rgb_o     (blended.rgb[i]),
      .t_o       (blended.t[i]),
      .done_o    (blended.done[i])
    );
  end
  assign write_o = valid_5_q;
  assign waddr_o = address_5_q;
  assign wdata_o = drain_5_q ? Clear : blended;

  // --- what has stopped ----------------------------------------------------------------------------------------------
  logic [Words-1:0] stopped_q;
  logic             finished;  // all pixels of the quad
  assign stopped_o = stopped_q;
  assign finished  = wdata_o[WordW-1:WordW-Lanes] == '1;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) stopped_q <= '0;
    else if (clear_i) stopped_q <= outside_i;
    else if (pipegs_pkg::EarlyStop != 0 && write_o && finished) stopped_q[address_5_q] <= 1'b1;
  end

  assign tap_quad_valid_o  = valid_2_q && !drain_2_q;
  assign tap_quad_index_o  = index_2_q;
  assign tap_quad_region_o = region_2_q;
  assign tap_quad_row_o    = row_2_q;
  assign tap_quad_o        = codes;
  assign tap_word_valid_o  = valid_5_q && !drain_5_q;
  assign tap_word_region_o = region_5_q;
  assign tap_word_row_o    = row_5_q;

endmodule
