// SPDX-License-Identifier: Apache-2.0
// pu_squares: see pu_squares.hpp.
#include "cpp_model/pu/project/pu_squares.hpp"

#include "cpp_model/lib/math/normalize.hpp"

namespace pipegs {
namespace {

// The sum of three products of FactorW bits, as a normalised mantissa of FactorW bits and the exponent it adds.
Normalized narrow(const Config& c, int64_t sum) {
  const int width = 2 * c.factor_w() + 1, cut = width - c.factor_w();
  const Normalized n = normalize(width, sum);
  return {n.value >> cut, cut - n.shift};
}

void square(const Config& c, int64_t x, int64_t y, int64_t z, int64_t e, uint64_t& out_m, int64_t& out_e) {
  const Normalized n = narrow(c, x * x + y * y + z * z);
  out_m = static_cast<uint64_t>(n.value);  // positive, so the sign bit is free: MantissaW bits
  out_e = e + n.shift;
}

}  // namespace

Squares pu_squares(const Config& c, const Frame&, const Factors& in) {
  Squares out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  square(c, in.u0_0, in.u0_1, in.u0_2, 2 * in.u0_e + in.gxx_e, out.a_m, out.a_e);
  square(c, in.u1_0, in.u1_1, in.u1_2, 2 * in.u1_e + in.gyy_e, out.c_m, out.c_e);
  square(c, in.t_0, in.t_1, in.t_2, 2 * in.t_e + in.gg_e, out.d_m, out.d_e);
  const Normalized b = narrow(c, in.u0_0 * in.u1_0 + in.u0_1 * in.u1_1 + in.u0_2 * in.u1_2);
  out.b_m = b.value;
  out.b_e = in.u0_e + in.u1_e + in.gxy_e + b.shift;

  out.gxx_m = in.gxx_m;
  out.gyy_m = in.gyy_m;
  out.gxy_m = in.gxy_m;
  out.gg_m = in.gg_m;
  return out;
}

}  // namespace pipegs
