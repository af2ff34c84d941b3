// dopu_test: can a node (a cell or a chunk) hold a mean that touches the window? Never says no when it can.
//
// Paper   Sec. 4.1.        RTL  rtl/dopu/dopu_test.sv
// Idea    Of the corners of the box, the one farthest along a plane's normal decides: n_i >= 0 takes the high side of
//         axis i, else the low side, so a plane costs three products and one for reach * scale (near: -1 * near).
//         Corners, scale and near are brought to one unit 2^e with which the largest fits TestW bits, and floored.
// Bound   Flooring a corner loses under one unit times n_i, flooring n_i loses under one unit times the corner, the same
//         for reach and scale: together at most 2^(TestW + 2), which is added before the sign is looked at.
//         At a 1000 px focal length about 0.07 px on the window's edges for a node ahead (estimate).
#pragma once

#include <algorithm>

#include "cpp_model/dopu/dopu_planes.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// Precondition (the packer's): |centre| < 2^(WorldW - 1), half << half_exp < 2^WorldW.
inline bool dopu_test(const Config& config, const Frame& frame, const Planes& planes, const Node& node) {
  const int width = config.test_w();
  const int64_t delta[3] = {node.center_x - frame.camera_x, node.center_y - frame.camera_y, node.center_z - frame.camera_z};
  const uint64_t halves[3] = {node.half_x, node.half_y, node.half_z};
  int64_t low[3], high[3];
  uint64_t magnitudes = 0;
  for (int i = 0; i < 3; ++i) {
    const int64_t half = static_cast<int64_t>(halves[i] << node.half_exp);
    low[i] = delta[i] - half;
    high[i] = delta[i] + half;
    magnitudes |= static_cast<uint64_t>(low[i] < 0 ? ~low[i] : low[i]) | static_cast<uint64_t>(high[i] < 0 ? ~high[i] : high[i]);
  }
  const int scale_e = static_cast<int>(node.scale_max >> config.scale_m_w);
  const int length = std::max(bit_length(magnitudes), scale_e - 7);  // scale < 2^(scale_e - 7)
  const int exponent = std::max(0, length - (width - 1));

  // scale = mantissa * 2^(scale_e - 8 - ScaleMW)
  const int64_t one = int64_t{1} << config.scale_m_w;
  const int64_t mantissa = scale_e == 0 ? 0 : one | static_cast<int64_t>(node.scale_max & static_cast<uint64_t>(one - 1));
  const int up = scale_e - 8 - config.scale_m_w - exponent;
  const int64_t scale = up >= 0 ? mantissa << up : shift_floor(mantissa, -up);
  const int64_t most = (int64_t{1} << (width - 1)) - 1;
  const int64_t near = std::min(most, shift_floor(static_cast<int64_t>(frame.near_plane), exponent));
  for (int i = 0; i < 3; ++i) {
    low[i] = shift_floor(low[i], exponent);
    high[i] = shift_floor(high[i], exponent);
  }
  const int64_t slack = int64_t{1} << (width + 2);
  bool inside = true;
  for (int side = 0; side < kPlanes; ++side) {
    const Plane& p = planes[static_cast<size_t>(side)];
    const int64_t distance = p.nx * (p.nx >= 0 ? high[0] : low[0]) + p.ny * (p.ny >= 0 ? high[1] : low[1]) +
                             p.nz * (p.nz >= 0 ? high[2] : low[2]) + p.reach * (side == kNear ? near : scale);
    inside = inside && distance + slack >= 0;
  }
  return inside;
}

}  // namespace pipegs
