// SPDX-License-Identifier: Apache-2.0
// pu_axes_test: rtl/pu/box/pu_axes.sv against its bit-accurate model, and the model against double precision.
#include "cpp_model/pu/box/pu_axes.hpp"

#include "Vpu_axes.h"
#include "verif/pu/box/float_box.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/random_splat.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_axes, Covariance, covariance, Axes, axes);

// Also round covariances, and those that are nearly so.
Covariance any_covariance(const Config& config, std::mt19937_64& rng) {
  Covariance r = random_covariance(config, rng);
  if (rng() % 8 == 0) {
    r.c_m = r.a_m, r.c_e = r.a_e, r.b_e = r.a_e + config.mantissa_w - (config.slope_w() - 1);
    r.b_m = static_cast<int64_t>(rng() % 3) - 1;
    if (rng() % 2 == 0) r.c_m ^= rng() % 4;
    if (rng() % 2 == 0) r.b_m *= int64_t{1} << (rng() % 18);
  }
  return r;
}

StageRun<Stage> axes_run(PuRandom& random, int count) {
  StageRun<Stage> run;
  run.frame = random.frame();
  for (int i = 0; i < count; ++i) {
    run.inputs.push_back(any_covariance(random.config, random.rng));
    run.expected.push_back(pu_axes(random.config, run.frame, run.inputs.back()));
  }
  return run;
}

TEST(PuAxes, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(axes_run); }

// Fields that no projection gives, with a covariance and exponents out of proportion.
TEST(PuAxes, EqualsItsModelForAnyExponents) {
  check_every_pace<Stage>([](PuRandom& random, int count) {
    StageRun<Stage> run;
    run.frame = random.frame();
    for (int i = 0; i < count; ++i) {
      Covariance r = any_covariance(random.config, random.rng);
      r.b_e += random.integer(-45, 45);
      if (i % 3 == 0) r.a_e += random.integer(-80, 80);
      if (i % 7 == 0) r.b_m = random.chance(2) ? -(int64_t{1} << (random.config.slope_w() - 1)) : 0;
      run.inputs.push_back(r);
      run.expected.push_back(pu_axes(random.config, run.frame, r));
    }
    return run;
  });
}

TEST(PuAxes, TakesARecordInEightCycles) {
  check_pace<Stage>(
      [](PuRandom& random, int count) {
        StageRun<Stage> run;
        run.frame = random.frame();
        for (int i = 0; i < count; ++i) {
          run.inputs.push_back(random_splat(random.config, random.rng, 30).record);
          run.expected.push_back(pu_axes(random.config, run.frame, run.inputs.back()));
        }
        return run;
      },
      16);
}

TEST(PuAxesModel, AgreesWithDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  double tilt = 0, stretch = 0, shrink = 0, larger = 0, larger_round = 0, inverse = 0;
  int rounds = 0;
  for (int i = 0; i < 200000; ++i) {
    Covariance r = any_covariance(config, rng);
    r.kind = kData;
    const Axes k = pu_axes(config, Frame{}, r);
    const FloatBox exact = float_box(r);
    const double long_m = static_cast<double>(k.long_m);
    double& error = exact.round ? larger_round : larger;
    error = std::max(error, std::abs(std::ldexp(long_m, static_cast<int>(k.long_e)) / exact.larger - 1));
    inverse = std::max(inverse, std::abs(std::ldexp(static_cast<double>(k.inverse_m), -2 * kAxisM + 1) * long_m - 1));
    if (exact.round) {
      ASSERT_EQ(k.tilt, 0) << to_text(config, r);
      ASSERT_EQ(k.stretch, uint64_t{1} << (kShareF - 1));
      ASSERT_EQ(k.shrink, uint64_t{1} << kShareF);
      ++rounds;
      continue;
    }
    ASSERT_EQ(k.swap != 0, exact.swap);
    tilt = std::max(tilt, std::abs(std::ldexp(static_cast<double>(k.tilt), -kTiltF) - exact.tilt));
    stretch = std::max(stretch, std::abs(std::ldexp(static_cast<double>(k.stretch), -kShareF) / exact.stretch - 1));
    shrink = std::max(shrink, std::abs(std::ldexp(static_cast<double>(k.shrink), -kShareF) * 2 * exact.stretch - 1));
  }
  std::printf("pu_axes: error of tilt %.3g; relative, of stretch %.3g, of shrink %.3g, of the eigenvalue %.3g\n", tilt,
              stretch, shrink, larger);
  EXPECT_GT(rounds, 1000);
  EXPECT_LE(tilt, std::exp2(-15.5));
  EXPECT_LE(stretch, std::exp2(-16.4));
  EXPECT_LE(shrink, std::exp2(-14.9));
  EXPECT_LE(larger, std::exp2(-16.5));
  // d and 2b below 2^10 units of the larger variance are taken as zero: half of their hypotenuse is left out at most.
  EXPECT_LE(larger_round, std::exp2(10.5 - config.mantissa_w));
  EXPECT_LE(inverse, std::exp2(-22));
}

}  // namespace
}  // namespace pipegs
