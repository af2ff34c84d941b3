// SPDX-License-Identifier: Apache-2.0
// random_splat: random Gaussians in the image, in double precision and as the records of the PU's back half.
#pragma once

#include <cmath>
#include <random>

#include "cpp_model/pu/box/pu_axes.hpp"
#include "cpp_model/pu/box/pu_box.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/conic/pu_conic.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {

inline constexpr double kHalfLog2E = 0.7213475204444817;

struct RandomSplat {
  double s1, s2, angle;   // standard deviations without dilation, pixels; direction of the first
  double mean_x, mean_y;  // as quantised
  double a, b, c, det;    // dilated, exact
  double opacity;         // -log2, as quantised
  Covariance record;

  double power(double x, double y) const {
    const double dx = x - mean_x, dy = y - mean_y, along = std::cos(angle) * dx + std::sin(angle) * dy;
    const double across = -std::sin(angle) * dx + std::cos(angle) * dy;
    return -kHalfLog2E * (along * along / (s1 * s1 + 0.3) + across * across / (s2 * s2 + 0.3)) - opacity;
  }
};

inline void to_float(double v, int bits, uint64_t& m, int64_t& e) {
  int exponent;
  m = static_cast<uint64_t>(std::llround(std::ldexp(std::frexp(v, &exponent), bits)));
  e = exponent - bits;
  if ((m >> bits) != 0) m >>= 1, ++e;
}

// Standard deviations up to `longest` pixels, a third of them needles of no width, somewhere near the window.
template <class Rng>
RandomSplat random_splat(const Config& config, Rng& rng, double longest) {
  auto uniform = [&](double low, double high) { return draw_uniform(rng, low, high); };
  RandomSplat s;
  s.s1 = std::exp(uniform(std::log(0.05), std::log(longest)));
  s.s2 = rng() % 3 == 0 ? 0 : std::exp(uniform(std::log(0.02), std::log(longest)));
  s.angle =
      rng() % 8 == 0 ? static_cast<double>(rng() % 5) * M_PI / 4 : uniform(0, M_PI);  // also exactly along the axes
  const double cosine = std::cos(s.angle), sine = std::sin(s.angle);
  const double v1 = s.s1 * s.s1, v2 = s.s2 * s.s2;
  s.a = v1 * cosine * cosine + v2 * sine * sine + 0.3;
  s.c = v1 * sine * sine + v2 * cosine * cosine + 0.3;
  s.b = (v1 - v2) * cosine * sine;
  s.det = (v1 + 0.3) * (v2 + 0.3);
  const double along = uniform(-3.6, 3.6) * std::sqrt(v1 + 0.3), across = uniform(-3.6, 3.6) * std::sqrt(v2 + 0.3);
  Covariance& r = s.record;
  r = random_record<Covariance>(config, rng);
  r.kind = kData;
  r.mean_x = std::llround(std::ldexp(uniform(0, config.window) + along * cosine - across * sine, config.mean_f));
  r.mean_y = std::llround(std::ldexp(uniform(0, config.window) + along * sine + across * cosine, config.mean_f));
  s.mean_x = std::ldexp(static_cast<double>(r.mean_x), -config.mean_f);
  s.mean_y = std::ldexp(static_cast<double>(r.mean_y), -config.mean_f);
  to_float(s.a, config.mantissa_w, r.a_m, r.a_e);
  to_float(s.c, config.mantissa_w, r.c_m, r.c_e);
  to_float(s.det, config.mantissa_w, r.det_m, r.det_e);
  // b in the unit of the larger of a and c, as a block exponent gives it.
  int exponent;
  std::frexp(std::max(s.a, s.c), &exponent);
  r.b_e = exponent - (config.slope_w() - 1);
  r.b_m = std::llround(std::ldexp(s.b, static_cast<int>(-r.b_e)));
  const double opacity = rng() % 2 == 0 ? uniform(0, 1) : uniform(0, 0.9999 * std::log2(config.alpha_cut));
  r.opacity = static_cast<uint64_t>(std::ldexp(opacity, config.opacity_f));
  s.opacity = std::ldexp(static_cast<double>(r.opacity), -config.opacity_f);
  return s;
}

// The coefficients of a covariance, by all stages behind it.
inline Coeff coeff_of(const Config& config, const Covariance& covariance) {
  const Frame frame;
  return pu_coeff(config, frame,
                  pu_conic(config, frame,
                           config.oriented() ? pu_box(config, frame, pu_axes(config, frame, covariance)) : covariance));
}

// One in sixteen beats is an end.
template <class Rng>
Covariance random_covariance(const Config& config, Rng& rng) {
  static constexpr double kLongest[] = {1, 5, 30, 300, 5000};
  Covariance r = random_splat(config, rng, kLongest[rng() % 5]).record;
  if (rng() % 16 == 0) r.kind = rng() % 2 == 0 ? kLayerEnd : kWindowEnd;
  if (rng() % 16 == 0) {  // far away
    r.mean_x = random_record<Covariance>(config, rng).mean_x >> (rng() % 12);
    r.mean_y = random_record<Covariance>(config, rng).mean_y >> (rng() % 12);
  }
  return r;
}

}  // namespace pipegs
