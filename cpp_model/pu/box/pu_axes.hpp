// SPDX-License-Identifier: Apache-2.0
// pu_axes: the eigenvectors of a covariance as a slope, its larger eigenvalue, and how the slope stretches lengths.
//
// Paper   the oriented box of GSCore, from which the paper's baseline is reproduced (Sec. 5.2).
// Idea    With A the larger and C the smaller variance, b the covariance, d = A - C, r = sqrt(d^2 + 4 b^2):
//           slope of the longer axis, towards the wider coordinate:  s = 2 b / (d + r), at most 1, nothing cancels
//           larger eigenvalue (A + C + r) / 2;   1 + s^2 = 2 r / (d + r)
//         tilt = s when x is the wider coordinate, else -s: the axes are (1, tilt) and (-tilt, 1).
//         A covariance whose d and 2|b| are below 1024 units of A's last place counts as round: its axes are x and y.
// Numbers d and 2b exact to 2^-8 of A's last place, then 20 leading bits of the larger of both.
// Error   tilt 2^-15.5, stretch and shrink 2^-15 relative, long 2^-16 relative (measured by the test).
// RTL     rtl/pu/box/pu_axes.sv, only built when tile_test = 2
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kTiltF = 16, kShareF = 18;  // fractions of tilt; of stretch and shrink
inline constexpr int kAxisM = 24;                // bits of long_m and inverse_m

Axes pu_axes(const Config& config, const Frame& frame, const Covariance& covariance);

}  // namespace pipegs
