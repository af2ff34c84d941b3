// SPDX-License-Identifier: Apache-2.0
// fixed.hpp: the integer operations that the golden model and the RTL share, each with its rounding in its name.
//
// Values are plain int64_t (or Int128 for wide products); the width and the binary point of each are written where it
// is declared (sI.F). Nothing here wraps: a left shift or a sum that could leave 64 bits is done in Int128.
#pragma once

#include <bit>
#include <cstdint>

namespace pipegs {

using Int128 = __int128;
using Uint128 = unsigned __int128;

// floor(x / 2^n), n >= 0; any n, also beyond the width.
template <class T>
constexpr T shift_floor(T x, int n) {
  constexpr int kBits = sizeof(T) * 8;
  return n >= kBits ? (x < 0 ? T(-1) : T(0)) : T(x >> n);
}

// Nearest multiple, ties towards plus infinity: floor((x + 2^(n-1)) / 2^n); n = 0 leaves x as it is.
template <class T>
constexpr T shift_round(T x, int n) {
  if (n == 0) return x;
  constexpr int kBits = sizeof(T) * 8;
  if (n >= kBits) return 0;
  return T((x >> n) + ((x >> (n - 1)) & 1));
}

// ceil(x / 2^n).
template <class T>
constexpr T shift_ceil(T x, int n) {
  return T(-shift_floor(T(-x), n));
}

// Clamp to a signed field of `bits` bits.
template <class T>
constexpr T saturate(T x, int bits) {
  const T high = (T(1) << (bits - 1)) - 1, low = -high - 1;
  return x > high ? high : x < low ? low : x;
}

// Clamp to an unsigned field of `bits` bits.
template <class T>
constexpr T saturate_unsigned(T x, int bits) {
  const T high = (T(1) << bits) - 1;
  return x > high ? high : x < 0 ? T(0) : x;
}

// Number of bits of a non-negative value: 0 -> 0, 1 -> 1, 2 -> 2, 3 -> 2 ...
constexpr int bit_length(uint64_t x) { return 64 - std::countl_zero(x); }
constexpr int bit_length(Uint128 x) {
  return (x >> 64) != 0 ? 64 + bit_length(static_cast<uint64_t>(x >> 64)) : bit_length(static_cast<uint64_t>(x));
}

}  // namespace pipegs
