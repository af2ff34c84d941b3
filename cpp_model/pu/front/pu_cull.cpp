// SPDX-License-Identifier: Apache-2.0
// pu_cull: see pu_cull.hpp.
#include "cpp_model/pu/front/pu_cull.hpp"

#include <algorithm>

#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/eyes.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/pass.hpp"

namespace pipegs {
namespace {

constexpr int kEdgeF = 4;  // fraction of a window's edge in pixels

int64_t to_view(const Config& c, int64_t row_times_offset, int shift, int64_t origin) {
  return saturate(origin + shift_round(row_times_offset, shift), c.view_w);
}

// Largest scale in view units, weighted by the opacity, never too small; `huge` when it needs ViewW bits or more.
int64_t scale_in_view(const Config& c, uint64_t scale, uint64_t opacity, uint64_t view_exp, bool& huge) {
  const int e = static_cast<int>(scale >> c.scale_m_w);
  int64_t m = 0;
  if (e != 0) {
    m = (int64_t{1} << c.scale_m_w) + static_cast<int64_t>(scale & ((uint64_t{1} << c.scale_m_w) - 1));
    // The rotation of rounded quaternions stretches by up to 2^-(QuatW-4).
    m += int64_t{1} << std::max(0, c.scale_m_w + 5 - c.quat_w);
    const int64_t weight = static_cast<int64_t>(cull_weight(c, static_cast<int>(opacity >> (c.opacity_f - 2))));
    m = (m * weight + (int64_t{1} << kCullWeightF) - 1) >> kCullWeightF;
  }
  const int shift = e - 8 - c.scale_m_w - static_cast<int>(view_exp);
  const int64_t s = shift >= 0 ? m << shift : shift_floor(m, -shift);
  huge = s >= (int64_t{1} << (c.view_w - 1)) - 1;
  return huge ? (int64_t{1} << (c.view_w - 1)) - 1 : s + 1;
}

// Does [x - reach s, x + reach s] touch so many pixels from `pixel` on along one axis? All at the common exponent.
// `gap`: how far x is beyond them, times z. Of the pixels so many at either end are closed: the test leaves them out,
// the gap does not.
bool touches(const Config& c, int64_t x, int64_t z, int64_t s, uint64_t focal, uint64_t reach, int64_t center,
             int64_t pixel, int64_t pixels, int64_t low_closed, int64_t high_closed, int64_t& gap, int64_t* low_most,
             int64_t* high_most) {
  const int64_t first = (pixel - c.reach_margin()) * (1 << kEdgeF);
  const int64_t a = first - shift_ceil(center, c.center_f() - kEdgeF);       // s17.4, rounded down
  const int64_t span = ((pixels - 1 + 2 * c.reach_margin()) << kEdgeF) + 1;  // covers the rounding of a
  const int to_edge = c.focal_f() - kEdgeF;
  const int64_t f = static_cast<int64_t>(focal), r = shift_ceil(static_cast<int64_t>(reach), 8) << 8;
  const int64_t fx = f * x, az = (a * z) << to_edge, rs = r * s;
  const int64_t az2 = az + ((span * z) << to_edge), a2 = a + span;
  const int64_t low = fx + f - az + (std::max<int64_t>(-a, 0) << to_edge);
  const int64_t high = fx - az2 - (std::max<int64_t>(a2, 0) << to_edge);
  gap = (low < 0 ? -low : high) >> to_edge;
  const auto aside = [&](int64_t closed) { return ((closed << kEdgeF) * z) << to_edge; };
  if (low_most != nullptr) {
    // The most pixels that may be closed so that it still touches.
    const int64_t step = aside(1);
    *low_most = step > 0 ? (low + rs) / step : pixels;
    *high_most = step > 0 ? (rs - high) / step : pixels;
  }
  return low - aside(low_closed) + rs >= 0 && high + aside(high_closed) - rs <= 0;
}

}  // namespace

std::optional<Visible> pu_cull(const Config& c, const Frame& frame, const Fetched& in, uint64_t* behind, Gap* gap,
                               const Closed& closed, Closed* most, int eye) {
  Visible out;
  out.kind = in.kind;
  if (in.kind != kData) return out;

  const int shift = c.rot_f() + static_cast<int>(in.view_exp) - static_cast<int>(in.offset_exp);
  const int64_t x = in.offset_x, y = in.offset_y, z = in.offset_z;
  out.view_x = to_view(c, frame.camera.rotation.w00 * x + frame.camera.rotation.w01 * y + frame.camera.rotation.w02 * z,
                       shift, in.origin_x);
  out.view_y = to_view(c, frame.camera.rotation.w10 * x + frame.camera.rotation.w11 * y + frame.camera.rotation.w12 * z,
                       shift, in.origin_y);
  out.view_z = to_view(c, frame.camera.rotation.w20 * x + frame.camera.rotation.w21 * y + frame.camera.rotation.w22 * z,
                       shift, in.origin_z);
  if (c.eyes > 1) {
    out.view_x = saturate(out.view_x + eye_shift(frame.eyes.half_x, in.view_exp, eye), c.view_w);
    out.view_y = saturate(out.view_y + eye_shift(frame.eyes.half_y, in.view_exp, eye), c.view_w);
    out.eye = static_cast<uint64_t>(eye);
  }
  const int64_t near = static_cast<int64_t>(frame.lens.near_plane >> in.view_exp);
  if (behind != nullptr && out.view_z <= near) ++*behind;
  if (out.view_z <= (c.near_test ? near : 0)) return std::nullopt;

  bool huge = false;
  const int64_t s = scale_in_view(c, std::max({in.scale_0, in.scale_1, in.scale_2}), in.opacity, in.view_exp, huge);
  const auto size = [](int64_t v) { return static_cast<uint64_t>(v < 0 ? ~v : v); };
  const int magnitude_bits = c.cut_w() - 1;  // of x, y, z, s in the plane test
  const int cut =
      std::max(0, bit_length(size(out.view_x) | size(out.view_y) | size(out.view_z) | size(s)) - magnitude_bits);
  const int64_t cut_x = out.view_x >> cut, cut_y = out.view_y >> cut, cut_z = out.view_z >> cut, cut_s = (s >> cut) + 1;
  Gap found{.x = cut_x, .y = cut_y, .z = cut_z, .cut = static_cast<uint64_t>(cut), .untested = huge};
  const WalkSquare square = walk_square(c, in.walk);
  const auto first = [&](uint64_t window, int64_t beside) { return static_cast<int64_t>(window) * c.window + beside; };
  const auto pixels = [&](uint64_t window, uint64_t last) {
    return c.has_lists() ? static_cast<int64_t>(last - window + 1) * c.window : square.side;
  };
  int64_t most_left = 0, most_right = 0, most_top = 0, most_bottom = 0;
  const bool asked = most != nullptr;
  const auto regions = [](uint64_t closed) { return static_cast<int64_t>(closed) * 8; };
  const bool touches_x =
      touches(c, cut_x, cut_z, cut_s, frame.lens.focal_x, frame.lens.reach_x, frame.lens.center_x,
              first(in.window_x, square.x), pixels(in.window_x, frame.raster.windows.last_x), regions(closed.left),
              regions(closed.right), found.gap_x, asked ? &most_left : nullptr, &most_right);
  const bool touches_y =
      touches(c, cut_y, cut_z, cut_s, frame.lens.focal_y, frame.lens.reach_y, frame.lens.center_y,
              first(in.window_y, square.y), pixels(in.window_y, frame.raster.windows.last_y), regions(closed.top),
              regions(closed.bottom), found.gap_y, asked ? &most_top : nullptr, &most_bottom);
  if (!huge && !(touches_x && touches_y)) return std::nullopt;
  if (gap != nullptr) *gap = found;
  if (asked) {
    const auto most_of = [&](int64_t pixels) {
      const int64_t all = c.window / 8 - 1;
      return static_cast<uint64_t>(huge ? all : std::min(pixels / 8, all));
    };
    *most = {most_of(most_left), most_of(most_right), most_of(most_top), most_of(most_bottom)};
  }

  out.window_x = in.window_x;
  out.window_y = in.window_y;
  out.walk = in.walk;
  out.view_exp = in.view_exp;
  pass_quaternion(in, out);
  pass_scales(in, out);
  out.opacity = in.opacity;
  out.base_r = in.base_r;
  out.base_g = in.base_g;
  out.base_b = in.base_b;
  out.index = in.index;
  out.slot = in.slot;
  return out;
}

}  // namespace pipegs
