// SPDX-License-Identifier: Apache-2.0
// rsqrt: 1/sqrt(u) of a normalised number by one table look-up and one multiplication.
//
// Idea    Newton's step y (3 - u y^2) / 2 from a fixed y is linear in u, so the table can hold the step itself: for
//         each of 64 intervals of [1, 2) and of [2, 4) the line c0 - c1 f, f in [0, 1) the place in the interval.
//         The line is the chord, lowered by half of its largest error: the error then swings evenly between + and -.
// Stream  u2.18 in [1, 4) -> u0.18 in (1/2, 1).
// Error   |r sqrt(u) - 1| <= 2^-16.1, all 3 * 2^18 inputs (measured by the test).
// RTL     rtl/lib/math/pipegs_rsqrt.sv
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cpp_model/fixed.hpp"

namespace pipegs {

inline constexpr int kRsqrtInF = 18, kRsqrtOutF = 18;  // fractions of u and r
inline constexpr int kRsqrtTableF = 20;                // fraction of c0 and c1
inline constexpr int kRsqrtPlaceW = 13;                // bits of f

struct RsqrtLine {
  int64_t c0, c1;
};

// Line i: i < 64 covers u = 1 + [i, i + 1) / 64, the others u = 2 + [i - 64, i - 63) / 32.
inline const std::array<RsqrtLine, 128>& rsqrt_table() {
  static const std::array<RsqrtLine, 128> table = [] {
    std::array<RsqrtLine, 128> lines{};
    for (int i = 0; i < 128; ++i) {
      const double width = i < 64 ? 1.0 / 64 : 1.0 / 32;
      const double left = i < 64 ? 1 + i * width : 2 + (i - 64) * width;
      const double y0 = 1 / std::sqrt(left), y1 = 1 / std::sqrt(left + width);
      const double slope = (y0 - y1) / width;                   // the chord falls by this
      const double touch = std::cbrt(1 / (4 * slope * slope));  // there the curve is as steep, and farthest below
      const double gap = y0 - slope * (touch - left) - 1 / std::sqrt(touch);
      lines[i] = {std::llround((y0 - gap / 2) * (1 << kRsqrtTableF)), std::llround((y0 - y1) * (1 << kRsqrtTableF))};
    }
    return lines;
  }();
  return table;
}

inline int64_t rsqrt(int64_t u) {
  const bool high = ((u >> (kRsqrtInF + 1)) & 1) != 0;  // u >= 2
  const int index = static_cast<int>(high ? 64 + ((u >> 13) & 63) : (u >> 12) & 63);
  const int64_t place = high ? u & 0x1fff : (u & 0xfff) << 1;
  const RsqrtLine& line = rsqrt_table()[index];
  return shift_round((line.c0 << kRsqrtPlaceW) - line.c1 * place, kRsqrtTableF + kRsqrtPlaceW - kRsqrtOutF);
}

}  // namespace pipegs
