// SPDX-License-Identifier: Apache-2.0
// pu_alpha_test: rtl/pu/rows/pu_alpha.sv against its bit-accurate model, and the model against double.
#include "cpp_model/pu/rows/pu_alpha.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_alpha.h"

namespace pipegs {
namespace {

void tick(Vpu_alpha& dut) {
  dut.clk_i = 0, dut.eval();
  dut.clk_i = 1, dut.eval();
}

void expect_equal(Vpu_alpha& dut, const Config& config, const PuAlpha& model, int64_t power) {
  dut.power_i = static_cast<uint64_t>(power) & ((uint64_t{1} << config.power_w()) - 1);
  dut.enable_clamp_i = 1, dut.enable_exp_i = 0, tick(dut);
  dut.power_i = ~dut.power_i & ((uint64_t{1} << config.power_w()) - 1);
  dut.enable_clamp_i = 0, dut.enable_exp_i = 1, tick(dut);
  dut.enable_exp_i = 0, tick(dut);
  ASSERT_EQ(dut.code_o, pu_alpha(model, power)) << "power " << power;
}

TEST(PuAlpha, EqualsItsModelAtTheEdges) {
  const Config config = test_config();
  const PuAlpha model(config);
  Vpu_alpha dut;
  const int64_t high = (int64_t{1} << (config.power_w() - 1)) - 1, one = int64_t{1} << config.power_f;
  for (int64_t edge :
       {-high, high - 3, int64_t{0}, -int64_t{config.power_cut()}, -8 * one, -16 * one, 8 * one, 16 * one, -one}) {
    for (int64_t step = -3; step <= 3; ++step) {
      if (edge + step >= -high - 1 && edge + step <= high) expect_equal(dut, config, model, edge + step);
    }
  }
}

TEST(PuAlpha, EqualsItsModelForRandomPowers) {
  const Config config = test_config();
  const PuAlpha model(config);
  Vpu_alpha dut;
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 200000; ++i) {  // from one unit to the whole range
    const int bits = 1 + static_cast<int>(rng() % static_cast<uint64_t>(config.power_w() - 1));
    const int64_t size = static_cast<int64_t>(rng() & ((uint64_t{1} << bits) - 1));
    expect_equal(dut, config, model, rng() % 8 == 0 ? size : -size);
    if (HasFatalFailure()) return;
  }
}

TEST(PuAlpha, IsTheRoundedExponentialAndNothingBelowTheCut) {
  const Config config = test_config();
  const PuAlpha model(config);
  const double chord = std::pow(std::log(2.0) / (1 << config.exp_index_w), 2) / 8;
  const double input = std::log(2.0) * std::ldexp(1, -config.exp_f());  // bits of the power that exp2 does not read
  const double bound = 0.5 + std::ldexp(chord + input, config.alpha_w) + 0.0079;
  double worst = 0;
  for (int64_t power = -config.power_cut() - 5000; power <= 5000; power += config.power_f > 16 ? 37 : 1) {
    const double value = std::ldexp(static_cast<double>(std::min<int64_t>(power, 0)), -config.power_f);
    const double exact = std::clamp(std::ldexp(std::exp2(value), config.alpha_w), 1.0, 1.0 * config.alpha_max());
    if (power < -config.power_cut()) {
      ASSERT_LT(std::exp2(value), 1.0 / config.alpha_cut) << "power " << power;
      ASSERT_EQ(model(power), 0u) << "power " << power;
    } else {
      worst = std::max(worst, std::abs(model(power) - exact));
    }
  }
  EXPECT_GE(std::exp2(std::ldexp(-config.power_cut(), -config.power_f)), 1.0 / config.alpha_cut);
  std::printf("pu_alpha: error at most %.4f codes, bound %.4f\n", worst, bound);
  EXPECT_LE(worst, bound);
}

}  // namespace
}  // namespace pipegs
