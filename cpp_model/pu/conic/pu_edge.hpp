// SPDX-License-Identifier: Apache-2.0
// pu_edge: does a region's box of pixel centres hold a point with P = power - cut >= 0 ?
//
// Paper   the test behind the 4-bit bitmap of a tile (Sec. 4.2).
// Idea    P is concave, so its maximum over the box is at the mean or on the edges that face the mean. A region
//         is kept if
//           the mean lies in its box, or P >= 0 at one of its four corners, or
//           on a facing edge the gradient g is > 0 at the first end, < 0 at the other, and  P + g^2 / (4 |curve|) >= 0
//         where the last is tested as g^2 >= 4 |curve| (-P), with g rounded up and -P rounded down.
//         By concavity at most one facing edge rises from the corner where two meet; if rounding makes both rise, the
//         region is kept.
// Numbers Exact in CoeffF fraction bits up to the last test: g u7.(CoeffF/2 + 5), -P u9 with as many bits as make the
//         units equal.
// RTL     rtl/pu/conic/pu_edge.sv
#pragma once

#include <algorithm>

#include "cpp_model/records.hpp"

namespace pipegs {

// P and its gradients at the first pixel of a region.
struct PuEdgeStart {
  int64_t power, gx, gy;
};

inline bool pu_edge(const Config& config, const Coeff& in, int64_t column, int64_t row, const PuEdgeStart& p) {
  const int64_t x0 = 8 * column << config.mean_f, y0 = 8 * row << config.mean_f, side = int64_t{7} << config.mean_f;
  const bool left = in.mean_x<x0, right = in.mean_x> x0 + side, above = in.mean_y<y0, below = in.mean_y> y0 + side;
  const bool vertical = left || right, horizontal = above || below;
  if (!vertical && !horizontal) return true;

  const int64_t across = 7 * p.gx + 49 * in.d, down = 7 * p.gy + 49 * in.e;
  const int64_t power_x = p.power + across, power_y = p.power + down, power_xy = power_x + down + 49 * in.f;
  if (std::max(std::max(p.power, power_x), std::max(power_y, power_xy)) >= 0) return true;

  const int64_t gx = p.gx + (below ? 7 * in.f : 0), gy = p.gy + (right ? 7 * in.f : 0);
  const bool bends_x = horizontal && gx > 0 && gx + 14 * in.d < 0, bends_y = vertical && gy > 0 && gy + 14 * in.e < 0;
  if (bends_x == bends_y) return bends_x;

  const int gradient_f = (config.coeff_f + 10) / 2, deficit_f = 2 * gradient_f + 2 - config.coeff_f;
  const int64_t power = bends_x ? (below ? power_y : p.power) : (right ? power_x : p.power);
  const int64_t deficit = ~power >> (config.coeff_f - deficit_f);
  const int64_t gradient = ((bends_x ? gx : gy) >> (config.coeff_f - gradient_f)) + 1;
  return (deficit >> (deficit_f + 9)) == 0 && gradient * gradient >= -(bends_x ? in.d : in.e) * deficit;
}

}  // namespace pipegs
