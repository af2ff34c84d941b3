// SPDX-License-Identifier: Apache-2.0
// ru_lines: a word of pixels as requests to write: which line, what of it, and what it holds.
//
// Idea    By windows a word is one line, or two that follow one another (PixelW 64). In raster order its two rows are
//         halves of lines that lie a stride apart; both halves show the row, and the request says which one counts.
// Stream  A word's first line and its pixels (ru_pixels), which of its requests -> address, halves, data.
//         Combinational.
// Model   cpp_model/ru/ru_resolve.hpp, cpp_model/ru/ru_raster.hpp

module ru_lines #(
  localparam int unsigned Lanes    = 16,
  localparam int unsigned PixelW   = pipegs_pkg::PixelW,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW,
  localparam int unsigned HalfW    = MemoryW / 2
) (
  input  logic                           raster_i,  // else by windows
  input  logic [pipegs_pkg::StrideW-1:0] stride_i,  // lines
  input  logic [AddressW-1:0]            first_i,   // line of the word's first row
  input  logic                           half_i,    // of that line, in raster order
  input  logic                           second_i,  // the second request of the word
  input  logic [Lanes*PixelW-1:0]        lines_i,   // the first row lowest

  output logic [AddressW-1:0]            address_o,
  output logic [pipegs_pkg::HalvesW-1:0] halves_o,  // low half of the line lowest
  output logic [MemoryW-1:0]             data_o
);

  logic [AddressW-1:0] step;
  logic [HalfW-1:0]    row;  // in raster order
  logic [MemoryW-1:0]  line; // by windows

  assign step = raster_i ? AddressW'(stride_i) : AddressW'(1);
  assign row  = second_i ? lines_i[HalfW +: HalfW] : lines_i[HalfW-1:0];
  if (PixelW == 32) begin : gen_packed
    assign line = lines_i;
  end else begin : gen_wide
    assign line = second_i ? lines_i[MemoryW +: MemoryW] : lines_i[MemoryW-1:0];
  end
  assign address_o = second_i ? first_i + step : first_i;
  assign halves_o  = raster_i ? {half_i, !half_i} : '1;
  assign data_o    = raster_i ? {row, row} : line;

endmodule
