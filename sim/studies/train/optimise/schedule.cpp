// SPDX-License-Identifier: Apache-2.0
// schedule: see schedule.hpp.
#include "sim/studies/train/optimise/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace pipegs {
namespace {

constexpr double kFirstMeanRate = 1.6e-4, kLastMeanRate = 1.6e-6;  // of the extent
constexpr Rates kRates{0, 2.5e-3, 2.5e-3 / 20, 0.05, 5e-3, 1e-3};
constexpr int kGrowEvery = 100, kResetEvery = 3000;
constexpr double kFine = 0.1, kComesToRest = 0.1, kDamping = 1;

}  // namespace

Rates Schedule::rates(int step, double extent) const {
  const double share = static_cast<double>(step) / steps;
  Rates rates = kRates;
  if (!fine_tuning) {
    rates.mean = kFirstMeanRate * extent * std::pow(kLastMeanRate / kFirstMeanRate, share);
    return rates;
  }
  const double rest = std::pow(kComesToRest, share), fine = kFine * rest;
  return {kLastMeanRate * extent * rest,
          fine * rates.sh_dc,
          fine * rates.sh_rest,
          fine * rates.opacity,
          fine * rates.scale,
          fine * rates.rotation,
          kDamping};
}

int Schedule::sh_degree(int step, int highest) const {
  return fine_tuning ? highest : std::min<int>(highest, static_cast<int>(30.0 * step / steps));
}

bool Schedule::counts_gradients(int step) const { return !fine_tuning && step < steps / 2; }

bool Schedule::grows(int step) const { return counts_gradients(step) && step > steps / 60 && step % kGrowEvery == 0; }

bool Schedule::resets_opacity(int step) const { return counts_gradients(step) && step % kResetEvery == 0; }

bool Schedule::prunes_large(int step) const { return step > kResetEvery; }

}  // namespace pipegs
