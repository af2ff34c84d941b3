// SPDX-License-Identifier: Apache-2.0
// ru_pixels: two rows of eight pixels as they lie in external memory.
//
// Paper   Fig. 7, the output side of the double buffer. Background is black: the accumulated colour is the pixel.
// Idea    By windows: with PixelW 64 a row is a line: eight pixels of T u1.15, blue, green, red u2.14, red lowest; T is
//         cut or extended, colours are left-aligned. With PixelW 32 both rows are one line: sixteen of A2B10G10R10.
//         In raster order a row is half a line, eight pixels of RGBA8: the 8-bit picture of what lies there by windows,
//         so with PixelW 32 a byte is rounded from the ten bits.
// Stream  Combinational. word_i: colours, then T, then done flags, pixel 0 lowest in each field.
// Pace    -
// Model   cpp_model/ru/ru_resolve.hpp

module ru_pixels #(
  localparam int unsigned Lanes  = 16,
  localparam int unsigned WordW  = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned PixelW = pipegs_pkg::PixelW
) (
  input  logic [WordW-1:0]        word_i,
  input  logic                    raster_i,  // RGBA8
  output logic [Lanes*PixelW-1:0] lines_o    // the first row lowest
);

  localparam int unsigned TW     = pipegs_pkg::TW;
  localparam int unsigned RgbW   = pipegs_pkg::RgbW;
  localparam int unsigned TLow   = Lanes * 3 * RgbW;
  localparam int unsigned FieldW = PixelW / 4;
  localparam int unsigned BytesW = Lanes * 32;

  logic [Lanes*PixelW-1:0] tiles;
  logic [BytesW-1:0]       bytes;
  assign lines_o[BytesW-1:0] = raster_i ? bytes : tiles[BytesW-1:0];
  if (PixelW > 32) begin : gen_above
    assign lines_o[Lanes*PixelW-1:BytesW] = tiles[Lanes*PixelW-1:BytesW];
  end

  for (genvar i = 0; i < Lanes; i += 1) begin : gen_pixel
    if (PixelW == 32) begin : gen_packed
      logic [29:0] code;
      for (genvar j = 0; j < 3; j += 1) begin : gen_channel
        ru_unorm u_unorm (
          .color_i(word_i[(3*i+j)*RgbW +: RgbW]),
          .code_o(code[10*j +: 10])
        );
        ru_byte u_byte (
          .code_i(code[10*j +: 10]),
          .byte_o(bytes[32*i+8*j +: 8])
        );
      end
      assign tiles[i*PixelW +: PixelW] = {2'b11, code};
    end else begin : gen_wide
      if (TW >= FieldW) begin : gen_cut
        assign tiles[i*PixelW+3*FieldW +: FieldW] = word_i[TLow+i*TW+TW-FieldW +: FieldW];
      end else begin : gen_extend
        assign tiles[i*PixelW+3*FieldW +: FieldW] = {word_i[TLow+i*TW +: TW], (FieldW-TW)'(0)};
      end
      for (genvar j = 0; j < 3; j += 1) begin : gen_channel
        assign tiles[i*PixelW+j*FieldW +: FieldW] = FieldW'(word_i[(3*i+j)*RgbW +: RgbW]) << (FieldW - RgbW);
        ru_unorm #(.CodeW(8)) u_unorm (
          .color_i(word_i[(3*i+j)*RgbW +: RgbW]),
          .code_o(bytes[32*i+8*j +: 8])
        );
      end
    end
    assign bytes[32*i+24 +: 8] = '1;
  end

  logic unused_word;
  assign unused_word = &{1'b0, word_i};

endmodule
