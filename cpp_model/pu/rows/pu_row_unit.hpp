// SPDX-License-Identifier: Apache-2.0
// pu_row_unit: from one pixel of a row to the next with two adders.
//
// Paper   Eq. 3, step 3 of Fig. 5a.           RTL  rtl/pu/rows/pu_row_unit.sv
// Idea    The power is quadratic along the row, so its second difference is constant:
//           power += slope;  slope += 2 curve_x
// Numbers Exact: a power's error is that of the rounded coefficients, at most (1 + 2*7 + 3*49) / 2 = 81 ulp of PowerF.
#pragma once

#include "cpp_model/pu/rows/pu_row_init.hpp"

namespace pipegs {

inline Row pu_row_unit(const Row& row, int64_t curve_x) { return {row.power + row.slope, row.slope + 2 * curve_x}; }

}  // namespace pipegs
