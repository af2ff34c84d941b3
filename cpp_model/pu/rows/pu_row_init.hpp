// SPDX-License-Identifier: Apache-2.0
// pu_row_init: where one row of a region starts.
//
// Paper   Eq. 3, step 2 of Fig. 5a.           RTL  rtl/pu/rows/pu_row_init.sv
// Idea    P_init(dy) = power + slope_y dy + curve_y dy^2;   beta(dy) = slope_x + twist dy.
//         The first difference along the row is P(1) - P(0) = beta + curve_x.
// Numbers Exact: PowerF fraction bits everywhere.
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

struct Row {
  int64_t power;  // s20.PowerF, of the row's first pixel
  int64_t slope;  // s13.PowerF, of the next pixel minus this one
};

inline Row pu_row_init(const Region& region, int dy) {
  return {region.power + region.slope_y * dy + region.curve_y * (dy * dy),
          region.slope_x + region.twist * dy + region.curve_x};
}

}  // namespace pipegs
