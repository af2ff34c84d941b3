// SPDX-License-Identifier: Apache-2.0
// sqrt_test: rtl/lib/math/pipegs_sqrt.sv against its bit-accurate model for every input, and the model against double
// precision.
#include "cpp_model/lib/math/sqrt.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "Vpipegs_sqrt.h"

namespace pipegs {
namespace {

constexpr int64_t kOne = int64_t{1} << kSqrtF;

TEST(Sqrt, ModelIsWithinItsStatedErrorFrom15Of64ToOne) {
  double worst = 0;
  for (int64_t v = kSqrtLeast * (kOne / 64); v <= kOne; ++v) {
    const double exact = std::sqrt(std::ldexp(v, -kSqrtF));
    worst = std::max(worst, std::abs(std::ldexp(sqrt_fraction(v), -kSqrtF) - exact));
  }
  std::printf("sqrt: worst error %.3g\n", worst);
  EXPECT_LT(worst, kSqrtError);
}

TEST(Sqrt, EqualsItsModelForEveryInputTwoCyclesLaterAndStandsStillWhenItIsNotEnabled) {
  VerilatedContext context;
  context.randReset(2);
  Vpipegs_sqrt dut(&context);
  const auto step = [&](int64_t v, bool enable) {
    dut.clk_i = 0;
    dut.v_i = static_cast<uint32_t>(v);
    dut.enable_i = enable;
    dut.eval();
    dut.clk_i = 1;
    dut.eval();
  };
  for (int64_t v = 0; v <= kOne + 1; ++v) {
    step(std::min(v, kOne), true);  // the edge at which the result of the v before enters the output register
    if (v > 0) { ASSERT_EQ(dut.root_o, sqrt_fraction(v - 1)) << "v " << v - 1; }
    if (v % 97 != 0) continue;
    step(kOne / 2, false);
    if (v > 0) { ASSERT_EQ(dut.root_o, sqrt_fraction(v - 1)) << "v " << v - 1 << " held"; }
  }
}

}  // namespace
}  // namespace pipegs
