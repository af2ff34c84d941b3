// SPDX-License-Identifier: Apache-2.0
// dopu_hull: which box of a node meets the planes of a window, and grown by which scale.
//
// Paper   None.        RTL  rtl/dopu/dopu_hull.sv
// Idea    Of a window's left plane n = right - e forward a Gaussian at slope t = x / z, t < e, is seen in the direction
//         u = right - t' forward, where t' is t, clamped (Jacobian): it touches the window only if
//           n . mean + sup(u) >= 0, sup(u): the reach of its ellipsoid along u, at most K H with K = 3.33 scale_max and
//         H = hypot(1, limit). Because n . mean = -(e - t) z, such a Gaussian has e - t' <= K H / z, and
//           sup(u) <= sup(n) + (e - t') sup(forward) <= sup(n) + K H (K / z).
//         So where K < z the box around the ellipsoids (hull) holds sup(n), and what is left is the reach of a Gaussian
//         of the smaller scale s' = scale_max K / z. Where K >= z the box of the means counts, grown by scale_max.
//         The other planes are the same by symmetry. z is at least the edge of the bucket of the node's parent.
// Format  Logarithms in 1/64, m - 1 for log2 m: too small by 0 to 0.0861, which HullLog adds to those of scales; the
//         same way back m - 1 is log2 m at most. How much too large that leaves s' the test dopu_hull prints.
#pragma once

#include <algorithm>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

struct Hull {
  bool tight;      // the box around the ellipsoids counts
  uint64_t scale;  // field of a scale, as scale_max
};

// `step`: of depth; no Gaussian of the node that can be seen is nearer (dopu_depth_step).
inline Hull dopu_hull(const Config& config, uint64_t scale_max, int step) {
  if (!config.tight_boxes) return {false, scale_max};
  const int below = config.bucket_bits;
  const auto fraction = static_cast<unsigned>(config.scale_m_w - 6);
  const int depth = below <= 6 ? step << (6 - below) : step >> (below - 6);  // at most 64 log2 z
  const int scale = static_cast<int>(scale_max >> fraction) + 1;             // 64 (log2 scale_max + 8), cut
  const int ratio = scale - 8 * 64 + config.hull_log() - depth;              // at least 64 log2(K / z)
  const bool tight = ratio < -6;                                             // then s' < scale_max
  const int smaller = (scale_max >> config.scale_m_w) == 0 ? 0 : std::max(64, scale + 6 + ratio);
  return {tight, tight ? static_cast<uint64_t>(smaller) << fraction : scale_max};
}

}  // namespace pipegs
