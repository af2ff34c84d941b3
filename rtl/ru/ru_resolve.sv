// SPDX-License-Identifier: Apache-2.0
// ru_resolve: writes the pixels of a finished window to external memory.
//
// Paper   Fig. 7, the output side of the double buffer. Background is black: the accumulated colour is the pixel.
// Idea    Regions are a power of two, so a line's number is window, region and row side by side. A word of the pixel
//         buffer is two rows of a region. With PixelW 64 it is two lines: eight pixels of T u1.15, blue, green, red
//         u2.14, red lowest; with PixelW 32 it is one: sixteen of A2B10G10R10. The next word is read while the last
//         line leaves.
// Stream  start_i with the window's number and the regions to leave out; write requests out. Fresh words are T = 1,
//         black.
// Pace    One line per cycle.
// Model   cpp_model/ru/ru_resolve.hpp

module ru_resolve #(
  localparam int unsigned Lanes = 16,
  localparam int unsigned Words = pipegs_pkg::Regions / pipegs_pkg::Units * 4,
  localparam int unsigned WordW = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned AddrW = $clog2(Words),
  localparam int unsigned NumberW = 2 * pipegs_pkg::WindowW
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic [pipegs_pkg::UnitW-1:0]    unit_i,
  input  logic [pipegs_pkg::AddressW-1:0] pixels_i,   // first line of the frame

  input  logic                            start_i,
  output logic                            ready_o,    // the last window is written
  input  logic [NumberW-1:0]              number_i,   // of the window in the frame
  input  logic [pipegs_pkg::Regions-1:0]  outside_i,  // regions that are not written

  output logic                            read_o,
  output logic [AddrW-1:0]                raddr_o,
  input  logic [WordW-1:0]                rdata_i,
  input  logic                            fresh_i,

  output logic                            mem_valid_o,
  input  logic                            mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0] mem_address_o,
  output logic [pipegs_pkg::MemoryW-1:0]  mem_data_o
);

  localparam int unsigned TW = pipegs_pkg::TW;
  localparam int unsigned RgbW = pipegs_pkg::RgbW;
  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned RegionW = pipegs_pkg::RegionW;
  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned PixelW = pipegs_pkg::PixelW;
  localparam int unsigned TLow = Lanes * 3 * RgbW;
  localparam int unsigned RowPixels = 8;

  logic [pipegs_pkg::MaskW-1:0] own;       // of each part
  logic [Regions-1:0] todo_q;              // regions of which words are still to be read
  logic [Regions-1:0] lowest;              // of them
  logic [1:0]         next_quarter_q;      // of the word to read next
  logic [NumberW-1:0] number_q;
  logic               word_valid_q;        // the pixel buffer shows a word
  logic [RegionW-1:0] next_region, region_q, slot;
  logic [1:0]         quarter_q;
  logic               second_q;            // the second row of the word, where a line holds one
  logic               word_free;

  ru_own u_own (.unit_i, .own_o(own));
  first_set #(.DataW(Regions)) u_lowest (.mask_i(todo_q), .one_hot_o(lowest), .number_o(next_region));
  ru_slot u_slot (.region_i(next_region), .slot_o(slot));

  localparam bit WholeWord = PixelW == 32;  // a line holds the whole word
  assign word_free   = !word_valid_q || ((second_q || WholeWord) && mem_ready_i);
  assign read_o      = todo_q != '0 && word_free;
  assign raddr_o     = AddrW'({slot, next_quarter_q});
  assign ready_o     = todo_q == '0 && !word_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      todo_q         <= '0;
      next_quarter_q <= '0;
      word_valid_q   <= 1'b0;
      second_q       <= 1'b0;
    end else begin
      if (start_i) todo_q <= {pipegs_pkg::Parts{own}} & ~outside_i;
      else if (read_o && next_quarter_q == 2'd3) todo_q <= todo_q & ~lowest;
      if (read_o) next_quarter_q <= next_quarter_q + 1'b1;
      if (word_free) word_valid_q <= read_o;
      if (word_valid_q && mem_ready_i) second_q <= !second_q && !WholeWord;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) number_q <= number_i;
    if (read_o) begin
      region_q  <= next_region;
      quarter_q <= next_quarter_q;
    end
  end

  assign mem_valid_o   = word_valid_q;

  if (WholeWord) begin : gen_packed
    assign mem_address_o = pixels_i + AddressW'({number_q, region_q, quarter_q});
    for (genvar i = 0; i < Lanes; i += 1) begin : gen_pixel
      logic [29:0] code;
      for (genvar j = 0; j < 3; j += 1) begin : gen_channel
        ru_unorm u_unorm (.color_i(rdata_i[(3*i+j)*RgbW +: RgbW]), .code_o(code[10*j +: 10]));
      end
      assign mem_data_o[i*PixelW +: PixelW] = {2'b11, fresh_i ? 30'd0 : code};
    end
  end else begin : gen_wide
    localparam int unsigned FieldW = PixelW / 4;
    assign mem_address_o = pixels_i + AddressW'({number_q, region_q, quarter_q, second_q});
    for (genvar i = 0; i < RowPixels; i += 1) begin : gen_pixel
      localparam int unsigned First = i, Second = RowPixels + i;  // pixels of the word
      logic [FieldW-1:0] t;
      logic [3*RgbW-1:0] rgb;
      if (TW >= FieldW) begin : gen_cut
        assign t = second_q ? rdata_i[TLow+Second*TW+TW-FieldW +: FieldW] : rdata_i[TLow+First*TW+TW-FieldW +: FieldW];
      end else begin : gen_extend
        assign t = {second_q ? rdata_i[TLow+Second*TW +: TW] : rdata_i[TLow+First*TW +: TW], {(FieldW - TW){1'b0}}};
      end
      assign rgb = second_q ? rdata_i[Second*3*RgbW +: 3*RgbW] : rdata_i[First*3*RgbW +: 3*RgbW];
      assign mem_data_o[i*PixelW+3*FieldW +: FieldW] = fresh_i ? FieldW'(1) << (FieldW - 1) : t;
      for (genvar j = 0; j < 3; j += 1) begin : gen_channel
        assign mem_data_o[i*PixelW+j*FieldW +: FieldW] =
          fresh_i ? '0 : FieldW'(rgb[j*RgbW +: RgbW]) << (FieldW - RgbW);
      end
    end
  end

  logic unused_word;
  assign unused_word = &{1'b0, rdata_i, second_q};

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) start_i |-> ready_o)
    else $error("ru_resolve: a window came before the last one was written");
`endif

endmodule
