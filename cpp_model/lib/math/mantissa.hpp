// SPDX-License-Identifier: Apache-2.0
// mantissa: normalised positive numbers m 2^e (m is zero, or has its leading one in `width` bits): product and sum,
// truncated. (No RTL module of its own: each stage has these few gates beside its shared multiplier.)
#pragma once

#include <cstdint>
#include <utility>

#include "cpp_model/fixed.hpp"

namespace pipegs {

struct Mantissa {
  uint64_t m;
  int64_t e;
};

inline Mantissa multiply(int width, Mantissa x, Mantissa y) {
  const uint64_t p = x.m * y.m;
  const int cut = (p >> (2 * width - 1)) != 0 ? width : width - 1;
  return {p >> cut, x.e + y.e + cut};
}

// Two guard bits below the larger one; zero counts as infinitely small. Not both may be zero.
inline Mantissa add(int width, Mantissa x, Mantissa y) {
  if (x.m == 0 || (y.m != 0 && y.e > x.e)) std::swap(x, y);
  const uint64_t low = y.m == 0 ? 0 : shift_floor(y.m << 2, static_cast<int>(x.e - y.e));
  const uint64_t sum = (x.m << 2) + low;
  const int carry = static_cast<int>(sum >> (width + 2));
  return {sum >> (2 + carry), x.e + carry};
}

}  // namespace pipegs
