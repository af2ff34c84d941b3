// SPDX-License-Identifier: Apache-2.0
// pu_box_test: rtl/pu/box/pu_box.sv against its bit-accurate model, and pu_axes with it against double precision.
#include "cpp_model/pu/box/pu_box.hpp"

#include "Vpu_box.h"
#include "cpp_model/pu/box/pu_axes.hpp"
#include "verif/pu/box/float_box.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/random_splat.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_box, Axes, axes, Covariance, covariance);

Axes any_axes(const Config& config, std::mt19937_64& rng) {
  return pu_axes(config, Frame{}, random_covariance(config, rng));
}

TEST(PuBox, EqualsItsModelAtEveryPace) {
  check_every_pace<Stage>([](PuRandom& random, int count) {
    StageRun<Stage> run;
    run.frame = random.frame();
    for (int i = 0; i < count; ++i) {
      run.inputs.push_back(any_axes(random.config, random.rng));
      run.expected.push_back(pu_box(random.config, run.frame, run.inputs.back()));
    }
    return run;
  });
}

// Eigenvalues from far below a pixel to far beyond the end of what fits, in any proportion.
TEST(PuBox, EqualsItsModelForAnyExponents) {
  int endless = 0;
  check_every_pace<Stage>([&](PuRandom& random, int count) {
    StageRun<Stage> run;
    run.frame = random.frame();
    for (int i = 0; i < count; ++i) {
      Axes x = any_axes(random.config, random.rng);
      x.long_e += random.integer(-60, 60);
      x.det_e += random.integer(-90, 90);
      run.inputs.push_back(x);
      run.expected.push_back(pu_box(random.config, run.frame, x));
      endless += run.expected.back().side_u == (uint64_t{1} << random.config.side_w()) - 1;
    }
    return run;
  });
  EXPECT_GT(endless, 1000);
}

TEST(PuBox, TakesARecordInEightCycles) {
  check_pace<Stage>(
      [](PuRandom& random, int count) {
        StageRun<Stage> run;
        run.frame = random.frame();
        for (int i = 0; i < count; ++i) {
          run.inputs.push_back(pu_axes(random.config, run.frame, random_splat(random.config, random.rng, 30).record));
          run.expected.push_back(pu_box(random.config, run.frame, run.inputs.back()));
        }
        return run;
      },
      14);
}

// Never too small, and by how much too large: 2^-12 of the longest, and units.
TEST(PuBoxModel, HoldsTheBoxOfDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  double side = 0, extent = 0;
  for (int i = 0; i < 200000; ++i) {
    const Covariance in = random_splat(config, rng, i % 2 == 0 ? 10 : 5000).record;
    const Covariance out = pu_box(config, Frame{}, pu_axes(config, Frame{}, in));
    const FloatBox exact = float_box(in);
    if (exact.round) continue;
    const auto pixels = [](uint64_t x, int fraction) { return std::ldexp(static_cast<double>(x), -fraction); };
    const double u = exact.swap ? exact.side_long : exact.side_short,
                 v = exact.swap ? exact.side_short : exact.side_long;
    const double x = exact.swap ? exact.along : exact.across, y = exact.swap ? exact.across : exact.along;
    for (const auto& [found, wanted] : {std::pair{pixels(out.side_u, kSideF), u}, {pixels(out.side_v, kSideF), v}}) {
      ASSERT_GE(found, wanted) << to_text(config, in);
      side = std::max(side, (found - wanted - 3.0 / 256) / exact.side_long);
    }
    for (const auto& [found, wanted] : {std::pair{pixels(out.box_x, 4), x}, {pixels(out.box_y, 4), y}}) {
      ASSERT_GE(found, wanted) << to_text(config, in);
      extent = std::max(extent, (found - wanted - 1.5 / 16) / exact.side_long);
    }
  }
  std::printf("pu_box: sides too large by 3/256 px and %.3g, extents by 3/32 px and %.3g of the longest side\n", side,
              extent);
  EXPECT_LE(side, std::exp2(-12));
  EXPECT_LE(extent, std::exp2(-11.5));
}

}  // namespace
}  // namespace pipegs
