// SPDX-License-Identifier: Apache-2.0
// pu_factors: see pu_factors.hpp.
#include "cpp_model/pu/project/pu_factors.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/mantissa.hpp"

namespace pipegs {
namespace {

constexpr int64_t kLowest = -128;  // exponent of a row of zeros, below that of any other

// A scale or a product of two: m 2^e world units, m unsigned in scale_bits.
struct Scale {
  int64_t m;
  int e;
};

int scale_bits(const Config& c) { return std::min(c.mantissa_w, 2 * (c.scale_m_w + 1)); }

Scale read_scale(const Config& c, uint64_t scale) {
  const int e = static_cast<int>(scale >> c.scale_m_w);
  const int64_t m = static_cast<int64_t>(scale & ((uint64_t{1} << c.scale_m_w) - 1)) | (int64_t{1} << c.scale_m_w);
  return {e == 0 ? 0 : m, e - 8 - c.scale_m_w};
}

Scale times(const Config& c, Scale x, Scale y) {
  const int cut = 2 * (c.scale_m_w + 1) - scale_bits(c);
  return {(x.m * y.m) >> cut, x.e + y.e + cut};
}

// Left-aligned as the products are; up > 0 for every legal configuration.
Scale align(const Config& c, Scale s) {
  const int up = scale_bits(c) - (c.scale_m_w + 1);
  return {s.m << up, s.e - up};
}

// One row: three products with the largest exponent of those that are not zero.
struct Row {
  int64_t m[3];
  int64_t e;
};

Row scaled_row(const Config& c, const int64_t (&m)[3], const int64_t (&e)[3], const Scale (&s)[3]) {
  int64_t top = kLowest;
  for (int i = 0; i < 3; ++i)
    if (m[i] != 0 && s[i].m != 0) top = std::max(top, e[i] + s[i].e);
  Row row{};
  for (int i = 0; i < 3; ++i) {
    if (m[i] == 0 || s[i].m == 0) continue;
    row.m[i] = shift_round(m[i] * s[i].m, scale_bits(c) + static_cast<int>(top - e[i] - s[i].e));
  }
  row.e = top + scale_bits(c);
  return row;
}

}  // namespace

Factors pu_factors(const Config& c, const Frame&, const Jacobian& in) {
  Factors out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  const Scale s0 = read_scale(c, in.scale_0), s1 = read_scale(c, in.scale_1), s2 = read_scale(c, in.scale_2);
  const Scale single[3] = {align(c, s0), align(c, s1), align(c, s2)};
  const Scale pair[3] = {times(c, s1, s2), times(c, s2, s0), times(c, s0, s1)};
  const Row u0 = scaled_row(c, {in.v0_0_m, in.v0_1_m, in.v0_2_m}, {in.v0_0_e, in.v0_1_e, in.v0_2_e}, single);
  const Row u1 = scaled_row(c, {in.v1_0_m, in.v1_1_m, in.v1_2_m}, {in.v1_0_e, in.v1_1_e, in.v1_2_e}, single);
  const Row t = scaled_row(c, {in.n_0_m, in.n_1_m, in.n_2_m}, {in.n_0_e, in.n_1_e, in.n_2_e}, pair);
  out.u0_0 = u0.m[0], out.u0_1 = u0.m[1], out.u0_2 = u0.m[2], out.u0_e = u0.e;
  out.u1_0 = u1.m[0], out.u1_1 = u1.m[1], out.u1_2 = u1.m[2], out.u1_e = u1.e;
  out.t_0 = t.m[0], out.t_1 = t.m[1], out.t_2 = t.m[2], out.t_e = t.e;

  const Mantissa gx{in.gx_m, in.gx_e}, gy{in.gy_m, in.gy_e};
  const Mantissa gxx = multiply(c.mantissa_w, gx, gx), gyy = multiply(c.mantissa_w, gy, gy);
  const Mantissa gxy = multiply(c.mantissa_w, gx, gy), gg = multiply(c.mantissa_w, gxy, gxy);
  out.gxx_m = gxx.m, out.gxx_e = gxx.e;
  out.gyy_m = gyy.m, out.gyy_e = gyy.e;
  out.gxy_m = gxy.m, out.gxy_e = gxy.e;
  out.gg_m = gg.m, out.gg_e = gg.e;
  return out;
}

}  // namespace pipegs
