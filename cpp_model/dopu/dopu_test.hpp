// SPDX-License-Identifier: Apache-2.0
// dopu_test: can a node (a cell or a chunk) hold a mean that touches the window? Never says no when it can.
//
// Paper   Sec. 4.1.        RTL  rtl/dopu/dopu_test.sv
// Idea    The box is that of the means or of the ellipsoids (dopu_hull.hpp). Of its corners the farthest one along
//         a plane's normal decides: n_i >= 0 takes the high side of axis i, else the low side, so a plane costs three
//         products and one for reach * scale (near: -1 * near). Corners, scale and near are brought to one unit 2^e
//         with which the largest fits TestW bits, and floored. Eyes that stand apart (eyes = 2): half the way between
//         them moves x by as much to the one side for one of them and to the other side for the other one, so each side
//         plane moves out by focal * half, or for one eye's walk both to its side, written as a scale whose reach that
//         is (rounded to what lets more pass). Depths are those of the middle.
// Bound   Flooring a corner loses under one unit times n_i, flooring n_i loses under one unit times the corner, the
//         same for reach and scale: together at most 2^(TestW + 2), which is added before the sign is looked at. At a
//         1000 px focal length about 0.07 px on the window's edges for a node ahead (estimate).
#pragma once

#include <algorithm>

#include "cpp_model/dopu/dopu_hull.hpp"
#include "cpp_model/dopu/dopu_planes.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// The box that meets the planes and that of the means, relative to the camera, in units of 2^exponent world units,
// floored: the largest number fits TestW bits.
struct Corners {
  int64_t low[3], high[3], means_low[3], means_high[3];
  uint64_t scale;  // field
  int exponent;
};

// Precondition (the packer's): |centre| < 2^(WorldW - 1), half, 2 down and 2 up << half_exp < 2^WorldW, half at most
// 2 down and 2 up.
// `step`: of depth, that of the parent's bucket (tight_boxes).
inline Corners dopu_test_corners(const Config& config, const Frame& frame, const Node& node, int step) {
  const int64_t delta[3] = {node.center_x - frame.camera.position.x, node.center_y - frame.camera.position.y,
                            node.center_z - frame.camera.position.z};
  const uint64_t halves[3] = {node.half_x, node.half_y, node.half_z},
                 downs[3] = {node.down_x, node.down_y, node.down_z}, ups[3] = {node.up_x, node.up_y, node.up_z};
  const Hull hull = dopu_hull(config, node.scale_max, step);
  Corners box;
  box.scale = hull.scale;
  uint64_t magnitudes = 0;
  for (int i = 0; i < 3; ++i) {
    const auto half = static_cast<int64_t>(halves[i] << node.half_exp);
    const auto down = static_cast<int64_t>(downs[i] << 1 << node.half_exp),
               up = static_cast<int64_t>(ups[i] << 1 << node.half_exp);
    const int64_t low = delta[i] - (hull.tight ? down : half), high = delta[i] + (hull.tight ? up : half);
    box.low[i] = low;
    box.high[i] = high;
    box.means_low[i] = delta[i] - half;
    box.means_high[i] = delta[i] + half;
    magnitudes |= static_cast<uint64_t>(low < 0 ? ~low : low) | static_cast<uint64_t>(high < 0 ? ~high : high);
  }
  const int scale_e = static_cast<int>(box.scale >> config.scale_m_w);
  int length = std::max(bit_length(magnitudes), scale_e - 7);  // scale < 2^(scale_e - 7)
  if (frame.eyes.length != 0) length = std::max(length, static_cast<int>(frame.eyes.length)) + 1;  // of a sum of two
  box.exponent = std::max(0, length - (config.test_w() - 1));
  for (int i = 0; i < 3; ++i) {
    for (int64_t* corner : {&box.low[i], &box.high[i], &box.means_low[i], &box.means_high[i]})
      *corner = shift_floor(*corner, box.exponent);
  }
  return box;
}

// What flooring takes from a sum of products at most.
inline int64_t dopu_test_slack(const Config& config) { return int64_t{1} << (config.test_w() + 2); }

// Which planes of a window does the node pass? A bit for each.
inline unsigned dopu_test_planes(const Config& config, const Frame& frame, const Planes& planes, const Node& node,
                                 int step) {
  const int width = config.test_w();
  const Corners box = dopu_test_corners(config, frame, node, step);
  const int scale_e = static_cast<int>(box.scale >> config.scale_m_w);

  // scale = mantissa * 2^(scale_e - 8 - ScaleMW)
  const int64_t one = int64_t{1} << config.scale_m_w;
  const int64_t mantissa = scale_e == 0 ? 0 : one | static_cast<int64_t>(box.scale & static_cast<uint64_t>(one - 1));
  const int up = scale_e - 8 - config.scale_m_w - box.exponent;
  const int64_t scale = up >= 0 ? mantissa << up : shift_floor(mantissa, -up);
  const int64_t most = (int64_t{1} << (width - 1)) - 1;
  const int64_t near = std::min(most, shift_floor(static_cast<int64_t>(frame.lens.near_plane), box.exponent));
  const int64_t slack = dopu_test_slack(config);
  // low: of the left and the upper plane, which move out for the first eye when half the way is not negative.
  const auto moved = [&](uint64_t reach, int64_t half, bool low) {
    if (reach == 0) return scale;
    const bool out = planes.eye == kAllEyes || (planes.eye == 0) == (low == (half >= 0));
    const int64_t by = shift_floor(static_cast<int64_t>(reach), box.exponent);
    return scale + 1 + (out ? by : -by);
  };
  const Eyes& eyes = frame.eyes;
  const int64_t operands[kPlanes] = {near, moved(eyes.reach_x, eyes.half_x, true),
                                     moved(eyes.reach_x, eyes.half_x, false), moved(eyes.reach_y, eyes.half_y, true),
                                     moved(eyes.reach_y, eyes.half_y, false)};
  unsigned passed = 0;
  for (int side = 0; side < kPlanes; ++side) {
    const Plane& p = planes[static_cast<size_t>(side)];
    const int64_t distance = p.nx * (p.nx >= 0 ? box.high[0] : box.low[0]) +
                             p.ny * (p.ny >= 0 ? box.high[1] : box.low[1]) +
                             p.nz * (p.nz >= 0 ? box.high[2] : box.low[2]) + p.reach * operands[side];
    passed |= unsigned{distance + slack >= 0} << side;
  }
  return passed;
}

// All of them?
inline bool dopu_test(const Config& config, const Frame& frame, const Planes& planes, const Node& node, int step) {
  return dopu_test_planes(config, frame, planes, node, step) == (1u << kPlanes) - 1;
}

}  // namespace pipegs
