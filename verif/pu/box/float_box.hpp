// SPDX-License-Identifier: Apache-2.0
// float_box: the oriented box of a covariance in double precision, from the same record.
#pragma once

#include <cmath>

#include "cpp_model/records.hpp"

namespace pipegs {

struct FloatBox {
  bool swap = false;                     // x is the wider coordinate
  bool round = false;                    // no axis is longer, as far as the record tells: see pu_axes.hpp
  double tilt = 0, stretch = 0;          // (1 + tilt^2) / 2
  double larger = 0, smaller = 0;        // eigenvalues
  double side_long = 0, side_short = 0;  // 3 sigma times sqrt(1 + tilt^2)
  double along = 0, across = 0;          // half extents along the wider coordinate and the other one
};

inline FloatBox float_box(const Covariance& r) {
  const auto value = [](uint64_t m, int64_t e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
  FloatBox box;
  const double a = value(r.a_m, r.a_e), c = value(r.c_m, r.c_e), det = value(r.det_m, r.det_e),
               b = std::ldexp(static_cast<double>(r.b_m), static_cast<int>(r.b_e));
  box.swap = a > c;
  const double d = std::abs(a - c), root = std::hypot(d, 2 * b);
  const double slope = root > 0 ? 2 * b / (d + root) : 0, squared = 1 + slope * slope;
  box.round = std::max(d, 2 * std::abs(b)) < std::ldexp(1024.0, static_cast<int>(std::max(r.a_e, r.c_e)));
  box.tilt = box.swap ? slope : -slope;
  box.stretch = squared / 2;
  box.larger = 0.5 * (a + c + root), box.smaller = det / box.larger;
  box.side_long = 3 * std::sqrt(box.larger * squared), box.side_short = 3 * std::sqrt(box.smaller * squared);
  box.along = (box.side_long + box.side_short * std::abs(slope)) / squared;
  box.across = (box.side_long * std::abs(slope) + box.side_short) / squared;
  return box;
}

// Whether it touches the square of pixel centres whose first pixel is (x, y), grown by `more` pixels on every side. The
// mean is relative to the same pixel as the square.
inline bool touches(const FloatBox& box, double mean_x, double mean_y, double x, double y, int side, double more) {
  const double half = 0.5 * (side - 1), dx = mean_x - x - half, dy = mean_y - y - half;
  const double box_x = box.swap ? box.along : box.across, box_y = box.swap ? box.across : box.along;
  const double u = box.swap ? box.side_long : box.side_short, v = box.swap ? box.side_short : box.side_long;
  const double tilted = half * (1 + std::abs(box.tilt)), length = std::sqrt(2 * box.stretch);
  return std::abs(dx) <= half + box_x + more && std::abs(dy) <= half + box_y + more &&
         std::abs(dx + box.tilt * dy) <= u + tilted + more * length &&
         std::abs(dy - box.tilt * dx) <= v + tilted + more * length;
}

}  // namespace pipegs
