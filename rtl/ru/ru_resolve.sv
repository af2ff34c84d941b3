// SPDX-License-Identifier: Apache-2.0
// ru_resolve: writes the pixels of a finished window to external memory.
//
// Paper   Fig. 7, the output side of the double buffer. Background is black: the accumulated colour is the pixel.
// Idea    Regions are a power of two, so a line's number is window, region and row side by side. A word of the pixel
//         buffer is two rows of a region, which are one or two lines (ru_pixels). The next word is read while the last
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
  localparam int unsigned MemoryW = pipegs_pkg::MemoryW;

  logic [pipegs_pkg::MaskW-1:0] own;       // regions of this RU
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
      if (start_i) todo_q <= own & ~outside_i;
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

  // --- the word as it lies in memory ---------------------------------------------------------------------------------
  localparam logic [TW-1:0]    Open  = TW'(1) << (TW - 1);  // T is 1
  localparam logic [WordW-1:0] Fresh = {Lanes'(0), {Lanes{Open}}, (Lanes*3*RgbW)'(0)};
  logic [Lanes*PixelW-1:0] lines;

  ru_pixels u_pixels (.word_i(fresh_i ? Fresh : rdata_i), .lines_o(lines));
  assign mem_valid_o = word_valid_q;
  if (WholeWord) begin : gen_packed
    assign mem_address_o = pixels_i + AddressW'({number_q, region_q, quarter_q});
    assign mem_data_o    = lines;
  end else begin : gen_wide
    assign mem_address_o = pixels_i + AddressW'({number_q, region_q, quarter_q, second_q});
    assign mem_data_o    = second_q ? lines[MemoryW +: MemoryW] : lines[0 +: MemoryW];
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || ready_o)
    else $error("ru_resolve: a window came before the last one was written");
  stream_check #(.DataW($bits({mem_address_o, mem_data_o}))) u_check_mem (
    .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_address_o, mem_data_o})
  );
`endif

endmodule
