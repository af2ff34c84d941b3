// SPDX-License-Identifier: Apache-2.0
// rsqrt_test: rtl/lib/math/pipegs_rsqrt.sv against its bit-accurate model for every input, and the model against
// double precision.
#include "cpp_model/lib/math/rsqrt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "Vpipegs_rsqrt.h"

namespace pipegs {
namespace {

constexpr int64_t kLow = int64_t{1} << kRsqrtInF, kHigh = kLow * 4;

TEST(Rsqrt, ModelIsWithinItsStatedErrorForEveryInput) {
  double worst = 0;
  for (int64_t u = kLow; u < kHigh; ++u) {
    const int64_t r = rsqrt(u);
    ASSERT_GE(r, int64_t{1} << (kRsqrtOutF - 1)) << u;
    ASSERT_LT(r, int64_t{1} << kRsqrtOutF) << u;
    worst = std::max(worst, std::abs(std::ldexp(r, -kRsqrtOutF) * std::sqrt(std::ldexp(u, -kRsqrtInF)) - 1));
  }
  std::printf("rsqrt: worst relative error 2^%.2f\n", std::log2(worst));
  EXPECT_LT(worst, std::exp2(-16.1));
}

TEST(Rsqrt, EqualsItsModelForEveryInputOneResultPerCycleTwoCyclesLater) {
  VerilatedContext context;
  context.randReset(2);
  Vpipegs_rsqrt dut(&context);
  for (int64_t u = kLow; u <= kHigh; ++u) {
    dut.clk_i = 0;
    dut.u_i = static_cast<uint32_t>(u & (kHigh - 1));
    dut.eval();
    dut.clk_i = 1;
    dut.eval();  // the edge at which the result of the u before enters the output register
    if (u > kLow) { ASSERT_EQ(dut.r_o, rsqrt(u - 1)) << "u " << u - 1; }
  }
}

}  // namespace
}  // namespace pipegs
