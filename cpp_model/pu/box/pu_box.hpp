// SPDX-License-Identifier: Apache-2.0
// pu_box: the oriented box of three standard deviations along both axes of a covariance, and the box around it.
//
// Paper   the oriented box of GSCore, from which the paper's baseline is reproduced (Sec. 5.2).
// Idea    With n^2 = 1 + tilt^2 the half lengths times n are those that (1, tilt) and (-tilt, 1) measure:
//           long = 3 sqrt(larger n^2),  short = 3 sqrt(det / larger n^2)
//         Half extents of the box, along the coordinate nearer to the longer axis and along the other one:
//           (long + short |tilt|) / n^2,   (long |tilt| + short) / n^2
// Rule    Never too small: both lengths grow by 2^-13 of the long one, which covers the error of the tilt at the
//         far end of the box, and by two units; extents are those of the grown box, rounded up. What
//         saturates has no end.
// Numbers sides u20.8, extents u18.4.
// RTL     rtl/pu/box/pu_box.sv, only built when tile_test = 2
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kSideF = 8;       // fraction of a side
inline constexpr int kBoxGrowth = 13;  // the boxes grow by 2^-kBoxGrowth

Covariance pu_box(const Config& config, const Frame& frame, const Axes& axes);

}  // namespace pipegs
