// SPDX-License-Identifier: Apache-2.0
// random_splat.hpp: coefficients of splats for the tests of RUs that compute alphas themselves (late = 1).
#pragma once

#include "verif/pu/rows/random_row_job.hpp"

namespace pipegs {

// What the alphas of a splat are computed from.
inline RowJob job_of(const Sorted& splat) {
  RowJob job;
  job.a = splat.a, job.b = splat.b, job.c = splat.c, job.d = splat.d, job.e = splat.e, job.f = splat.f;
  job.mask = splat.mask;
  job.index = splat.index;
  return job;
}

// Gaussians from faint (strength 0) to those that close pixels quickly (2); below 0 every pixel is visible, barely.
template <class Rng>
void give_coefficients(const Config& config, Rng& rng, int strength, Sorted& splat) {
  const bool flat = strength < 0 || (strength >= 2 && rng() % 2 == 0);
  const RowJob job = flat ? RowJob{} : gaussian_row_job(config, rng);
  const double exponent = strength < 0 ? -7 : strength == 0 ? -4 : flat ? -0.5 : 0;
  splat.a = job.a + std::llround(std::ldexp(exponent, config.coeff_f));
  splat.b = job.b, splat.c = job.c, splat.d = job.d, splat.e = job.e, splat.f = job.f;
}

}  // namespace pipegs
