// SPDX-License-Identifier: Apache-2.0
// budget_float: projection, covariance, conic and power as the usual renderers compute them, in the number type T.
//
// Idea    Every operation is rounded to T; the conic is the inverse by a c - b b, the power is Eq. 1. T is float or
//         half, whose range counts too: a variance above 65504 is infinite there. Sums and products of halves
//         are exact enough in float that rounding them once more is correct.
#pragma once

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

template <class T>
struct FloatSplat {
  T mean_x, mean_y, a, b, c;  // conic
  T opacity;

  // Natural logarithm, without the opacity; NaN where T gave no number.
  double power(int x, int y) const {
    const T dx = T(mean_x - T(x)), dy = T(mean_y - T(y));
    const T square = T(T(T(a * dx) * dx) + T(T(c * dy) * dy));
    return static_cast<double>(T(T(T(-0.5) * square) - T(T(b * dx) * dy)));
  }
  // What a renderer takes: cut, cap, and nothing where the power is above 0 or no number.
  double alpha(double power) const {
    if (!(power <= 0)) return 0;
    const T value = std::min(T(0.99), T(opacity * T(std::exp(power))));
    return static_cast<double>(value) >= 1.0 / 255 ? static_cast<double>(value) : 0;
  }
};

// The camera looks along +z from the origin; the quaternion is taken as it is.
template <class T>
FloatSplat<T> float_splat(const Camera& camera, const ActivatedGaussian& g) {
  const auto t = [](double v) { return static_cast<T>(v); };
  const T x = t(g.mean.x), y = t(g.mean.y), z = t(g.mean.z), fx = t(camera.fx), fy = t(camera.fy), one = T(1),
          two = T(2);
  const T qw = t(g.rotation[0]), qx = t(g.rotation[1]), qy = t(g.rotation[2]), qz = t(g.rotation[3]);
  const T r[3][3] = {{T(one - T(two * T(T(qy * qy) + T(qz * qz)))), T(two * T(T(qx * qy) - T(qw * qz))),
                      T(two * T(T(qx * qz) + T(qw * qy)))},
                     {T(two * T(T(qx * qy) + T(qw * qz))), T(one - T(two * T(T(qx * qx) + T(qz * qz)))),
                      T(two * T(T(qy * qz) - T(qw * qx)))},
                     {T(two * T(T(qx * qz) - T(qw * qy))), T(two * T(T(qy * qz) + T(qw * qx))),
                      T(one - T(two * T(T(qx * qx) + T(qy * qy))))}};
  const T lx = t(1.3 * camera.width / (2 * camera.fx)), ly = t(1.3 * camera.height / (2 * camera.fy));
  const T tx = std::clamp(T(x / z), T(-lx), lx), ty = std::clamp(T(y / z), T(-ly), ly);
  T a = T(0.3), b = T(0), c = T(0.3);
  for (int j = 0; j < 3; ++j) {
    const T s = t(g.scale[j]);
    const T u0 = T(T(fx / z) * T(T(r[0][j] - T(tx * r[2][j])) * s)),
            u1 = T(T(fy / z) * T(T(r[1][j] - T(ty * r[2][j])) * s));
    a = T(a + T(u0 * u0)), b = T(b + T(u0 * u1)), c = T(c + T(u1 * u1));
  }
  const T det = T(T(a * c) - T(b * b)), inverse = T(one / det);
  return {T(T(T(fx * x) / z) + t(camera.cx)),
          T(T(T(fy * y) / z) + t(camera.cy)),
          T(c * inverse),
          T(-b * inverse),
          T(a * inverse),
          t(g.opacity)};
}

}  // namespace pipegs
