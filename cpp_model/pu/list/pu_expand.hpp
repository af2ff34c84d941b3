// SPDX-License-Identifier: Apache-2.0
// pu_expand: from one Gaussian of the frame to one beat for each window that its box touches.
//
// Paper   the tile intersection of a global preprocessing (GSCore's, as Sec. 5 reproduces it), before the exact test.
// Idea    The box mean +- extent holds pixels of columns x_low .. x_high; divided by Window these are columns of
//         windows. For each of them the mean is moved to the window's first pixel, exactly, and saturated as pu_project
//         does it: the beat is bit for bit what the machine that walks window by window has there.
// Rule    A box is never smaller than what pu_intersect sees in a window. There a saturated mean stands for all that
//         lie beyond it, so an extent within 64 pixels of its largest value counts as endless.
// RTL     rtl/pu/list/pu_expand.sv
#pragma once

#include <algorithm>
#include <optional>

#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// Columns and rows of windows, counted from the frame's first one.
struct PuExpandBox {
  int64_t first_x, last_x, first_y, last_y;
  bool operator==(const PuExpandBox&) const = default;
};

inline constexpr int kExpandNearlyEndless = 10;  // low bits of an extent, u18.4: 64 pixels

namespace pu_expand_detail {

// False when the box has no pixel of windows 0 .. most.
inline bool span(const Config& c, int64_t mean, uint64_t extent, int64_t most, int64_t& first, int64_t& last) {
  const int64_t half = static_cast<int64_t>(extent) << (c.mean_f - 4), unit = int64_t{1} << c.mean_f;
  const int64_t low = (mean - half + unit - 1) >> c.mean_f, high = (mean + half) >> c.mean_f;  // pixels
  first = std::max<int64_t>(low >> clog2(c.window), 0);
  last = std::min<int64_t>(high >> clog2(c.window), most);
  if (extent >> kExpandNearlyEndless == (uint64_t{1} << (c.extent_w() - kExpandNearlyEndless)) - 1) {
    first = 0;
    last = most;
    return true;
  }
  return low <= high && first <= last;
}

}  // namespace pu_expand_detail

// Nothing for a Gaussian whose box touches no window of the frame.
inline std::optional<PuExpandBox> pu_expand_box(const Config& c, const Frame& frame, const Conic& conic) {
  PuExpandBox box;
  const bool x = pu_expand_detail::span(
      c, conic.mean_x, conic.extent_x, static_cast<int64_t>(frame.raster.windows.last_x - frame.raster.windows.first_x),
      box.first_x, box.last_x);
  const bool y = pu_expand_detail::span(
      c, conic.mean_y, conic.extent_y, static_cast<int64_t>(frame.raster.windows.last_y - frame.raster.windows.first_y),
      box.first_y, box.last_y);
  if (!x || !y) return std::nullopt;
  return box;
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
