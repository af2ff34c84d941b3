// SPDX-License-Identifier: Apache-2.0
// pu_expand: from one Gaussian of the frame to one beat for each window that its box touches.
//
// Paper   the tile intersection of a global preprocessing (GSCore's, as Sec. 5 reproduces it), before the exact test.
// Idea    The box mean +- extent holds pixels of columns x_low .. x_high; divided by Window these are columns of
//         windows. For each of them the mean is moved to the window's first pixel, exactly, and saturated as pu_project
//         does it: the beat is bit for bit what the machine that walks window by window has there.
//         With the oriented box (tile_test = 2) windows that it does not touch are passed over: GSCore's test of a
//         tile, before that of its subtiles.
// RTL     rtl/pu/list/pu_expand.sv
#pragma once

#include <optional>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/box/pu_touch.hpp"
#include "cpp_model/pu/pu_span.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// Columns and rows of windows, counted from the frame's first one.
struct PuExpandBox {
  int64_t first_x, last_x, first_y, last_y;
  bool operator==(const PuExpandBox&) const = default;
};

// Nothing for a Gaussian whose box touches no window of the frame.
inline std::optional<PuExpandBox> pu_expand_box(const Config& c, const Frame& frame, const Conic& conic) {
  const Windows& windows = frame.raster.windows;
  const std::optional<PuSpan> x = pu_span(c, conic.mean_x, conic.extent_x, c.window,
                                          static_cast<int64_t>(windows.last_x - windows.first_x)),
                              y = pu_span(c, conic.mean_y, conic.extent_y, c.window,
                                          static_cast<int64_t>(windows.last_y - windows.first_y));
  if (!x || !y) return std::nullopt;
  return PuExpandBox{x->first, x->last, y->first, y->last};
}

// Whether window (x, y) of that box gets a beat.
inline bool pu_expand_keeps(const Config& c, const Conic& conic, const PuExpandBox& box, int64_t x, int64_t y) {
  return !c.oriented() ||
         pu_touch(c, conic, box.first_x * c.window, box.first_y * c.window, x * c.window, y * c.window, c.window);
}

// The colour job of a Gaussian: once, whatever the number of its windows.
inline ColorJob pu_expand_job(const Payload& p) {
  ColorJob job;
  job.depth = p.depth, job.index = p.index, job.slot = p.slot;
  job.dir_x = p.dir_x, job.dir_y = p.dir_y, job.dir_z = p.dir_z;
  job.base_r = p.base_r, job.base_g = p.base_g, job.base_b = p.base_b;
  return job;
}

// The number of a window: row by row from the frame's first one.
inline uint64_t pu_expand_number(const Frame& frame, int64_t x, int64_t y) {
  return static_cast<uint64_t>(y) * (frame.raster.windows.last_x - frame.raster.windows.first_x + 1) +
         static_cast<uint64_t>(x);
}

// The beat of window (x, y), counted from the frame's first one.
inline Conic pu_expand(const Config& c, const Conic& conic, int64_t x, int64_t y) {
  Conic out = conic;
  const int to_mean = clog2(c.window) + c.mean_f;
  out.mean_x = saturate(conic.mean_x - (x << to_mean), c.window_mean_w());
  out.mean_y = saturate(conic.mean_y - (y << to_mean), c.window_mean_w());
  return out;
}

// What it stands for in that window's list.
inline Listed pu_expand_listed(const Frame& frame, const Colored& colored, int64_t x, int64_t y) {
  return {.depth = colored.depth,
          .index = colored.index,
          .window = pu_expand_number(frame, x, y),
          .red = colored.red,
          .green = colored.green,
          .blue = colored.blue};
}

}  // namespace pipegs
