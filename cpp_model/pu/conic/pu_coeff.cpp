// SPDX-License-Identifier: Apache-2.0
#include "cpp_model/pu/conic/pu_coeff.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/conic/pu_align.hpp"

namespace pipegs {
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
