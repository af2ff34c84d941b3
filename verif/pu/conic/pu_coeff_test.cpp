// SPDX-License-Identifier: Apache-2.0
// pu_coeff_test: rtl/pu/conic/pu_coeff.sv against its bit-accurate model, and the model against double, pixel by
// pixel.
#include "cpp_model/pu/conic/pu_coeff.hpp"

#include "verif/pu/pu_stage.hpp"
#include "verif/pu/random_splat.hpp"
#include "Vpu_coeff.h"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_coeff, Conic, conic, Coeff, coeff);

TEST(PuCoeff, EqualsItsModelAtEveryPace) {
  check_every_pace<Stage>(stage_run<Stage>(
      [](PuRandom& random, const Frame& frame) {
        return pu_conic(random.config, frame, random_covariance(random.config, random.rng));
      },
      pu_coeff));
}

// Exponents and slopes around the edge of the range, where each coefficient in turn makes the record dead.
TEST(PuCoeff, EqualsItsModelAroundTheRange) {
  int all = 0, dead = 0;
  check_every_pace<Stage>(stage_run<Stage>(
      [](PuRandom& random, const Frame&) {
        const Config& config = random.config;
        Conic k = random_record<Conic>(config, random.rng);
        k.kind = kData;
        k.narrow_m |= uint64_t{1} << (config.mantissa_w - 1);
        k.wide_m |= uint64_t{1} << (config.mantissa_w - 1);
        const int range = random.chance(2) ? 5 : 39;
        k.narrow_e = -config.mantissa_w + 4 - random.integer(0, range);
        k.wide_e = -config.mantissa_w + 4 - random.integer(0, range);
        k.slope_m = random.chance(16) ? (int64_t{1} << (config.slope_w() - 2)) * (random.chance(2) ? 1 : -1)
                                      : (k.slope_m >> 1) >> random.integer(0, 29);
        k.mean_x >>= random.integer(0, config.mean_w() - 1);
        k.mean_y >>= random.integer(0, config.mean_w() - 1);
        return k;
      },
      [&](const Config& config, const Frame& frame, const Conic& conic) {
        const Coeff coeff = pu_coeff(config, frame, conic);
        ++all, dead += coeff.dead != 0;
        return coeff;
      }));
  EXPECT_GT(dead, all / 4);
  EXPECT_LT(dead, all * 9 / 10);
}

TEST(PuCoeff, TakesARecordInEightCyclesAndAnEndInFour) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  StageRun<Stage> run;
  for (int i = 0; i < 100; ++i) run.inputs.push_back(pu_conic(config, run.frame, random_splat(config, rng, 30).record));
  for (int i = 0; i < 100; ++i) run.inputs.push_back({.kind = kLayerEnd});
  for (const Conic& in : run.inputs) run.expected.push_back(pu_coeff(config, run.frame, in));
  const std::vector<uint64_t> cycles = check_run(config, run, Pace::kAlways, Pace::kAlways);
  EXPECT_EQ(cycles.at(90) - cycles.at(10), 80u * 8);
  EXPECT_EQ(cycles.at(190) - cycles.at(110), 80u * 4);
}

// Every pixel of the window that counts, from the exact covariance (and from the quantised one). The error has a long
// tail, so its limit holds for these draws only: no seed but this one.
TEST(PuCoeff, PowerAgreesWithDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(1);
  for (double longest : {1.0, 10.0, 100.0, 1000.0, 5000.0}) {
    double worst = 0, worst_quantised = 0, squares = 0, pixels = 0;
    for (int i = 0; i < 6000; ++i) {
      const RandomSplat s = random_splat(config, rng, longest);
      const Covariance& r = s.record;
      const Coeff q = pu_coeff(config, Frame{}, pu_conic(config, Frame{}, r));
      auto value = [](auto m, int64_t e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
      const double a = value(r.a_m, r.a_e), b = value(r.b_m, r.b_e), c = value(r.c_m, r.c_e),
                   det = value(r.det_m, r.det_e);
      for (int y = 0; y < config.window; ++y) {
        for (int x = 0; x < config.window; ++x) {
          const double exact = s.power(x, y), dx = x - s.mean_x, dy = y - s.mean_y;
          if (exact < -std::log2(config.alpha_cut)) continue;
          ASSERT_EQ(q.dead, 0u);
          const double found = std::ldexp(
              static_cast<double>(q.a + q.b * x + q.c * y + q.d * x * x + q.e * y * y + q.f * x * y), -config.coeff_f);
          const double quantised =
              -s.opacity - kHalfLog2E * (c >= a ? c / det * std::pow(dx - b / c * dy, 2) + dy * dy / c
                                                : a / det * std::pow(dy - b / a * dx, 2) + dx * dx / a);
          worst = std::max(worst, std::abs(found - exact));
          worst_quantised = std::max(worst_quantised, std::abs(found - quantised));
          squares += (found - exact) * (found - exact);
          ++pixels;
        }
      }
    }
    std::printf(
        "pu_coeff: sigma up to %4.0f px: error of the power %.3g (2^%.1f), rms %.3g; from the quantised covariance "
        "%.3g\n",
        longest, worst, std::log2(worst), std::sqrt(squares / pixels), worst_quantised);
    if (config == Config{}) { EXPECT_LE(worst, std::exp2(-9.5)); }
  }
}

}  // namespace
}  // namespace pipegs
