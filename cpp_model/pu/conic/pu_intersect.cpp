// SPDX-License-Identifier: Apache-2.0
#include "cpp_model/pu/conic/pu_intersect.hpp"

#include <algorithm>

#include "cpp_model/pu/box/pu_touch.hpp"
#include "cpp_model/pu/conic/pu_edge.hpp"

// Why nothing is lost. Let R be the power that a Row Unit computes, P the polynomial with the coefficients A to F, Q
// the concave quadratic before its coefficients were rounded, u = 2^-CoeffF. In the part:
//   |R - P| <= (1 + 14 + 3 * 49)/2 * 2^-PowerF < 2^(7 - PowerF)           (pu_region rounds each number once)
//   |P - Q| <= (1 + 32 + 63 + 1985 + 3969 + 1985) u + 2^-15 < 2^13 u + 2^-15   (pu_coeff: roundings, 34-bit factors)
// A pixel counts: R >= cut, so Q >= cut - 2^(7 - PowerF) - 2^13 u - 2^-15 there, so the maximum of Q over the region's
// box is at least that, and it lies at the mean or on an edge that faces it (the mean differs from the vertex of Q by
// the rounding of w, a second-order loss below 2^-30). On that edge P >= cut - 2^(7 - PowerF) - 2^14 u - 2^-14, which
// is more than cut - slack; P's maximum on the edge is at a corner or between two ends with gradients of opposite sign,
// as tested with n rounded up and the deficit rounded down. At the corner where two facing edges meet at most one of
// them rises, by concavity; if rounding makes both rise, the region is kept.
namespace pipegs {
namespace {

struct Range {
  int64_t first, last;  // pixels of the part; empty if first > last
};

Range pixels(const Config& config, int64_t mean, uint64_t extent) {
  const int64_t half = static_cast<int64_t>(extent) << (config.mean_f - 4);
  const int64_t unit = int64_t{1} << config.mean_f;
  return {std::max<int64_t>((mean - half + unit - 1) >> config.mean_f, 0),
          std::min<int64_t>((mean + half) >> config.mean_f, config.part_side() - 1)};
}

}  // namespace

int pu_intersect_steps(const Config& config, const Coeff& in) {
  if (in.kind != kData || in.dead) return 0;
  const Range xs = pixels(config, in.mean_x, in.extent_x), ys = pixels(config, in.mean_y, in.extent_y);
  if (xs.first > xs.last || ys.first > ys.last) return 0;
  const auto columns = static_cast<int>((xs.last >> 3) - (xs.first >> 3) + 1),
             rows = static_cast<int>((ys.last >> 3) - (ys.first >> 3) + 1);
  return (columns + config.tests - 1) / config.tests * rows;
}

Tiles pu_intersect(const Config& config, const Frame&, const Coeff& in) {
  Tiles out;
  out.kind = in.kind;
  if (in.kind != kData || in.dead) return out;
  const Range xs = pixels(config, in.mean_x, in.extent_x), ys = pixels(config, in.mean_y, in.extent_y);
  if (xs.first > xs.last || ys.first > ys.last) return out;

  // The cut of the Row Units, lowered by the slack.
  const int64_t low = -(int64_t{config.power_cut()} << (config.coeff_f - config.power_f)) - config.cut_slack();
  const int64_t a = in.a, b = in.b, c = in.c, d = in.d, e = in.e, f = in.f;
  const int64_t x_first = xs.first >> 3, x_last = xs.last >> 3, y_last = ys.last >> 3, x0 = 8 * x_first;
  for (int64_t ry = ys.first >> 3; ry <= y_last; ++ry) {
    const int64_t y0 = 8 * ry;
    PuEdgeStart p{a - low + y0 * (c + e * y0) + x0 * (b + f * y0 + d * x0), b + f * y0 + 2 * d * x0,
                  c + f * x0 + 2 * e * y0};
    for (int64_t rx = x_first; rx <= x_last; ++rx) {
      const bool kept = config.oriented()       ? pu_touch(config, in, x0, 8 * (ys.first >> 3), 8 * rx, 8 * ry, 8)
                        : config.tile_test != 0 ? pu_edge(config, in, rx, ry, p)
                                                : true;
      if (kept) out.mask |= uint64_t{1} << (ry * config.part_regions_x() + rx);
      p.power += 8 * p.gx + 64 * d;
      p.gx += 16 * d;
      p.gy += 8 * f;
    }
  }
  if (out.mask == 0) return out;
  out.a = a;
  out.b = b;
  out.c = c;
  out.d = d;
  out.e = e;
  out.f = f;
  return out;
}

}  // namespace pipegs
