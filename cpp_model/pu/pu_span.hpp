// SPDX-License-Identifier: Apache-2.0
// pu_span: the columns (or rows) of squares that a Gaussian's box touches along one axis.
//
// Idea    The box mean +- extent holds pixels low .. high; divided by the side of a square (a window of the frame, a
//         part of a window) these are columns of squares.
// Rule    A box is never smaller than what pu_intersect sees in a square. There a saturated mean stands for all that
//         lie beyond it, so an extent within 64 pixels of its largest value counts as endless.
// RTL     rtl/pu/pu_span.sv
#pragma once

#include <algorithm>
#include <optional>

#include "cpp_model/config.hpp"

namespace pipegs {

inline constexpr int kNearlyEndless = 10;  // low bits of an extent, u18.4: 64 pixels

struct PuSpan {
  int64_t first, last;
  bool operator==(const PuSpan&) const = default;
};

// Of the squares 0 .. most, `side` pixels each; nothing when the box has no pixel of them. mean: relative to the first
// pixel of square 0, s(MeanW-1-MeanF).MeanF; extent: u18.4.
inline std::optional<PuSpan> pu_span(const Config& c, int64_t mean, uint64_t extent, int side, int64_t most) {
  if (extent >> kNearlyEndless == (uint64_t{1} << (c.extent_w() - kNearlyEndless)) - 1) return PuSpan{0, most};
  const int64_t half = static_cast<int64_t>(extent) << (c.mean_f - 4), unit = int64_t{1} << c.mean_f;
  const int64_t low = (mean - half + unit - 1) >> c.mean_f, high = (mean + half) >> c.mean_f;  // pixels
  const PuSpan span{std::max<int64_t>(low >> clog2(side), 0), std::min<int64_t>(high >> clog2(side), most)};
  if (low > high || span.first > span.last) return std::nullopt;
  return span;
}

}  // namespace pipegs
