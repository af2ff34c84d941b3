#include "cpp_model/pu/pu_intersect.hpp"

#include <algorithm>

// Why nothing is lost. Let R be the power that a Row Unit computes, P the polynomial with the coefficients A to F, Q the
// concave quadratic before its coefficients were rounded, u = 2^-CoeffF. In the window:
//   |R - P| <= (1 + 14 + 3 * 49)/2 * 2^-PowerF < 2^(7 - PowerF)           (pu_region rounds each number once)
//   |P - Q| <= (1 + 32 + 63 + 1985 + 3969 + 1985) u + 2^-15 < 2^13 u + 2^-15   (pu_coeff: roundings, and factors cut to 34 bits)
// A pixel counts: R >= cut, so Q >= cut - 2^(7 - PowerF) - 2^13 u - 2^-15 there, so the maximum of Q over the region's box is
// at least that, and it lies at the mean or on an edge that faces it (the mean differs from the vertex of Q by the rounding of w, a
// second-order loss below 2^-30). On that edge P >= cut - 2^(7 - PowerF) - 2^14 u - 2^-14, which is more than cut - slack; P's
// maximum on the edge is at a corner or between two ends with gradients of opposite sign, as tested with n rounded up and the
// deficit rounded down. At the corner where two facing edges meet at most one of them rises, by concavity; if rounding
// makes both rise, the region is kept.
namespace pipegs {
namespace {

struct Range {
  int64_t first, last;  // pixels of the window; empty if first > last
};

Range pixels(const Config& config, int64_t mean, uint64_t extent) {
  const int64_t half = static_cast<int64_t>(extent) << (config.mean_f - 4);
  const int64_t unit = int64_t{1} << config.mean_f;
  return {std::max<int64_t>((mean - half + unit - 1) >> config.mean_f, 0),
          std::min<int64_t>((mean + half) >> config.mean_f, config.window - 1)};
}

// The power along one edge of a region, of which the mean is on the other side.
struct Edge {
  int64_t power, first, last, curve;  // at the edge's first pixel; gradients at both ends; second difference / 2

  bool bends() const { return first > 0 && last < 0; }
  bool reaches(const Config& config, int64_t low) const {
    const int gradient_f = (config.coeff_f + 10) / 2, deficit_f = 2 * gradient_f + 2 - config.coeff_f;
    const int64_t deficit = (low - power) >> (config.coeff_f - deficit_f);
    const int64_t gradient = (first >> (config.coeff_f - gradient_f)) + 1;
    return (deficit >> (deficit_f + 9)) == 0 && gradient * gradient >= -curve * deficit;
  }
};

}  // namespace

Tiles pu_intersect(const Config& config, const Frame&, const Coeff& in) {
  Tiles out;
  out.kind = in.kind;
  if (in.kind != kData || in.dead) return out;
  const Range xs = pixels(config, in.mean_x, in.extent_x), ys = pixels(config, in.mean_y, in.extent_y);
  if (xs.first > xs.last || ys.first > ys.last) return out;

  const int64_t low = PuCut(config).low;
  const int64_t a = in.a, b = in.b, c = in.c, d = in.d, e = in.e, f = in.f;
  const int64_t mean_x = in.mean_x, mean_y = in.mean_y;
  const int columns = config.regions_x();
  const int64_t x_first = xs.first >> 3, x_last = xs.last >> 3, y_last = ys.last >> 3;
  for (int64_t ry = ys.first >> 3; ry <= y_last; ++ry) {
    const int64_t y0 = 8 * ry, x0 = 8 * x_first;
    const bool above = mean_y < y0 << config.mean_f, below = mean_y > (y0 + 7) << config.mean_f;  // where the mean lies
    int64_t power = a + y0 * (c + e * y0) + x0 * (b + f * y0 + d * x0);
    int64_t gx = b + f * y0 + 2 * d * x0, gy = c + f * x0 + 2 * e * y0;
    for (int64_t rx = x_first; rx <= x_last; ++rx) {
      const bool left = mean_x < 8 * rx << config.mean_f, right = mean_x > (8 * rx + 7) << config.mean_f;
      const int64_t across = 7 * gx + 49 * d, down = 7 * gy + 49 * e;
      const int64_t power_x = power + across, power_y = power + down, power_xy = power_x + down + 49 * f;
      const Edge vertical{right ? power_x : power, gy + (right ? 7 * f : 0), gy + (right ? 7 * f : 0) + 14 * e, e};
      const Edge horizontal{below ? power_y : power, gx + (below ? 7 * f : 0), gx + (below ? 7 * f : 0) + 14 * d, d};
      const bool bends_x = (above || below) && horizontal.bends(), bends_y = (left || right) && vertical.bends();
      const bool keep = (!left && !right && !above && !below) || (bends_x && bends_y) ||
                        std::max(std::max(power, power_x), std::max(power_y, power_xy)) >= low ||
                        ((bends_x || bends_y) && (bends_x ? horizontal : vertical).reaches(config, low));
      if (keep) out.mask |= uint64_t{1} << (ry * columns + rx);
      power += 8 * gx + 64 * d;
      gx += 16 * d;
      gy += 8 * f;
    }
  }
  if (out.mask == 0) return out;
  out.a = a;
  out.b = b;
  out.c = c;
  out.d = d;
  out.e = e;
  out.f = f;
  out.depth = in.depth;
  out.dir_x = in.dir_x;
  out.dir_y = in.dir_y;
  out.dir_z = in.dir_z;
  out.base_r = in.base_r;
  out.base_g = in.base_g;
  out.base_b = in.base_b;
  out.index = in.index;
  out.slot = in.slot;
  return out;
}

}  // namespace pipegs
