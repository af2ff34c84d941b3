// SPDX-License-Identifier: Apache-2.0
// ru_resolve: the pixels of a finished window as they lie in external memory.
//
// Paper   Fig. 7: the RU's output buffer. Background is black, so the accumulated colour is the pixel.
// Idea    A line of memory holds one row of a region, eight pixels of 64 bits: T u1.15, blue, green, red u2.14, red
//         lowest. T is truncated (or zero-extended), colour is left-aligned. Regions follow each other window by
//         window.
// Stream  a region's state in, eight lines out. Regions that lie wholly outside the image are not written.
// RTL     rtl/ru/ru_resolve.sv
#pragma once

#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_lanes.hpp"

namespace pipegs {

inline uint64_t ru_windows_x(const Config& c, const Frame& frame) {
  return (frame.raster.width + c.window - 1) / c.window;
}
inline uint64_t ru_windows_y(const Config& c, const Frame& frame) {
  return (frame.raster.height + c.window - 1) / c.window;
}

// Memory line of row `row` (0..7) of a region.
inline uint64_t ru_pixel_line(const Config& c, const Frame& frame, uint64_t window_x, uint64_t window_y, int region,
                              int row) {
  return frame.tables.pixels + ((window_y * ru_windows_x(c, frame) + window_x) * c.regions() + region) * 8 + row;
}

// Whether the region has a pixel inside the image.
inline bool ru_inside(const Config& c, const Frame& frame, uint64_t window_x, uint64_t window_y, int region) {
  return window_x * c.window + 8 * static_cast<uint64_t>(region_x(c, region)) < frame.raster.width &&
         window_y * c.window + 8 * static_cast<uint64_t>(region_y(c, region)) < frame.raster.height;
}

// One pixel in memory.
inline uint64_t ru_resolve(const Config& c, const PixelState& pixel) {
  const uint64_t t = c.t_w >= 16 ? pixel.t >> (c.t_w - 16) : pixel.t << (16 - c.t_w);
  const int up = 16 - c.rgb_w;
  return (t << 48) | (uint64_t{pixel.rgb[2]} << up << 32) | (uint64_t{pixel.rgb[1]} << up << 16) |
         (uint64_t{pixel.rgb[0]} << up);
}

}  // namespace pipegs
