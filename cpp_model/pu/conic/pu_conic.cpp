// SPDX-License-Identifier: Apache-2.0
#include "cpp_model/pu/conic/pu_conic.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/recip.hpp"
#include "cpp_model/pu/conic/pu_extent.hpp"

namespace pipegs {
namespace {

constexpr int64_t kK32 = 3098164009;  // log2(e)/2 * 2^32, rounded
struct Float {
  uint64_t m;
  int64_t e;
};

// Product of two normalised mantissas, normalised, rounded to nearest.
Float multiply(int bits, Float x, Float y) {
  const uint64_t product = x.m * y.m;  // 2 * MantissaW - 1 or 2 * MantissaW bits
  const int shift = (product >> (2 * bits - 1)) != 0 ? bits : bits - 1;
  const uint64_t rounded = shift_round(product, shift);
  const bool carry = (rounded >> bits) != 0;
  return {carry ? rounded >> 1 : rounded, x.e + y.e + shift + carry};
}

}  // namespace

Conic pu_conic(const Config& config, const Frame&, const Covariance& in) {
  Conic out;
  out.kind = in.kind;
  if (in.kind != kData) return out;
  const int bits = config.mantissa_w, slope_f = config.slope_w() - 2;

  const bool swap = in.a_e > in.c_e || (in.a_e == in.c_e && in.a_m > in.c_m);
  const Float larger = swap ? Float{in.a_m, in.a_e} : Float{in.c_m, in.c_e};
  const Float k{static_cast<uint64_t>(shift_round(kK32, 32 - bits)), -bits};
  const Float inverse{recip(bits, larger.m), 1 - 2 * bits - larger.e};
  const Float inverse_det{recip(bits, in.det_m), 1 - 2 * bits - in.det_e};
  const Float wide = multiply(bits, inverse, k);
  const Float narrow = multiply(bits, larger, multiply(bits, inverse_det, k));

  // b / larger, at most 1 but for rounding.
  const int64_t product = in.b_m * static_cast<int64_t>(inverse.m);
  const int64_t shift = -(in.b_e + inverse.e + slope_f);
  const int64_t one = int64_t{1} << slope_f;
  const int64_t slope =
      shift <= 0 ? (product < 0   ? -one
                    : product > 0 ? one
                                  : 0)
                 : std::clamp(shift_round(product, static_cast<int>(std::min<int64_t>(shift, 127))), -one, one);

  out.mean_x = in.mean_x;
  out.mean_y = in.mean_y;
  const PuExtent box = config.oriented() ? PuExtent{in.box_x, in.box_y} : pu_extent(config, in);
  out.extent_x = box.x;
  out.extent_y = box.y;
  out.tilt = in.tilt, out.side_u = in.side_u, out.side_v = in.side_v;
  out.swap = swap;
  out.slope_m = slope;
  out.narrow_m = narrow.m;
  out.narrow_e = narrow.e;
  out.wide_m = wide.m;
  out.wide_e = wide.e;
  out.opacity = in.opacity;
  return out;
}

}  // namespace pipegs
