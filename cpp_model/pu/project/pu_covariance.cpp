// SPDX-License-Identifier: Apache-2.0
// pu_covariance: see pu_covariance.hpp.
#include "cpp_model/pu/project/pu_covariance.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/mantissa.hpp"

namespace pipegs {
namespace {

// 0.3 = m 2^-(MantissaW+1), rounded to nearest.
Mantissa dilation(int width) { return {((uint64_t{3} << (width + 1)) + 5) / 10, -(width + 1)}; }

int64_t exponent(const Config& c, int64_t e) { return saturate(e, c.float_e_w()); }

}  // namespace

Covariance pu_covariance(const Config& c, const Frame&, const Squares& in, const Center& center) {
  Covariance out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  const int w = c.mantissa_w;
  const Mantissa small = dilation(w);
  const Mantissa a0 = multiply(w, {in.gxx_m, 0}, {in.a_m, in.a_e}), c0 = multiply(w, {in.gyy_m, 0}, {in.c_m, in.c_e});
  const Mantissa d0 = multiply(w, {in.gg_m, 0}, {in.d_m, in.d_e});
  const Mantissa a = add(w, a0, small), cc = add(w, c0, small);
  const Mantissa det = add(w, d0, multiply(w, small, add(w, a, c0)));

  // b: two's complement, at most one bit from normalised.
  const int64_t p = static_cast<int64_t>(in.gxy_m) * in.b_m;
  const int width = w + c.factor_w();
  const bool top = ((p >> (width - 1)) & 1) != ((p >> (width - 2)) & 1);
  const int cut = width - c.slope_w() - (top ? 0 : 1);
  out.b_m = p >> cut;
  out.b_e = exponent(c, in.b_e + cut);

  out.a_m = a.m, out.a_e = exponent(c, a.e);
  out.c_m = cc.m, out.c_e = exponent(c, cc.e);
  out.det_m = det.m, out.det_e = exponent(c, det.e);
  if (c.antialias) {
    out.sharp_m = d0.m >> (w - c.sharp_w());
    out.sharp_e = exponent(c, d0.e);
  }
  out.mean_x = center.mean_x;
  out.mean_y = center.mean_y;
  out.opacity = center.opacity;
  return out;
}

}  // namespace pipegs
