// SPDX-License-Identifier: Apache-2.0
// The bounds of sim/bounds/budget.hpp: measured errors lie below them, a changed width moves them, and FP16 is
// what it is (T9).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/bounds/budget.hpp"
#include "sim/studies/budget/sample.hpp"

namespace pipegs {
namespace {

Config with(const std::vector<std::string>& settings) {
  Config config;
  for (const std::string& setting : settings) config_set(config, setting);
  return config;
}

double worst(const std::vector<BudgetSample>& samples, double BudgetSample::*field) {
  double most = 0;
  for (const BudgetSample& sample : samples) most = std::max(most, sample.*field);
  return most;
}

TEST(StabilityBudget, ErrorsLieBelowTheirBoundsInEveryFormat) {
  for (const auto& settings : {std::vector<std::string>{},
                               {"alpha_w=6"},
                               {"alpha_w=12"},
                               {"mantissa_w=18"},
                               {"mantissa_w=28"},
                               {"coeff_f=22"},
                               {"power_f=14"},
                               {"quat_w=10", "scale_m_w=6"},
                               {"pos_w=12"},
                               {"mean_f=6"},
                               {"tan_f=16"},
                               {"window=16"},
                               {"exp_index_w=3"}}) {
    const Config config = with(settings);
    const std::vector<BudgetSample> samples = budget_samples(config, 3, settings.empty() ? 20000 : 5000);
    for (const BudgetSample& s : samples) {
      ASSERT_LE(s.power_excess, 0) << config_difference(config) << ", ratio " << s.ratio << ", sigma " << s.sigma
                                   << ": " << s.power << " of " << s.bound;
      ASSERT_LE(s.alpha_excess, 1e-9) << config_difference(config) << ", ratio " << s.ratio << ", sigma " << s.sigma;
      ASSERT_LE(s.record, s.record_bound + 1e-9)
          << config_difference(config) << ", ratio " << s.ratio << ", sigma " << s.sigma;
    }
    std::printf("%-24s power %.3g of %.3g, alpha %.4f of %.4f, record %.3g of %.3g\n",
                config_difference(config).c_str(), worst(samples, &BudgetSample::power),
                worst(samples, &BudgetSample::bound), worst(samples, &BudgetSample::alpha),
                worst(samples, &BudgetSample::alpha_bound), worst(samples, &BudgetSample::record),
                worst(samples, &BudgetSample::record_bound));
  }
}

TEST(StabilityBudget, AWidthMovesItsBound) {
  EXPECT_LT(alpha_rounding(with({"alpha_w=10"})), alpha_rounding(Config{}) / 3);
  EXPECT_LT(weight_rounding(with({"t_w=24"})), weight_rounding(Config{}) / 30);
  EXPECT_LT(blend_rounding(Config{}), blend_rounding(with({"rgb_w=12"})) / 15);
  EXPECT_GT(alpha_interval(with({"alpha_w=6"}), -3, 0).high, alpha_interval(Config{}, -3, 0).high);
  EXPECT_EQ(alpha_interval(Config{}, -8.5, 0.4).high, 0);
  EXPECT_EQ(alpha_interval(Config{}, -8, 0.1).low, 0);
  EXPECT_LE(alpha_interval(Config{}, 0, 1).high, 0.99);
}

// Mixed precision: the usual formulas in half lose the picture where ours and float do not.
TEST(Stability, T09_HalfPrecisionConics) {
  const std::vector<BudgetSample> samples = budget_samples(Config{}, 9, 20000);
  size_t flipped16 = 0, flipped = 0;
  for (const BudgetSample& s : samples) flipped16 += s.alpha16 > 0.05, flipped += s.alpha > 0.05;
  std::printf("T09: alpha off by more than 0.05: FP16 %.1f %%, ours %.2f %%; worst FP32 %.3f, ours %.4f\n",
              100.0 * static_cast<double>(flipped16) / static_cast<double>(samples.size()),
              100.0 * static_cast<double>(flipped) / static_cast<double>(samples.size()),
              worst(samples, &BudgetSample::alpha32), worst(samples, &BudgetSample::alpha));
  EXPECT_EQ(flipped, 0u);
  EXPECT_GT(flipped16, samples.size() / 20);
}

}  // namespace
}  // namespace pipegs
