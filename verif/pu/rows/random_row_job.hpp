// SPDX-License-Identifier: Apache-2.0
// random_row_job.hpp: jobs for the tests of pu_region and pu_rows: real Gaussians, and coefficients of any value.
#pragma once

#include <cmath>
#include <random>

#include "cpp_model/records.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {

// Any coefficients in range, any mask but zero.
template <class Rng>
RowJob any_row_job(const Config& config, Rng& rng) {
  RowJob job = random_record<RowJob>(config, rng);
  job.kind = kData;
  job.mask |= uint64_t{1} << (rng() % static_cast<uint64_t>(config.regions()));
  return job;
}

// A Gaussian whose mean lies in or near the part; standard deviations from 0.55 to 150 pixels.
template <class Rng>
RowJob gaussian_row_job(const Config& config, Rng& rng) {
  RowJob job = any_row_job(config, rng);
  const double x = (1.5 * draw_unit(rng) - 0.25) * config.part_side(),
               y = (1.5 * draw_unit(rng) - 0.25) * config.part_side();
  const double s0 = 0.55 * std::pow(270, draw_unit(rng)), s1 = 0.55 * std::pow(270, draw_unit(rng)),
               angle = 3.2 * draw_unit(rng);
  const double cosine = std::cos(angle), sine = std::sin(angle), log2_e = 1.4426950408889634;
  const double i0 = log2_e / (2 * s0 * s0), i1 = log2_e / (2 * s1 * s1);
  const double d = -(i0 * cosine * cosine + i1 * sine * sine), e = -(i0 * sine * sine + i1 * cosine * cosine);
  const double f = 2 * cosine * sine * (i1 - i0), opacity = -7.9 * std::pow(draw_unit(rng), 3);
  const auto fixed = [&](double value) { return std::llround(std::ldexp(value, config.coeff_f)); };
  job.a = fixed(opacity + d * x * x + e * y * y + f * x * y);
  job.b = fixed(-2 * d * x - f * y);
  job.c = fixed(-2 * e * y - f * x);
  job.d = fixed(d), job.e = fixed(e), job.f = fixed(f);
  return job;
}

// One in eight is an end beat, whose other fields are noise.
template <class Rng>
RowJob random_row_job(const Config& config, Rng& rng) {
  RowJob job = rng() % 4 == 0 ? any_row_job(config, rng) : gaussian_row_job(config, rng);
  if (rng() % 2 == 0) job.mask = uint64_t{1} << (rng() % static_cast<uint64_t>(config.regions()));
  if (rng() % 8 == 0) job.kind = rng() % 2 == 0 ? kLayerEnd : kWindowEnd;
  return job;
}

}  // namespace pipegs
