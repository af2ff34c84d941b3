// SPDX-License-Identifier: Apache-2.0
// pu_jacobian: see pu_jacobian.hpp.
#include "cpp_model/pu/project/pu_jacobian.hpp"

#include <algorithm>

#include "cpp_model/lib/math/normalize.hpp"
#include "cpp_model/pu/pass.hpp"

namespace pipegs {
namespace {

// Bits of every sum: 26 + TanF for n_k, FocalW + MantissaW + 1 for focal/z.
int sum_width(const Config& c) { return std::max(c.tan_f + 27, c.focal_w() + c.mantissa_w + 1); }

void factor(const Config& c, int64_t sum, int64_t& m, int64_t& e) {
  const int width = sum_width(c), cut = width - c.factor_w();
  const Normalized n = normalize(width, sum);
  m = n.value >> cut;
  e = cut - n.shift - (c.rotation_w() - 2) - c.tan_f;
}

void gain(const Config& c, uint64_t focal, const Oriented& in, uint64_t& m, int64_t& e) {
  const int width = sum_width(c), cut = width - c.factor_w();
  const Normalized n = normalize(width, static_cast<int64_t>(focal * in.inv_z_m));
  m = static_cast<uint64_t>(n.value >> cut);
  e = cut - n.shift - c.focal_f() + in.inv_z_e;
}

}  // namespace

Jacobian pu_jacobian(const Config& c, const Frame& frame, const Oriented& in) {
  Jacobian out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  const int64_t tx = in.tan_x, ty = in.tan_y;
  const auto up = [&](int64_t r) { return static_cast<int64_t>(static_cast<uint64_t>(r) << c.tan_f); };
  factor(c, up(in.r00) - tx * in.r20, out.v0_0_m, out.v0_0_e);
  factor(c, up(in.r01) - tx * in.r21, out.v0_1_m, out.v0_1_e);
  factor(c, up(in.r02) - tx * in.r22, out.v0_2_m, out.v0_2_e);
  factor(c, up(in.r10) - ty * in.r20, out.v1_0_m, out.v1_0_e);
  factor(c, up(in.r11) - ty * in.r21, out.v1_1_m, out.v1_1_e);
  factor(c, up(in.r12) - ty * in.r22, out.v1_2_m, out.v1_2_e);
  factor(c, up(in.r20) + tx * in.r00 + ty * in.r10, out.n_0_m, out.n_0_e);
  factor(c, up(in.r21) + tx * in.r01 + ty * in.r11, out.n_1_m, out.n_1_e);
  factor(c, up(in.r22) + tx * in.r02 + ty * in.r12, out.n_2_m, out.n_2_e);
  gain(c, frame.lens.focal_x, in, out.gx_m, out.gx_e);
  gain(c, frame.lens.focal_y, in, out.gy_m, out.gy_e);

  pass_scales(in, out);
  return out;
}

}  // namespace pipegs
