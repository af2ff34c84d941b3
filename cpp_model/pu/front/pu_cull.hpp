// SPDX-License-Identifier: Apache-2.0
// pu_cull: moves a Gaussian into view space and drops it when it is behind the near plane or cannot reach the window.
//
// Paper   Sec. 4.2, frustum culling of the preprocessing.
// Idea    view = origin + W offset. A splat reaches at most reach * s / z pixels from its mean, s its largest scale
//         times weight = sqrt(1 - (-log2 opacity) / log2 AlphaCut), plus ReachMargin for the dilation. Times z, each of
//         the four sides is a plane, no division:
//           keep iff  fx x - a z + reach s >= 0,   a = Window window_x - center_x - ReachMargin    (and three more)
//         x, z, s are cut to 17 bits with a common exponent, always to the side that keeps: it never drops a Gaussian
//         with alpha >= 1/AlphaCut in a pixel of the window. Where one part of it is walked the sides are the part's;
//         with lists (order 1) they are those of the rectangle from window_x, window_y to the frame's last one.
// Closed  With Occlusion the sides are those of the rectangle around the open regions: a few regions further in, by the
//         same z. So what is kept then is kept without it too, and the gap stays that of the walk.
// Numbers view s(ViewW-1).0 in units of 2^view_exp, rounded to nearest, saturated (DOPU's view_exp leaves room).
//         near plane exact: keep iff z 2^view_exp > near_plane.
// Gap     With TightCull pu_reach asks how far a mean lies beyond a side: the same sums without reach s, floored to
//         1/16 pixel, so never more than the true distance times z.
// RTL     rtl/pu/front/pu_cull.sv
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kCullWeightF = 8;   // fraction of a weight, u1.8
inline constexpr int kCullWeights = 64;  // entries of the table: the six leading bits of -log2(opacity), u4.2

// Weight of the reach of the Gaussians whose -log2(opacity) begins with these bits, rounded up: 1 to 256.
inline uint64_t cull_weight(const Config& config, int entry) {
  const double rest = 1 - entry / 4.0 / std::log2(config.alpha_cut);
  return std::max<uint64_t>(1, static_cast<uint64_t>(std::ceil(std::sqrt(std::max(0.0, rest)) * (1 << kCullWeightF))));
}

// Nothing for a Gaussian that is dropped; other beats pass with all other fields zero. `behind` counts those that do
// not lie beyond the near plane; with NearTest 0 they are kept, but never one with z <= 0 (there the RTL complains).
// `gap`: what pu_reach needs of a Gaussian that is kept. `closed`: what of the walk needs nothing more (Occlusion);
// `most` of each side with which it is still kept, the others open. `eye`: in whose view.
std::optional<Visible> pu_cull(const Config& config, const Frame& frame, const Fetched& fetched,
                               uint64_t* behind = nullptr, Gap* gap = nullptr, const Closed& closed = {},
                               Closed* most = nullptr, int eye = 0);

}  // namespace pipegs
