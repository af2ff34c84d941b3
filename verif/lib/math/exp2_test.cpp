// SPDX-License-Identifier: Apache-2.0
// exp2_test: rtl/lib/math/pipegs_exp2.sv against its bit-accurate model for every fraction, and the model against
// double.
#include "cpp_model/lib/math/exp2.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_exp2.h"

namespace pipegs {
namespace {

TEST(Exp2, EqualsItsModelForEveryFraction) {
  const Config config = test_config();
  const Exp2 model(config);
  Vpipegs_exp2 dut;
  for (uint32_t fraction = 0; fraction < (uint32_t{1} << config.exp_f()); ++fraction) {
    dut.fraction_i = fraction;
    dut.eval();
    ASSERT_EQ(dut.exponential_o, model(fraction)) << "fraction " << fraction;
  }
}

TEST(Exp2, StaysWithinItsErrorBound) {
  const Config config = test_config();
  const Exp2 model(config);
  const double entries = std::ldexp(1.0, config.exp_index_w),
               ulp = 256;  // results per last place of an alpha in [1/2, 1)
  const double chord =
      config.exp_linear ? std::ldexp(2 * std::pow(std::log(2.0) / entries, 2) / 8, config.alpha_w - 1) : 0;
  const double step =
      config.exp_linear ? 0 : std::ldexp(std::log(2.0) / 2 / entries, config.alpha_w);  // half an interval at the top
  double low = 0, high = 0;
  for (uint32_t fraction = 0; fraction < (uint32_t{1} << config.exp_f()); ++fraction) {
    const double exact = std::ldexp(std::exp2(std::ldexp(fraction, -config.exp_f())), config.alpha_w + 7);
    const double error = (model(fraction) - exact) / ulp;
    low = std::min(low, error), high = std::max(high, error);
  }
  std::printf("exp2: error %.4f .. %.4f of an alpha's last place (chord %.4f, step %.4f)\n", low, high, chord, step);
  EXPECT_GT(low, -step - 2 / ulp);          // table and truncation
  EXPECT_LT(high, chord + step + 1 / ulp);  // chord and table
}

}  // namespace
}  // namespace pipegs
