// SPDX-License-Identifier: Apache-2.0
// pu_axes_test: rtl/pu/box/pu_axes.sv against its bit-accurate model in every bit: what pu_box makes of the axes hides
// their last places. The model is held against double precision in box_models_test.
#include "cpp_model/pu/box/pu_axes.hpp"

#include "Vpu_axes.h"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/random_splat.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_axes, Covariance, covariance, Axes, axes);

TEST(PuAxes, EqualsItsModelAtEveryPace) {
  check_every_pace<Stage>(stage_run<Stage>(
      [](PuRandom& random, const Frame&) { return random_covariance(random.config, random.rng); }, pu_axes));
}

// Turned by 45 degrees: with two variances alike the slope is one, and the root's error may take it beyond.
TEST(PuAxes, EqualsItsModelWhereTheSlopeIsOne) {
  check_every_pace<Stage>(stage_run<Stage>(
      [](PuRandom& random, const Frame&) {
        const int beyond = random.config.mantissa_w - (random.config.slope_w() - 1);  // places of a variance below b's
        Covariance r = random_splat(random.config, random.rng, 30).record;
        const int64_t most = r.a_m >> beyond;
        r.c_m = r.a_m, r.c_e = r.a_e;
        r.b_m = random.integer(-most, most) >> random.integer(0, 6), r.b_e = r.a_e + beyond;
        return r;
      },
      pu_axes));
}

TEST(PuAxes, TakesARecordInEightCycles) {
  check_pace<Stage>(
      [](PuRandom& random, int count) {
        StageRun<Stage> run;
        for (int i = 0; i < count; ++i) run.inputs.push_back(random_splat(random.config, random.rng, 30).record);
        for (const Covariance& in : run.inputs) run.expected.push_back(pu_axes(random.config, run.frame, in));
        return run;
      },
      16, 8);
}

}  // namespace
}  // namespace pipegs
