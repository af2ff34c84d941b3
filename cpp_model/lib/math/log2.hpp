// SPDX-License-Identifier: Apache-2.0
// log2: the logarithm of a normalised mantissa, by a table of 64 chords.
//
// Idea    f = (i + r / 512) / 64:  log2(1 + f) ~ value[i] + delta[i] r / 512.  A chord lies below the curve; the table
//         holds it raised by half of its largest error, so that the error swings evenly between + and -.
// Stream  m u1.15 with its leading one, so in [1, 2) -> log2(m) u0.16, rounded to nearest.
// Error   at most 3.1e-5 (measured by the test for every input).
// RTL     rtl/lib/math/pipegs_log2.sv
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cpp_model/fixed.hpp"

namespace pipegs {

inline constexpr int kLog2InF = 15, kLog2OutF = 16;
inline constexpr int kLog2IndexW = 6, kLog2PlaceW = kLog2InF - kLog2IndexW;
inline constexpr int kLog2TableF = 18;

struct Log2Line {
  int64_t value, delta;  // both with 18 fraction bits
};

inline const std::array<Log2Line, 64>& log2_table() {
  static const std::array<Log2Line, 64> table = [] {
    std::array<Log2Line, 64> lines{};
    for (int i = 0; i < 64; ++i) {
      const double left = 1 + i / 64.0, right = 1 + (i + 1) / 64.0, rise = std::log2(right) - std::log2(left);
      const double touch = 1 / (64 * rise * std::log(2.0));  // there the curve is as steep as the chord
      const double gap = std::log2(touch) - std::log2(left) - (touch - left) * 64 * rise;
      lines[i] = {std::llround((std::log2(left) + gap / 2) * (1 << kLog2TableF)),
                  std::llround(rise * (1 << kLog2TableF))};
    }
    return lines;
  }();
  return table;
}

inline int64_t log2_mantissa(uint64_t m) {
  const Log2Line& line = log2_table()[m >> kLog2PlaceW & 63];
  const int64_t place = static_cast<int64_t>(m & ((uint64_t{1} << kLog2PlaceW) - 1));
  return shift_round(line.value * (1 << kLog2PlaceW) + line.delta * place, kLog2TableF + kLog2PlaceW - kLog2OutF);
}

}  // namespace pipegs
