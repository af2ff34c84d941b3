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
  localparam int unsigned FieldW = PixelW / 4;
  localparam int unsigned BytesW = Lanes * 32;

  typedef struct packed {
    logic [Lanes-1:0]             done;
    logic [Lanes-1:0][TW-1:0]     t;
    logic [3*Lanes-1:0][RgbW-1:0] color;  // red, green, blue of the first pixel, of the second, ...
  } word_t;
  typedef struct packed {logic [4*Lanes-1:0][7:0] of;} bytes_t;
  typedef struct packed {logic [Lanes-1:0][PixelW-1:0] of;} pixels_t;
  word_t                   word;
  pixels_t                 pixels;
  logic [Lanes*PixelW-1:0] tiles;
  bytes_t                  bytes;
  assign word  = word_i;
  assign tiles = pixels;
  assign lines_o[BytesW-1:0] = raster_i ? bytes : tiles[BytesW-1:0];
  if (PixelW > 32) begin : gen_above
    assign lines_o[Lanes*PixelW-1:BytesW] = tiles[Lanes*PixelW-1:BytesW];
  end

  for (genvar i = 0; i < Lanes; i += 1) begin : gen_pixel
    if (PixelW == 32) begin : gen_packed
      logic [29:0] code;
      for (genvar j = 0; j < 3; j += 1) begin : gen_channel
        ru_unorm u_unorm (
          .color_i(word.color[3*i+j]),
          .code_o(code[10*j +: 10])
        );
        ru_byte u_byte (
          .code_i(code[10*j +: 10]),
          .byte_o(bytes.of[4*i+j])
        );
      end
      assign pixels.of[i] = {2'b11, code};
    end else begin : gen_wide
      localparam int unsigned Left = FieldW - RgbW;
      logic [FieldW-1:0] t;
      if (TW >= FieldW) begin : gen_cut
        assign t = word.t[i][TW-1:TW-FieldW];
      end else begin : gen_extend
        assign t = {word.t[i], (FieldW-TW)'(0)};
      end
      for (genvar j = 0; j < 3; j += 1) begin : gen_channel
        ru_unorm #(.CodeW(8)) u_unorm (
          .color_i(word.color[3*i+j]),
          .code_o(bytes.of[4*i+j])
        );
      end
      assign pixels.of[i] = {t, FieldW'(word.color[3*i+2]) << Left, FieldW'(word.color[3*i+1]) << Left,
                             FieldW'(word.color[3*i]) << Left};
    end
    assign bytes.of[4*i+3] = '1;
  end

  logic unused_word;
  assign unused_word = &{1'b0, word};

endmodule
