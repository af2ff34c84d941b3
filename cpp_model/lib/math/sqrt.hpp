// SPDX-License-Identifier: Apache-2.0
// sqrt: the square root of a number from 15/64 to 1 by one table look-up and one multiplication.
//
// Idea    v = (i + r / 2048) / 64: sqrt(v) ~ value[i] + delta[i] r / 2048, i from 15 to 63. A chord lies below the
//         curve; the table holds it raised by half of its largest error, so that the error swings evenly between + and
//         -. Of v = 1 it gives one. Below 15/64, where no input should be, entry
//         15 stands for all.
// Stream  v u1.17 -> sqrt(v) u1.17, rounded to nearest.
// Error   at most 3.8e-5 (measured by the test for every input).
// RTL     rtl/lib/math/pipegs_sqrt.sv
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cpp_model/fixed.hpp"

namespace pipegs {

inline constexpr double kSqrtError = 3.8e-5;
inline constexpr int kSqrtF = 17;  // fraction of v and of its root
inline constexpr int kSqrtIndexW = 6, kSqrtPlaceW = kSqrtF - kSqrtIndexW;
inline constexpr int kSqrtTableF = 18;
inline constexpr int kSqrtLeast = 15;  // the first entry that counts

struct SqrtLine {
  int64_t value, delta;  // both with 18 fraction bits
};

inline const std::array<SqrtLine, 64>& sqrt_table() {
  static const std::array<SqrtLine, 64> table = [] {
    std::array<SqrtLine, 64> lines{};
    for (int i = kSqrtLeast; i < 64; ++i) {
      const double left = i / 64.0, right = (i + 1) / 64.0, rise = std::sqrt(right) - std::sqrt(left);
      const double touch = 1 / (4 * (64 * rise) * (64 * rise));  // there the curve is as steep as the chord
      const double gap = std::sqrt(touch) - std::sqrt(left) - (touch - left) * 64 * rise;
      lines[static_cast<size_t>(i)] = {std::llround((std::sqrt(left) + gap / 2) * (1 << kSqrtTableF)),
                                       std::llround(rise * (1 << kSqrtTableF))};
    }
    for (int i = 0; i < kSqrtLeast; ++i) lines[static_cast<size_t>(i)] = lines[kSqrtLeast];
    return lines;
  }();
  return table;
}

inline int64_t sqrt_fraction(int64_t v) {
  if (v >= int64_t{1} << kSqrtF) return int64_t{1} << kSqrtF;
  const SqrtLine& line = sqrt_table()[static_cast<size_t>(v >> kSqrtPlaceW & 63)];
  const int64_t place = v & ((int64_t{1} << kSqrtPlaceW) - 1);
  return shift_round(line.value * (1 << kSqrtPlaceW) + line.delta * place, kSqrtTableF + kSqrtPlaceW - kSqrtF);
}

}  // namespace pipegs
