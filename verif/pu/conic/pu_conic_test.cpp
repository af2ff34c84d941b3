// SPDX-License-Identifier: Apache-2.0
// pu_conic_test: rtl/pu/conic/pu_conic.sv, with pu_extent and pu_root in it, against its bit-accurate model, and the
// model against double.
#include "cpp_model/pu/conic/pu_conic.hpp"

#include "cpp_model/pu/conic/pu_root.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/random_splat.hpp"
#include "Vpu_conic.h"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_conic, Covariance, covariance, Conic, conic);

TEST(PuConic, EqualsItsModelAtEveryPace) {
  check_every_pace<Stage>(stage_run<Stage>(
      [](PuRandom& random, const Frame&) { return random_covariance(random.config, random.rng); }, pu_conic));
}

// Slopes beyond one, variances from far below a pixel to far beyond the largest box, opacities near the cut.
TEST(PuConic, EqualsItsModelForAnyExponents) {
  check_every_pace<Stage>(stage_run<Stage>(
      [](PuRandom& random, const Frame&) {
        Covariance r = random_splat(random.config, random.rng, 30).record;
        r.b_e += random.integer(-20, 20);
        if (random.chance(7)) r.b_m = -random.integer(0, 1);
        if (!random.chance(3)) r.a_e += random.integer(-10, 40);
        if (random.chance(3)) r.c_e += random.integer(-10, 40);
        if (random.chance(2)) r.opacity >>= random.integer(0, random.config.opacity_w());
        return r;
      },
      pu_conic));
}

TEST(PuConic, TakesARecordInEightCyclesAndAnEndInSix) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  StageRun<Stage> run;
  for (int i = 0; i < 100; ++i) run.inputs.push_back(random_splat(config, rng, 30).record);
  for (int i = 0; i < 100; ++i) run.inputs.push_back({.kind = kLayerEnd});
  for (const Covariance& in : run.inputs) run.expected.push_back(pu_conic(config, run.frame, in));
  const std::vector<uint64_t> cycles = check_run(config, run, Pace::kAlways, Pace::kAlways);
  EXPECT_EQ(cycles.at(90) - cycles.at(10), 80u * 8);
  EXPECT_EQ(cycles.at(190) - cycles.at(110), 80u * 6);
}

TEST(PuConicModel, RootsAreFloors) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 100000; ++i) {
    const uint64_t x = i < 1000 ? i : (rng() & ((uint64_t{1} << kRadicandW) - 1)) >> (rng() % kRadicandW),
                   root = pu_root(x);
    ASSERT_TRUE(root * root <= x && (root + 1) * (root + 1) > x) << x;
  }
}

TEST(PuConicModel, AgreesWithDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  const double unit = std::ldexp(1, -config.mantissa_w);
  double narrow_worst = 0, wide_worst = 0, slope_worst = 0, box_worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const RandomSplat s = random_splat(config, rng, i % 2 == 0 ? 10 : 5000);
    const Conic k = pu_conic(config, Frame{}, s.record);
    const double larger = k.swap ? s.a : s.c;
    const double narrow = kHalfLog2E * larger / s.det, wide = kHalfLog2E / larger;
    if (std::abs(s.a - s.c) > 8 * unit * larger) { ASSERT_EQ(k.swap != 0, s.a > s.c); }
    narrow_worst = std::max(
        narrow_worst, std::abs(std::ldexp(static_cast<double>(k.narrow_m), static_cast<int>(k.narrow_e)) / narrow - 1));
    wide_worst = std::max(wide_worst,
                          std::abs(std::ldexp(static_cast<double>(k.wide_m), static_cast<int>(k.wide_e)) / wide - 1));
    slope_worst = std::max(slope_worst,
                           std::abs(std::ldexp(static_cast<double>(k.slope_m), 2 - config.slope_w()) - s.b / larger));
    const double reach = std::log2(config.alpha_cut) - s.opacity;
    if (config.oriented()) continue;  // its extents come with the covariance
    for (const auto& [extent, variance] : {std::pair{k.extent_x, s.a}, std::pair{k.extent_y, s.c}}) {
      const double exact = std::sqrt(variance * std::max(reach, 0.0) / kHalfLog2E),
                   found = std::ldexp(static_cast<double>(extent), -4);
      ASSERT_GE(found, exact);
      if (reach > 0.5) box_worst = std::max(box_worst, (found - 0.25) / exact - 1);
    }
  }
  std::printf(
      "pu_conic: relative error of narrow %.3g, of wide %.3g, error of slope %.3g; box too large by 1/4 px and %.2f "
      "%%\n",
      narrow_worst, wide_worst, slope_worst, 100 * box_worst);
  EXPECT_LE(narrow_worst, 8 * unit);
  EXPECT_LE(wide_worst, 4 * unit);
  EXPECT_LE(slope_worst, 4 * unit + std::ldexp(1, 2 - config.slope_w()));
  if (config == Config{}) { EXPECT_LE(box_worst, 0.02); }  // coarser slack and opacities widen it
}

}  // namespace
}  // namespace pipegs
