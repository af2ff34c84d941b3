// SPDX-License-Identifier: Apache-2.0
// ru_resolve: writes the pixels of a finished window to external memory.
//
// Paper   Fig. 7, the output side of the double buffer. Background is black: the accumulated colour is the pixel.
// Idea    A word of the pixel buffer is two rows of a region, which are one or two lines, or two halves of lines
//         (ru_pixels, ru_lines). Where it lies is found out when it is read (ru_offset). The next word is read while
//         the last line leaves. In raster order a region ends with the last row of the picture.
// Stream  start_i with the window's first line, its rows and the regions to leave out; write requests out. Fresh words
//         are T = 1, black.
// Pace    One line, or half a line in raster order, per cycle.
// Model   cpp_model/ru/ru_resolve.hpp, cpp_model/ru/ru_raster.hpp

module ru_resolve #(
  localparam int unsigned Lanes = 16,
  localparam int unsigned Words = pipegs_pkg::Regions / pipegs_pkg::Units * 4,
  localparam int unsigned WordW = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned AddrW = $clog2(Words)
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic [pipegs_pkg::UnitW-1:0]    unit_i,
  input  logic                            raster_i,   // pixels in raster order, else by windows
  input  logic [pipegs_pkg::StrideW-1:0]  stride_i,   // lines from row to row, in raster order

  input  logic                            start_i,
  output logic                            ready_o,    // the last window is written
  input  logic [pipegs_pkg::AddressW-1:0] line_i,     // first one of the window's pixels
  input  logic [$clog2(pipegs_pkg::Window):0] columns_i,  // pixels of the window inside the image
  input  logic [$clog2(pipegs_pkg::Window):0] rows_i,
  input  logic [pipegs_pkg::Regions-1:0]  outside_i,  // regions that are not written

  output logic                            read_o,
  output logic [AddrW-1:0]                raddr_o,
  input  logic [WordW-1:0]                rdata_i,
  input  logic                            fresh_i,

  output logic                            mem_valid_o,
  input  logic                            mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0] mem_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]  mem_halves_o,  // of the line
  output logic                            mem_wide_o,    // both are in the picture
  output logic [pipegs_pkg::MemoryW-1:0]  mem_data_o
);

  localparam int unsigned TW = pipegs_pkg::TW;
  localparam int unsigned RgbW = pipegs_pkg::RgbW;
  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned RegionW = pipegs_pkg::RegionW;
  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned PixelW = pipegs_pkg::PixelW;
  localparam int unsigned OffsetW = pipegs_pkg::StrideW + pipegs_pkg::PlacesW + 3;

  logic [pipegs_pkg::MaskW-1:0] own;       // regions of this RU
  logic [Regions-1:0] todo_q;              // regions of which words are still to be read
  logic [Regions-1:0] lowest;              // of them
  logic [1:0]         next_quarter_q;      // of the word to read next
  logic [AddressW-1:0] line_q;
  logic [$clog2(pipegs_pkg::Window):0] columns_q, rows_q;
  logic               word_valid_q;        // the pixel buffer shows a word
  logic [RegionW-1:0] next_region, slot;
  logic [OffsetW-1:0] offset, offset_q;    // of the word from the window's first line
  logic               half, half_q, wide, wide_q, two, two_q, more, shown;
  logic               second_q;            // the second request of the word
  logic               word_free, ends;     // ends: the word read is the last one of its region

  ru_own u_own (
    .unit_i,
    .own_o(own)
  );
  pipegs_first_set #(.DataW(Regions)) u_lowest (
    .mask_i(todo_q),
    .one_hot_o(lowest),
    .number_o(next_region)
  );
  ru_slot u_slot (
    .region_i(next_region),
    .slot_o(slot)
  );

  ru_offset u_offset (
    .raster_i,
    .stride_i,
    .columns_i(columns_q),
    .rows_i(rows_q),
    .region_i(next_region),
    .quarter_i(next_quarter_q),
    .offset_o(offset),
    .half_o(half),
    .wide_o(wide),
    .shown_o(shown),
    .two_o(two),
    .more_o(more)
  );

  assign word_free   = !word_valid_q || ((second_q || !two_q) && mem_ready_i);
  assign ends        = next_quarter_q == 2'd3 || !more;
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
      else if (read_o && ends) todo_q <= todo_q & ~lowest;
      if (read_o) next_quarter_q <= ends ? 2'd0 : next_quarter_q + 1'b1;
      if (word_free) word_valid_q <= read_o;
      if (word_valid_q && mem_ready_i) second_q <= !second_q && two_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) {line_q, columns_q, rows_q} <= {line_i, columns_i, rows_i};
    if (read_o) {offset_q, half_q, wide_q, two_q} <= {offset, half, wide, two};
  end

  // --- the word as it lies in memory ---------------------------------------------------------------------------------
  localparam logic [TW-1:0]    Open  = TW'(1) << (TW - 1);  // T is 1
  localparam logic [WordW-1:0] Fresh = {Lanes'(0), {Lanes{Open}}, (Lanes*3*RgbW)'(0)};
  logic [Lanes*PixelW-1:0] lines;

  ru_pixels u_pixels (
    .word_i(fresh_i ? Fresh : rdata_i),
    .raster_i,
    .lines_o(lines)
  );
  ru_lines u_lines (
    .raster_i,
    .stride_i,
    .first_i(line_q + AddressW'(offset_q)),
    .half_i(half_q),
    .second_i(second_q),
    .lines_i(lines),
    .address_o(mem_address_o),
    .halves_o(mem_halves_o),
    .data_o(mem_data_o)
  );
  assign mem_valid_o = word_valid_q;
  assign mem_wide_o  = wide_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || ready_o)
    else $error("ru_resolve: a window came before the last one was written");
  always_ff @(posedge clk_i) if (rst_ni) assert (!read_o || shown)
    else $error("ru_resolve: a word below the picture is read");
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_halves_o, mem_data_o}))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_halves_o, mem_data_o})
  );
`endif

endmodule
