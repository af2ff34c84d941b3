// SPDX-License-Identifier: Apache-2.0
// pu_reach.cpp: see pu_reach.hpp.
#include "cpp_model/pu/front/pu_reach.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"

namespace pipegs {
namespace {

constexpr int kLimitF = 11;     // fraction of the guard band
constexpr int kMostLift = 3;    // most places by which z and x' are shifted up
constexpr int kZW = 9;          // bits of z, a one below makes the 10 of the header
constexpr int kF = 11;          // fraction of W, q, R
constexpr int kGapW = 9;        // bits of the gap
constexpr int kScaleW = 6;      // bits of a scale
constexpr int kMostShift = 31;  // of the comparison, to either side

// The leading bits of an s0.(width-1) or s1.(width-2) number, 10 fraction bits of them, and a one for the middle of
// those left out; all when there are no more.
int64_t middle(int64_t v, int fraction) {
  return fraction > kF - 1 ? (v >> (fraction - (kF - 1))) * 2 + 1 : v << (kF - fraction);
}

// A scale at the exponent of the largest, rounded up.
int64_t scale_at(const Config& c, uint64_t scale, int largest) {
  const int e = static_cast<int>(scale >> c.scale_m_w);
  if (e == 0) return 0;
  const int64_t m = (int64_t{1} << c.scale_m_w) + static_cast<int64_t>(scale & ((uint64_t{1} << c.scale_m_w) - 1));
  return shift_ceil(shift_ceil(m, c.scale_m_w - (kScaleW - 1)), largest - e);
}

}  // namespace

bool pu_reach(const Config& c, const Frame& frame, const Visible& in, const Gap& gap) {
  const bool along_x = gap.gap_x >= gap.gap_y;
  const int64_t g = along_x ? gap.gap_x : gap.gap_y;
  if (gap.untested || g <= 0) return true;

  const int gap_e = bit_length(static_cast<uint64_t>(g)) - kGapW;
  const int64_t gap_m = gap_e >= 0 ? g >> gap_e : g << -gap_e;

  // z and the clamped x or y.
  const int magnitude_bits = c.cut_w() - 1;
  const int64_t limit = static_cast<int64_t>(along_x ? frame.lens.limit_x : frame.lens.limit_y) >> (c.tan_f - kLimitF);
  const int64_t bound = (limit * gap.z) >> kLimitF;
  const int64_t side = std::clamp(along_x ? gap.x : gap.y, -bound, bound);
  const int lift = std::min(kMostLift, magnitude_bits - bit_length(static_cast<uint64_t>(gap.z) |
                                                                   static_cast<uint64_t>(side < 0 ? ~side : side)));
  const int64_t z = (gap.z << lift) >> (magnitude_bits - kZW),
                t = (side * (int64_t{1} << lift)) >> (magnitude_bits - kZW);

  // The axis along which it is measured, in world axes.
  const Rotation& w = frame.camera.rotation;
  const auto component = [&](int64_t across, int64_t forward) {
    return shift_round(middle(across, c.rot_f()) * (2 * z + 1) - middle(forward, c.rot_f()) * (2 * t + 1), kF);
  };
  const int64_t n[3] = {component(along_x ? w.w00 : w.w10, w.w20), component(along_x ? w.w01 : w.w11, w.w21),
                        component(along_x ? w.w02 : w.w12, w.w22)};

  const int64_t qw = middle(in.qw, c.quat_w - 1), qx = middle(in.qx, c.quat_w - 1), qy = middle(in.qy, c.quat_w - 1),
                qz = middle(in.qz, c.quat_w - 1);
  const auto entry = [](int64_t sum) { return middle(sum, 2 * kF); };
  const int64_t r[3][3] = {
      {entry(qw * qw + qx * qx - qy * qy - qz * qz), entry(2 * (qx * qy + qw * qz)), entry(2 * (qx * qz - qw * qy))},
      {entry(2 * (qx * qy - qw * qz)), entry(qw * qw - qx * qx + qy * qy - qz * qz), entry(2 * (qy * qz + qw * qx))},
      {entry(2 * (qx * qz + qw * qy)), entry(2 * (qy * qz - qw * qx)), entry(qw * qw - qx * qx - qy * qy + qz * qz)}};

  const uint64_t scales[3] = {in.scale_0, in.scale_1, in.scale_2};
  const int largest = static_cast<int>(std::max({in.scale_0, in.scale_1, in.scale_2}) >> c.scale_m_w);
  int64_t sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int64_t p = shift_round(n[0] * r[k][0] + n[1] * r[k][1] + n[2] * r[k][2], kF);
    const int64_t q = shift_ceil(scale_at(c, scales[k], largest) * (std::abs(p) + reach_error(c)), kScaleW);
    sum += q * q;
  }

  const uint64_t spread = along_x ? frame.lens.spread_x : frame.lens.spread_y;
  const int spread_e = static_cast<int>(spread >> kSpreadMW);
  const int64_t spread_m = static_cast<int64_t>((spread & ((1 << kSpreadMW) - 1)) | (1 << kSpreadMW));
  const int64_t weight = static_cast<int64_t>(reach_weight(c, static_cast<int>(in.opacity >> (c.opacity_f - 2))));
  const int64_t far = (gap_m * z) >> 6;
  const int64_t reach = shift_ceil(weight * spread_m, 8) * shift_ceil(sum, 7);

  // far^2 2^shift >= reach: gap = gap_m 2^(gap_e-4), z = 2 z 2^u with the unit 2^u of 2z+1, far = gap_m z / 2^6;
  // reach = (r f w)^2 sum / 2^(spread_e - 8 - 4 + 7), sum in 2^12 of scales of 5 fraction bits.
  const int shift = std::clamp(2 * (gap_e - largest + 8 + static_cast<int>(in.view_exp) + static_cast<int>(gap.cut)) -
                                   (spread_e - kSpreadMW) + 1,
                               -kMostShift, kMostShift);
  const Int128 scaled = shift >= 0 ? Int128{far * far} << shift : Int128{far * far} >> -shift;
  return scaled < reach;
}

}  // namespace pipegs
