// SPDX-License-Identifier: Apache-2.0
// pu_project.cpp: the stages from a Gaussian in view space to its covariance on the screen, in their order.
#include "cpp_model/pu/project/pu_project.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/log2.hpp"
#include "cpp_model/lib/math/mantissa.hpp"
#include "cpp_model/lib/math/normalize.hpp"
#include "cpp_model/lib/math/recip.hpp"
#include "cpp_model/pu/pass.hpp"
#include "cpp_model/pu/project/pu_compensate.hpp"
#include "cpp_model/pu/project/pu_covariance.hpp"
#include "cpp_model/pu/project/pu_factors.hpp"
#include "cpp_model/pu/project/pu_jacobian.hpp"
#include "cpp_model/pu/project/pu_orient.hpp"
#include "cpp_model/pu/project/pu_squares.hpp"

namespace pipegs {
namespace {

// A ratio x/z = m 2^-down; m has ViewW bits and is normalised but for one bit.
struct Ratio {
  int64_t m;
  int down;
};

Ratio divide(const Config& c, int64_t x, uint64_t inv_z, int z_bits) {
  const Normalized n = normalize(c.view_w, x);
  // x/z = x inv_z 2^-(MantissaW + z_bits - 1)
  return {shift_round(n.value * static_cast<int64_t>(inv_z), c.mantissa_w), n.shift + z_bits - 1};
}

int64_t clamped_tan(const Config& c, Ratio r, uint64_t limit, bool& clamped) {
  const int down = r.down - c.tan_f;
  const Int128 exact = down >= 0 ? Int128{shift_round(r.m, down)} : Int128{r.m} << -down;
  const Int128 bound = static_cast<Int128>(limit), held = std::clamp(exact, -bound, bound);
  clamped |= held != exact;
  return static_cast<int64_t>(c.guard_band ? held : saturate(exact, c.tan_w()));
}

int64_t mean(const Config& c, Ratio r, uint64_t focal, int64_t center, uint64_t window, bool& saturated) {
  const int64_t pixels = shift_round(static_cast<int64_t>(focal) * r.m, c.focal_f() + r.down - c.mean_f);  // sI.MeanF
  const int up = c.mean_f - c.center_f();
  const int64_t offset =
      (up >= 0 ? center << up : shift_round(center, -up)) - (static_cast<int64_t>(window) * c.window << c.mean_f);
  const int64_t value = saturate(pixels + offset, c.mean_w());
  saturated |= value != pixels + offset;
  return value;
}

int64_t direction(const Config& c, int64_t v, int bits) {
  const int down = bits - (c.direction_w() - 1);
  return down >= 0 ? v >> down : v << -down;
}

}  // namespace

ProjectedParts pu_project(const Config& c, const Frame& frame, const Visible& in, ProjectCounts* counts) {
  ProjectedParts parts;
  auto& [out, center, payload] = parts;
  out.kind = in.kind;
  if (in.kind != kData) return parts;

  // z > 0, so its normalised value has a zero sign and a leading one below.
  const Normalized z = normalize(c.view_w, in.view_z);
  const int z_bits = c.view_w - 1 - z.shift;
  const int cut = c.view_w - 1 - c.mantissa_w;
  const int64_t z_m = cut >= 0 ? saturate_unsigned(shift_round(z.value, cut), c.mantissa_w) : z.value << -cut;
  out.inv_z_m = recip(c.mantissa_w, static_cast<uint64_t>(z_m));
  out.inv_z_e = -(c.mantissa_w + z_bits - 1 + static_cast<int>(in.view_exp));

  const Ratio x = divide(c, in.view_x, out.inv_z_m, z_bits), y = divide(c, in.view_y, out.inv_z_m, z_bits);
  bool beyond = false, clipped = false;
  out.tan_x = clamped_tan(c, x, frame.lens.limit_x, beyond);
  out.tan_y = clamped_tan(c, y, frame.lens.limit_y, beyond);
  center.mean_x = mean(c, x, frame.lens.focal_x, frame.lens.center_x, in.window_x, clipped);
  center.mean_y = mean(c, y, frame.lens.focal_y, frame.lens.center_y, in.window_y, clipped);
  if (counts != nullptr) counts->saturated += clipped, counts->clamped += beyond;

  const int key_w = c.depth_w - c.exp_w(), below_w = c.view_w - 2;
  const uint64_t below = static_cast<uint64_t>(z.value) & ((uint64_t{1} << below_w) - 1);
  const uint64_t high = std::min<uint64_t>(z_bits - 1 + in.view_exp, (uint64_t{1} << c.exp_w()) - 1);
  payload.depth = (high << key_w) | (key_w <= below_w ? below >> (below_w - key_w) : below << (key_w - below_w));

  const auto size = [](int64_t v) { return static_cast<uint64_t>(v < 0 ? ~v : v); };
  const int bits = bit_length(size(in.view_x) | size(in.view_y) | size(in.view_z));
  payload.dir_x = direction(c, in.view_x, bits);
  payload.dir_y = direction(c, in.view_y, bits);
  payload.dir_z = direction(c, in.view_z, bits);

  pass_quaternion(in, out);
  pass_scales(in, out);
  center.opacity = in.opacity;
  payload.base_r = in.base_r;
  payload.base_g = in.base_g;
  payload.base_b = in.base_b;
  payload.index = in.index;
  payload.slot = in.slot;
  payload.walk = in.walk;
  payload.eye = in.eye;
  return parts;
}

Oriented pu_orient(const Config& c, const Frame& frame, const Projected& in) {
  Oriented out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  const int quat_f = c.quat_w - 1, f = c.rotation_w() - 2;  // fractions of q and of q', R'
  const int64_t cw = frame.camera.quaternion.w, cx = frame.camera.quaternion.x, cy = frame.camera.quaternion.y,
                cz = frame.camera.quaternion.z;
  const auto narrow = [&](int64_t sum) { return saturate(shift_round(sum, quat_f), c.rotation_w()); };
  const int64_t w = narrow(cw * in.qw - cx * in.qx - cy * in.qy - cz * in.qz);
  const int64_t x = narrow(cw * in.qx + cx * in.qw + cy * in.qz - cz * in.qy);
  const int64_t y = narrow(cw * in.qy - cx * in.qz + cy * in.qw + cz * in.qx);
  const int64_t z = narrow(cw * in.qz + cx * in.qy - cy * in.qx + cz * in.qw);

  const int64_t one = int64_t{1} << (2 * f);
  const auto entry = [&](int64_t sum) { return saturate(shift_round(sum, f), c.rotation_w()); };
  out.r00 = entry(one - 2 * (y * y + z * z));
  out.r11 = entry(one - 2 * (x * x + z * z));
  out.r22 = entry(one - 2 * (x * x + y * y));
  out.r01 = entry(2 * (x * y - w * z));
  out.r10 = entry(2 * (x * y + w * z));
  out.r02 = entry(2 * (x * z + w * y));
  out.r20 = entry(2 * (x * z - w * y));
  out.r12 = entry(2 * (y * z - w * x));
  out.r21 = entry(2 * (y * z + w * x));

  out.tan_x = in.tan_x;
  out.tan_y = in.tan_y;
  out.inv_z_m = in.inv_z_m;
  out.inv_z_e = in.inv_z_e;
  pass_scales(in, out);
  return out;
}

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

Covariance pu_compensate(const Config& config, const Frame& frame, const Covariance& in) {
  if (in.kind != kData || frame.tables.antialias == 0) return in;
  int64_t fall = kMostCompensated;
  if (in.sharp_m != 0) {
    const uint64_t det = in.det_m >> (config.mantissa_w - config.sharp_w());
    const int64_t apart =
        (in.det_e - in.sharp_e) * (int64_t{1} << kCompensateF) + log2_mantissa(det) - log2_mantissa(in.sharp_m);
    fall = std::clamp<int64_t>(apart, 0, kMostCompensated);
  }
  Covariance out = in;
  out.opacity = saturate_unsigned(
      in.opacity + static_cast<uint64_t>(shift_round(fall, kCompensateF + 1 - config.opacity_f)), config.opacity_w());
  return out;
}

}  // namespace pipegs
