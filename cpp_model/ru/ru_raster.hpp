// SPDX-License-Identifier: Apache-2.0
// ru_raster: pixels in raster order, RGBA8, as a display takes them: instead of those by windows (ru_resolve.hpp).
//
// Paper   None: it says nothing of how pixels leave.
// Idea    Bytes R, G, B and A = 255, in this order in memory; row y of the picture begins `stride` lines behind row
//         y - 1. A row of a region is half a line, so requests say which half they change. The bytes are the 8-bit
//         picture (to_rgb8 in cpp_model/float/image.hpp) of what lies in memory by windows: 255 c, rounded half up, c
//         at most 1, where with PixelW 32 c is n / 1023.
// Stream  A pixel by windows in, its RGBA8 out. Rows below the picture are not written; to its right black pixels fill
//         the half line, which no other row shares, for stride is in lines.
// RTL     rtl/ru/write/, rtl/ru/place/ru_offset.sv
#pragma once

#include <algorithm>

#include "cpp_model/records.hpp"

namespace pipegs {

// What the host says of the pixels: picture_t of rtl/pipegs_pkg.sv.
struct Picture {
  uint64_t format = 0;            // 0: by windows, at tables.pixels; 1: in raster order
  uint64_t base = 0, stride = 0;  // in raster order: first line, lines from row to row
};

// Packed as picture_t, with a word of padding.
inline std::vector<uint32_t> picture_words(const Config& c, const Picture& picture) {
  std::vector<uint32_t> words(static_cast<size_t>(1 + c.address_w() + c.stride_w()) / 32 + 2);
  put_bits(words.data(), 0, 1, picture.format);
  put_bits(words.data(), 1, c.address_w(), picture.base);
  put_bits(words.data(), 1 + c.address_w(), c.stride_w(), picture.stride);
  return words;
}
inline size_t picture_size(const Config& c) { return picture_words(c, {}).size(); }

// The picture of this width with the least stride.
inline Picture raster_picture(uint64_t base, uint64_t width) {
  return {.format = 1, .base = base, .stride = (width + 15) / 16};
}

// Line of pixel x, y of the picture, its half of that line, its first bit in the line.
inline uint64_t ru_raster_line(const Picture& picture, uint64_t x, uint64_t y) {
  return picture.base + y * picture.stride + x / 16;
}
inline int ru_raster_half(uint64_t x) { return static_cast<int>(x / 8 % 2); }
inline int ru_raster_bit(uint64_t x) { return static_cast<int>(x % 16 * 32); }

// A colour of 10 bits in 8: nearest of 255 n / 1023, which is never half way.
inline uint64_t ru_byte(uint64_t code) { return (code * 255 * 2 + 1023) / (2 * 1023); }

// A pixel as it lies in memory by windows -> RGBA8, red in the low byte.
inline uint32_t ru_rgba8(const Config& c, uint64_t pixel) {
  constexpr int kFraction = 14;  // of a colour of PixelW 64, u2.14
  uint64_t rgba = 0xff000000;
  for (int j = 0; j < 3; ++j) {
    const uint64_t color = c.pixel_w == 32 ? pixel >> 10 * j & 0x3ff : pixel >> 16 * j & 0xffff;
    const uint64_t rounded = (color * 255 + (uint64_t{1} << (kFraction - 1))) >> kFraction;
    rgba |= (c.pixel_w == 32 ? ru_byte(color) : std::min<uint64_t>(rounded, 255)) << 8 * j;
  }
  return static_cast<uint32_t>(rgba);
}

}  // namespace pipegs
