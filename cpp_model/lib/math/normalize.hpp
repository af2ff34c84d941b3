// SPDX-License-Identifier: Apache-2.0
// normalize: shifts a signed number left until its two top bits differ.
//
// Idea    Count the copies of the sign below it (leading zeros of x ^ (x >> 1)), then shift in powers of two.
// Numbers Any sI.F of `width` bits: out = in 2^shift, shift 0 to width - 1. Zero stays zero, with the largest shift.
// RTL     rtl/lib/math/pipegs_normalize.sv
#pragma once

#include <cstdint>

#include "cpp_model/fixed.hpp"

namespace pipegs {

struct Normalized {
  int64_t value;
  int shift;
};

// width: of x, at most 64.
inline Normalized normalize(int width, int64_t x) {
  const int shift = width - 1 - bit_length(static_cast<uint64_t>(x < 0 ? ~x : x));
  return {static_cast<int64_t>(static_cast<uint64_t>(x) << shift), shift};
}

}  // namespace pipegs
