// SPDX-License-Identifier: Apache-2.0
// log2_test: rtl/lib/math/pipegs_log2.sv against its bit-accurate model for every input, and the model against double
// precision.
#include "cpp_model/lib/math/log2.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "Vpipegs_log2.h"

namespace pipegs {
namespace {

constexpr uint64_t kLow = uint64_t{1} << kLog2InF, kHigh = 2 * kLow;

TEST(Log2, ModelIsWithinItsStatedErrorForEveryInput) {
  double worst = 0;
  for (uint64_t m = kLow; m < kHigh; ++m) {
    const int64_t found = log2_mantissa(m);
    ASSERT_GE(found, 0) << m;
    ASSERT_LT(found, int64_t{1} << kLog2OutF) << m;
    worst = std::max(worst, std::abs(std::ldexp(found, -kLog2OutF) - std::log2(std::ldexp(m, -kLog2InF))));
  }
  std::printf("log2: worst error %.3g\n", worst);
  EXPECT_LT(worst, 3.1e-5);
}

TEST(Log2, EqualsItsModelForEveryInputTwoCyclesLaterAndStandsStillWhenItIsNotEnabled) {
  VerilatedContext context;
  context.randReset(2);
  Vpipegs_log2 dut(&context);
  const auto step = [&](uint64_t m, bool enable) {
    dut.clk_i = 0;
    dut.m_i = static_cast<uint32_t>(m & (kHigh - 1));
    dut.enable_i = enable;
    dut.eval();
    dut.clk_i = 1;
    dut.eval();
  };
  for (uint64_t m = kLow; m <= kHigh; ++m) {
    step(m, true);  // the edge at which the result of the m before enters the output register
    if (m > kLow) { ASSERT_EQ(dut.log2_o, log2_mantissa(m - 1)) << "m " << m - 1; }
    if (m % 97 != 0) continue;
    step(kLow, false);
    if (m > kLow) { ASSERT_EQ(dut.log2_o, log2_mantissa(m - 1)) << "m " << m - 1 << " held"; }
  }
}

}  // namespace
}  // namespace pipegs
