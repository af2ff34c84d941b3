// SPDX-License-Identifier: Apache-2.0
// ru_resolve: the pixels of a finished window as they lie in external memory.
//
// Paper   Fig. 7: the RU's output buffer. Background is black, so the accumulated colour is the pixel.
// Idea    PixelW 64: a line of memory holds one row of a region, T u1.15, blue, green, red u2.14, red lowest. T is
//         truncated (or zero-extended), colour is left-aligned.
//         PixelW 32: a line holds two rows, as A2B10G10R10 (red lowest) that a display takes: a colour c is
//         round(1023 c), half up, at most 1023; A is 3. T stays in the machine.
//         Regions follow each other window by window.
// Stream  a region's state in, RegionLines lines out. Regions that lie wholly outside the image are not written.
// RTL     rtl/ru/ru_resolve.sv
#pragma once

#include <algorithm>

#include "cpp_model/eyes.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_lanes.hpp"

namespace pipegs {

inline uint64_t ru_windows_x(const Config& c, const Frame& frame) {
  return (frame.raster.width + c.window - 1) / c.window;
}
inline uint64_t ru_windows_y(const Config& c, const Frame& frame) {
  return (frame.raster.height + c.window - 1) / c.window;
}

inline constexpr uint64_t kMostCode = 1023;  // of a colour in 10 bits

// Memory line of row `row` (0..7) of a region, and the first bit of a pixel in it.
inline uint64_t ru_pixel_line(const Config& c, const Frame& frame, uint64_t window_x, uint64_t window_y, int region,
                              int row) {
  return frame.tables.pixels +
         ((window_y * ru_windows_x(c, frame) + window_x) * c.squares() * c.mask_w() +
          static_cast<uint64_t>(region % (c.squares() * c.mask_w()))) *
             c.region_lines() +
         row * c.region_lines() / 8 + static_cast<uint64_t>(region_eye(c, region)) * frame.raster.eye_lines;
}
inline int ru_pixel_bit(const Config& c, int row, int column) {
  return (row % (8 / c.region_lines()) * 8 + column) * c.pixel_w;
}

// Whether the region has a pixel inside the image.
inline bool ru_inside(const Config& c, const Frame& frame, uint64_t window_x, uint64_t window_y, int region) {
  return wants_eye(c, frame, region_eye(c, region)) &&
         window_x * c.window + 8 * static_cast<uint64_t>(region_x(c, region)) < frame.raster.width &&
         window_y * c.window + 8 * static_cast<uint64_t>(region_y(c, region)) < frame.raster.height;
}

// A colour u2.(RgbW-2) in 10 bits.
inline uint64_t ru_unorm(const Config& c, uint64_t color) {
  const int fraction = c.rgb_w - 2;
  return std::min((color * kMostCode + (uint64_t{1} << (fraction - 1))) >> fraction, kMostCode);
}

// One pixel in memory.
inline uint64_t ru_resolve(const Config& c, const PixelState& pixel) {
  if (c.pixel_w == 32)
    return uint64_t{3} << 30 | ru_unorm(c, pixel.rgb[2]) << 20 | ru_unorm(c, pixel.rgb[1]) << 10 |
           ru_unorm(c, pixel.rgb[0]);
  const uint64_t t = c.t_w >= 16 ? pixel.t >> (c.t_w - 16) : pixel.t << (16 - c.t_w);
  const int up = 16 - c.rgb_w;
  return (t << 48) | (uint64_t{pixel.rgb[2]} << up << 32) | (uint64_t{pixel.rgb[1]} << up << 16) |
         (uint64_t{pixel.rgb[0]} << up);
}

}  // namespace pipegs
