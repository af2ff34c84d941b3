// SPDX-License-Identifier: Apache-2.0
// pu_conic.cpp: see pu_conic.hpp, pu_coeff.hpp.
#include "cpp_model/pu/conic/pu_conic.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/recip.hpp"
#include "cpp_model/pu/conic/pu_align.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
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

namespace {

constexpr int kFactorF = 34;  // magnitude bits that a product keeps when it is a factor again

struct Normal {
  int64_t m;
  int e;  // value = m * 2^e
};

// The `bits` leading bits below the sign, floor.
Normal normalise(int64_t x, int bits) {
  const int shift = bit_length(static_cast<uint64_t>(x < 0 ? ~x : x)) - bits;
  return {shift >= 0 ? x >> shift : x * (int64_t{1} << -shift), shift};
}

}  // namespace

Coeff pu_coeff(const Config& config, const Frame&, const Conic& in) {
  Coeff out;
  out.kind = in.kind;
  if (in.kind != kData) return out;
  const int mantissa = config.mantissa_w, normal = mantissa + 2;
  const int slope_f = config.slope_w() - 2;
  const int drop = mantissa + normal - kFactorF;  // of narrow * w and wide * q
  const int slope_drop = mantissa + slope_f - kFactorF;

  const int64_t m = in.slope_m, narrow = static_cast<int64_t>(in.narrow_m), wide = static_cast<int64_t>(in.wide_m);
  const int64_t mean_p = in.swap ? in.mean_y : in.mean_x, mean_q = in.swap ? in.mean_x : in.mean_y;
  const int64_t ne = in.narrow_e, we = in.wide_e;

  Normal q = normalise(mean_q, normal), w = normalise(mean_p * (int64_t{1} << slope_f) - m * mean_q, normal);
  q.e -= config.mean_f;
  w.e -= config.mean_f + slope_f;

  // The products, in the order of the RTL's multiplier.
  const int64_t u = narrow * m;
  const int64_t wide_q = wide * q.m;
  const Int128 a_q = Int128{wide_q >> drop} * q.m;
  const int64_t narrow_w = narrow * w.m;
  const Int128 a_w = Int128{narrow_w >> drop} * w.m;
  const Int128 u_w = Int128{u >> slope_drop} * w.m;
  const Int128 u_m = Int128{u >> slope_drop} * m;

  const int aw = config.a_w(), bw = config.bc_w(), dw = config.def_w();
  PuAlign align{config.coeff_f, std::max(0, 2 * (22 - mantissa))};
  const int64_t f = align(u, ne - slope_f + 1, dw);
  const int64_t c_wide = align(wide_q, we + q.e + 1, bw);
  const int64_t a_wide = align(a_q, we + 2 * q.e + drop, aw);
  const int64_t b = align(narrow_w, ne + w.e + 1, bw);
  const int64_t a_narrow = align(a_w, ne + 2 * w.e + drop, aw);
  const int64_t c_narrow = align(u_w, ne - slope_f + slope_drop + w.e + 1, bw);
  const int64_t e_narrow = align(u_m, ne - 2 * slope_f + slope_drop, dw);
  align.guard = std::max(0, config.coeff_f + 4 - mantissa);
  const int64_t d = align(narrow, ne, dw), e_wide = align(wide, we, dw);

  const int64_t A = -(a_wide + a_narrow) - (static_cast<int64_t>(in.opacity) << (config.coeff_f - config.opacity_f));
  const int64_t C = c_wide - c_narrow, E = -(e_narrow + e_wide);
  out.dead = align.dead || A != saturate(A, aw) || C != saturate(C, bw) || E != saturate(E, dw) ||
             static_cast<int64_t>(in.opacity) >= config.cut_budget();
  out.mean_x = in.mean_x;
  out.mean_y = in.mean_y;
  out.extent_x = in.extent_x;
  out.extent_y = in.extent_y;
  out.tilt = in.tilt, out.side_u = in.side_u, out.side_v = in.side_v;
  if (!out.dead) {
    out.a = A;
    out.b = in.swap ? C : b;
    out.c = in.swap ? b : C;
    out.d = in.swap ? E : -d;
    out.e = in.swap ? -d : E;
    out.f = f;
  }
  return out;
}

}  // namespace pipegs
