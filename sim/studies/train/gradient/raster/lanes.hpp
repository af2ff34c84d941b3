// SPDX-License-Identifier: Apache-2.0
// lanes: sixteen numbers side by side, a row of a tile, as vectors of the compiler (GCC and Clang).
//
// Idea    One source for every processor: functions that work on lanes are inlined into one that is compiled once for
//         each level of the processor (PIPEGS_LEVELS) and chosen when the program is loaded. Multiplications and
//         additions are not contracted, and sums have a fixed order: every level gives the same bits.
// Rule    Lanes go by reference: passing them by value would depend on the level.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__x86_64__) && defined(__linux__)
#define PIPEGS_LEVELS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PIPEGS_LEVELS
#endif
#define PIPEGS_INLINED inline __attribute__((always_inline))

namespace pipegs {

template <class Scalar>
struct LanesOf {
  using Integer = std::conditional_t<sizeof(Scalar) == 4, std::int32_t, std::int64_t>;
  typedef Scalar Values __attribute__((vector_size(16 * sizeof(Scalar))));
  typedef Integer Masks __attribute__((vector_size(16 * sizeof(Scalar))));  // -1 or 0 of each; also whole numbers
};
template <class Scalar>
using Lanes = typename LanesOf<Scalar>::Values;
template <class Scalar>
using Masks = typename LanesOf<Scalar>::Masks;

template <class Scalar>
PIPEGS_INLINED void count_lanes(Lanes<Scalar>& lanes) {
  lanes = Lanes<Scalar>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}

template <class Scalar>
PIPEGS_INLINED bool any(const Masks<Scalar>& masks) {
  std::uint64_t words[sizeof(masks) / 8], all = 0;
  std::memcpy(words, &masks, sizeof(masks));
  for (const std::uint64_t word : words) all |= word;
  return all != 0;
}

// Pairwise: eight, four, two, one.
template <class Scalar>
PIPEGS_INLINED Scalar sum(const Lanes<Scalar>& lanes) {
  Scalar values[16];
  std::memcpy(values, &lanes, sizeof(lanes));
  for (int half = 8; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) values[i] += values[i + half];
  }
  return values[0];
}

// 2^x for x <= 0. float: a polynomial of degree 6 round the nearest whole number, within 2e-7 of the result; below
// -126 it stays at 2^-126. double: the library's.
template <class Scalar>
PIPEGS_INLINED void exp2_lanes(Lanes<Scalar>& x) {
  if constexpr (sizeof(Scalar) == 4) {
    constexpr float kShift = 12582912;  // 1.5 * 2^23: adding it rounds to a whole number
    constexpr std::int32_t kShiftBits = 0x4B400000;
    x = x < -126.0f ? Lanes<float>{} - 126.0f : x;
    const Lanes<float> shifted = x + kShift, rest = x - (shifted - kShift);
    const Masks<float> whole = (Masks<float>)shifted - kShiftBits;
    Lanes<float> p = rest * 1.54035304e-4f + 1.33335581e-3f;
    p = p * rest + 9.61812911e-3f;
    p = p * rest + 5.55041087e-2f;
    p = p * rest + 2.40226507e-1f;
    p = p * rest + 6.93147181e-1f;
    p = p * rest + 1.0f;
    x = (Lanes<float>)((Masks<float>)p + (whole << 23));
  } else {
    for (int i = 0; i < 16; ++i) x[i] = std::exp2(x[i]);
  }
}

}  // namespace pipegs
