// SPDX-License-Identifier: Apache-2.0
// pu_align: a product of mantissas shifted to CoeffF fraction bits, rounded to nearest.
//
// Paper   the coefficients of Eq. 3 in fixed point.
// Idea    A coefficient that is in range is always shifted right (the product is normalised and has more bits than the
//         coefficient; `guard` appends bits where it has not), so a shift of 0 or less is out of range.
// RTL     rtl/pu/conic/pu_align.sv
#pragma once

#include <cstdint>

#include "cpp_model/fixed.hpp"

namespace pipegs {

struct PuAlign {
  int coeff_f, guard;
  bool dead = false;  // something was out of range

  // m * 2^e as a signed number of `width` bits with CoeffF fraction bits.
  int64_t operator()(Int128 m, int64_t e, int width) {
    const int64_t shift = guard - (e + coeff_f);
    const int by = static_cast<int>(shift < 1 ? 1 : shift < 127 ? shift : 127);
    const Int128 low = (m * (Int128{1} << guard)) >> by, x = shift_round(m * (Int128{1} << guard), by);
    const Int128 limit = Int128{1} << (width - 1);
    if (shift <= 0 || x >= limit || low < -limit) {
      dead = true;
      return 0;
    }
    return static_cast<int64_t>(x);
  }
};

}  // namespace pipegs
