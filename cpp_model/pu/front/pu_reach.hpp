// SPDX-License-Identifier: Apache-2.0
// pu_reach: drops a Gaussian whose own ellipse ends before the window, along the image axis on which it is farther out.
//
// Paper   Sec. 4.2, frustum culling; the paper tests a sphere only.
// Idea    A mean lies G pixels beyond the window, its margin for the dilation included. Along that axis the ellipse
//         ends r w sqrt(a) from the mean, r = sqrt(2 ln AlphaCut), w^2 the part of log2 AlphaCut that the opacity
//         leaves, a = (f/z)^2 sum_k s_k^2 (n . R_k / z)^2 the variance of EWA splatting before the dilation,
//         n = W^T (z, 0, -x') or W^T (0, z, -y'), x' and y' clamped to the guard band. Times z, no division:
//           drop iff  G > 0  and  (G z)^2 >= (r f w)^2 sum_k s_k^2 (|n . R_k| + Error)^2
// Numbers (z, x') 10 bits, W and q s0.11 from 10 bits each and a one below: the middle of what was cut. R s1.11, the
//         same, in the form w^2 + x^2 - y^2 - z^2, whose error is smaller. n and n . R_k rounded to units of z. s_k 6
//         bits, up, at the exponent of the largest. G 9 bits and its product with z 12, down; all others up.
// Bound   In units of z's last bit, at most 2^10 as x' is, so |n| <= 1448; |.| the 2-norm of a vector:
//           z, x'    1 and 2.6 (the clamp's own bound is good to 1.6, in a guard band up to 16)          -> |.| <= 2.8
//           W        2^-11 (|z| + |x'|) in each component                                                      1.8
//           n        half a unit in each                                                                       0.9
//           R        q is within d = 2^-10 + 2^-(QuatW-1) of a unit quaternion, so its matrix within 2 sqrt(2) d;
//                    entries 2^-11 each; the machine's own within 4 2^-(QuatW-1) + 2^-15 of a rotation:
//                    1448 (3.8 2^-10 + 6.9 2^-(QuatW-1))                                     5.4 + 9992 2^-(QuatW-1)
//           n . R_k  rounded                                                                                   0.5
//         The sum, 11.4 + 9992 2^-(QuatW-1), is below Error. That regions are kept for a cut lowered by CutSlack is in
//         the weights, and 2^-8 of `spread` is for what is rounded from the variance to the coefficients. As the reach
//         of pu_cull it counts on the guard band.
// RTL     rtl/pu/front/pu_reach.sv
#pragma once

#include <algorithm>
#include <cmath>

#include "cpp_model/records.hpp"

namespace pipegs {

// w^2, u1.12, of the Gaussians whose -log2(opacity) begins with these six bits (u4.2), rounded up.
inline uint64_t reach_weight(const Config& config, int entry) {
  const double cut = std::log2(config.alpha_cut);
  const double slack = 3 * std::ldexp(static_cast<double>(config.cut_slack()), -config.coeff_f);
  return static_cast<uint64_t>(std::ceil(std::max(0.0, (cut - entry / 4.0 + slack) / cut) * (1 << 12))) + 1;
}

inline constexpr int kSpreadMW = 8;  // mantissa of the lens' field below its leading one

// What |n . R_k| may be too small.
inline int64_t reach_error(const Config& config) { return 13 + (9992 >> (config.quat_w - 1)); }

// Is the Gaussian kept?
bool pu_reach(const Config& config, const Frame& frame, const Visible& visible, const Gap& gap);

}  // namespace pipegs
