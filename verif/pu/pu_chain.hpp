// SPDX-License-Identifier: Apache-2.0
// pu_chain: a random Gaussian taken through the models up to the input of a stage.
#pragma once

#include "cpp_model/pu/project/pu_covariance.hpp"
#include "cpp_model/pu/project/pu_factors.hpp"
#include "cpp_model/pu/project/pu_jacobian.hpp"
#include "cpp_model/pu/project/pu_orient.hpp"
#include "cpp_model/pu/project/pu_project.hpp"
#include "cpp_model/pu/project/pu_squares.hpp"
#include "verif/pu/pu_random.hpp"

namespace pipegs {

inline Projected random_projected(PuRandom& random, const Frame& frame) {
  return pu_project(random.config, frame, random.visible(frame)).projected;
}
inline Oriented random_oriented(PuRandom& random, const Frame& frame) {
  Oriented o = pu_orient(random.config, frame, random_projected(random, frame));
  if (random.chance(10)) {  // exact axes: zeros, and sums that cancel to nothing
    o.r00 = o.r11 = o.r22 = int64_t{1} << (random.config.rotation_w() - 2);
    o.r01 = o.r02 = o.r10 = o.r12 = o.r20 = o.r21 = 0;
    if (random.chance(2)) o.tan_x = o.tan_y = 0;
    if (random.chance(2)) o.r02 = o.r12 = o.r22;
  }
  return o;
}
inline Jacobian random_jacobian(PuRandom& random, const Frame& frame) {
  return pu_jacobian(random.config, frame, random_oriented(random, frame));
}
inline Factors random_factors(PuRandom& random, const Frame& frame) {
  return pu_factors(random.config, frame, random_jacobian(random, frame));
}
inline Squares random_squares(PuRandom& random, const Frame& frame) {
  return pu_squares(random.config, frame, random_factors(random, frame));
}

// The projected covariance in double, from the fields that the machine works with.
struct ExactCovariance {
  double a, b, c, det;
};
inline ExactCovariance exact_covariance(const PuRandom& random, const Frame& f, const Oriented& o) {
  const Config& config = random.config;
  const auto real = [](auto m, auto e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
  const double inv_z = real(o.inv_z_m, o.inv_z_e), tx = real(o.tan_x, -config.tan_f), ty = real(o.tan_y, -config.tan_f);
  const double gx = real(f.lens.focal_x, -config.focal_f()) * inv_z,
               gy = real(f.lens.focal_y, -config.focal_f()) * inv_z;
  const int down = -(config.rotation_w() - 2);
  const double r[3][3] = {{real(o.r00, down), real(o.r01, down), real(o.r02, down)},
                          {real(o.r10, down), real(o.r11, down), real(o.r12, down)},
                          {real(o.r20, down), real(o.r21, down), real(o.r22, down)}};
  const double s[3] = {scale_value(config, o.scale_0), scale_value(config, o.scale_1), scale_value(config, o.scale_2)};
  ExactCovariance e{};
  double cross = 0;
  for (int j = 0; j < 3; ++j) {
    const double u0 = gx * (r[0][j] - tx * r[2][j]) * s[j], u1 = gy * (r[1][j] - ty * r[2][j]) * s[j];
    const double t = gx * gy * (r[0][j] * tx + r[1][j] * ty + r[2][j]) * s[(j + 1) % 3] * s[(j + 2) % 3];
    e.a += u0 * u0;
    e.b += u0 * u1;
    e.c += u1 * u1;
    cross += t * t;
  }
  e.det = cross + 0.3 * (e.a + e.c) + 0.09;
  e.a += 0.3;
  e.c += 0.3;
  return e;
}

}  // namespace pipegs
