// SPDX-License-Identifier: Apache-2.0
// dopu_depth: in which bucket of depth a node lies: no Gaussian in its box is nearer than the bucket's edge.
//
// Paper   None: the paper's layers know no order inside a slab.
// Idea    The corner of the box nearest along the view bounds the depth z of every mean in it from below. The step is
//         the depth key cut to its exponent and BucketBits bits of mantissa. Counted from the near plane's step on
//         they are 16 octaves of buckets; all that is farther is in the last one. The edge of bucket b is the key of
//         the near plane's step + b.
// Bound   (z from here: as the PU has it, in world units; u = 2^exponent, the unit of dopu_test; sums in u 2^-NormalF.)
//         1 Sum. The normal is floor(w2 / 2^6), the corners floors of exact ones. For n, c >= their floors N, C and
//           any mean (n . d >= n . nearest corner, since N and n have the same signs):
//           n c - N C = N (c - C) + (n - N) c >= min(N, 0) + min(c, 0),
//           of the three axes together >= -(sqrt(3) 2^NormalF + 3 * 2^19) > -2^21 = -8 u.
//         2 Rounding of z. dopu_origin and pu_cull round to nearest once each: 2^view_exp together. With M the bit
//           length of the corners: |centre - camera| <= 2^M on each axis, so |origin| < 2^(M + 1). When offset_exp > 0,
//           an offset unit half as large would not have fitted: half >= 2^(PosW + offset_exp - 3), and half <= 2^M. So
//           view_exp = max(0, L + 2 - ViewW) <= max(0, M + 5 - ViewW, PosW + 2 - ViewW). As u >= 2^(M - 19), u >= 1:
//           2^view_exp <= u 2^max(0, 24 - ViewW, PosW + 2 - ViewW). M and u of a parent are not smaller than those of
//           its children. With eyes apart M is at least the bits of half the way between them, and u and 2^view_exp
//           are twice as large; u may be 1 all the same, so PosW + 3 there.
//         3 A Gaussian behind the near plane is culled, so z > near, and the key is monotone in z: it is z cut to a
//           float. So with z >= B = sum - 2^21 - rounding: key(z) >= key(max(B, near)) >= edge of the bucket.
// RTL     rtl/dopu/nearest/dopu_depth.sv, the sum in dopu_test.sv
#pragma once

#include <algorithm>

#include "cpp_model/dopu/dopu_test.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kNormalF = 18;  // fraction of the near plane's normal: RotF - (RotW - TestW)

// What the sum of products loses to roundings at most, unit 2^(exponent - kNormalF) world units.
inline int64_t dopu_depth_slack(const Config& config) {
  const int rounding = std::max({0, 24 - config.view_w, config.pos_w + (config.eyes > 1 ? 3 : 2) - config.view_w});
  return (int64_t{1} << (config.test_w() + 1)) + (int64_t{1} << (rounding + kNormalF));
}

// Lower bound of the depth in a node, unit 2^(corners' exponent - kNormalF) world units; may be negative.
inline int64_t dopu_depth_bound(const Config& config, const Corners& box, const Plane& near) {
  return near.nx * (near.nx >= 0 ? box.means_low[0] : box.means_high[0]) +
         near.ny * (near.ny >= 0 ? box.means_low[1] : box.means_high[1]) +
         near.nz * (near.nz >= 0 ? box.means_low[2] : box.means_high[2]) - dopu_depth_slack(config);
}

// Exponent and leading mantissa bits of the depth key of value * 2^exponent world units; below one unit: 0.
inline int dopu_depth_step(const Config& config, int64_t value, int exponent) {
  const int below = config.bucket_bits;
  if (value <= 0) return 0;
  const int length = bit_length(static_cast<uint64_t>(value)), high = length - 1 + exponent;
  if (high < 0) return 0;
  const int64_t leading = length > below ? value >> (length - 1 - below) : value << (below + 1 - length);
  return high << below | static_cast<int>(leading & ((1 << below) - 1));
}

// The step in which the buckets of a frame begin.
inline int dopu_depth_near(const Config& config, const Frame& frame) {
  return dopu_depth_step(config, static_cast<int64_t>(frame.lens.near_plane), 0);
}

// The step of a bucket's edge.
inline int dopu_depth_edge(const Config& config, const Frame& frame, int bucket) {
  return dopu_depth_near(config, frame) + bucket;
}

// The bucket of a node whose parent's is known; never a smaller one than that.
inline int dopu_depth(const Config& config, const Frame& frame, const Planes& planes, const Node& node, int parent) {
  const Corners box = dopu_test_corners(config, frame, node, dopu_depth_edge(config, frame, parent));
  const int step = dopu_depth_step(config, dopu_depth_bound(config, box, planes[kNear]), box.exponent - kNormalF);
  return std::clamp(step - dopu_depth_near(config, frame), parent, (1 << config.bucket_w()) - 1);
}

// The same sum of the corner farthest along the view, of the box that meets the planes: about where the node ends. No
// bound, and nothing needs one.
inline int64_t dopu_depth_end(const Config& config, const Corners& box, const Plane& near) {
  return near.nx * (near.nx >= 0 ? box.high[0] : box.low[0]) + near.ny * (near.ny >= 0 ? box.high[1] : box.low[1]) +
         near.nz * (near.nz >= 0 ? box.high[2] : box.low[2]) + dopu_test_slack(config);
}

// The bucket in which a node ends; without regard to that in which it begins.
inline int dopu_depth_far(const Config& config, const Frame& frame, const Planes& planes, const Node& node,
                          int parent) {
  const Corners box = dopu_test_corners(config, frame, node, dopu_depth_edge(config, frame, parent));
  const int step = dopu_depth_step(config, dopu_depth_end(config, box, planes[kNear]), box.exponent - kNormalF);
  return std::clamp(step - dopu_depth_near(config, frame), 0, (1 << config.bucket_w()) - 1);
}

// The edge of a bucket: no depth key in it, nor in any later one, is smaller.
inline uint64_t dopu_depth_key(const Config& config, const Frame& frame, int bucket) {
  return static_cast<uint64_t>(dopu_depth_edge(config, frame, bucket)) << (config.depth_w - config.step_w());
}

}  // namespace pipegs
