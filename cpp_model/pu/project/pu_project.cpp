// SPDX-License-Identifier: Apache-2.0
// pu_project: see pu_project.hpp.
#include "cpp_model/pu/project/pu_project.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/normalize.hpp"
#include "cpp_model/lib/math/recip.hpp"
#include "cpp_model/pu/pass.hpp"

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
  return parts;
}

}  // namespace pipegs
