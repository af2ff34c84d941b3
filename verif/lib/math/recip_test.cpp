// SPDX-License-Identifier: Apache-2.0
// recip_test: rtl/lib/math/pipegs_recip.sv against its bit-accurate model, and the model against double precision.
#include "cpp_model/lib/math/recip.hpp"

#include <cmath>

#include "Vpipegs_recip.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

double error_in_units(int width, uint64_t x) {
  const double exact = std::ldexp(1.0, 2 * width - 1) / static_cast<double>(x);
  return std::abs(static_cast<double>(recip(width, x)) - exact);
}

TEST(Recip, ModelIsWithinOneUnitOfDoubleAndNormalised) {
  for (const int width : {18, 22, 26, 28}) {
    const uint64_t one = uint64_t{1} << (width - 1);
    const uint64_t step = width <= 22 ? 1 : width == 26 ? 7 : 31;  // all of the narrow ones
    double worst = error_in_units(width, 2 * one - 1);
    for (uint64_t x = one; x < 2 * one; x += step) {
      const uint64_t y = recip(width, x);
      ASSERT_GE(y, one) << x;
      ASSERT_LT(y, 2 * one) << x;
      if (x != one) worst = std::max(worst, error_in_units(width, x));
    }
    EXPECT_EQ(recip(width, one), 2 * one - 1) << "1.0 saturates";
    EXPECT_LT(worst, width <= 26 ? 0.65 : 1.0) << "width " << width;
    RecordProperty("worst_error_" + std::to_string(width), std::to_string(worst));
    std::printf("recip, %d bits: worst error %.3f units in the last place\n", width, worst);
  }
}

TEST(Recip, EqualsItsModelOneResultPerCycleFourCyclesLater) {
  const int width = test_config().mantissa_w;
  Bench<Vpipegs_recip> bench;
  bench.dut.in_valid_i = 0;
  bench.reset();
  std::deque<std::pair<bool, uint64_t>> expected(4, {false, 0});
  for (int i = 0; i < 50000; ++i) {
    const bool valid = i < 1000 || bench.rng() % 2 == 0;
    const uint64_t one = uint64_t{1} << (width - 1);
    const uint64_t near = bench.rng() % 3;
    const uint64_t x = one | (near == 0   ? bench.rng() % 64
                              : near == 1 ? one - 1 - bench.rng() % 64
                                          : bench.rng() % one);
    bench.dut.in_valid_i = valid;
    bench.dut.in_i = static_cast<IData>(x);
    bench.step();  // the inputs are seen at this edge
    expected.push_back({valid, recip(width, x)});
    expected.pop_front();
    ASSERT_EQ(bench.dut.out_valid_o, expected.front().first) << "cycle " << bench.cycle;
    if (expected.front().first)
      ASSERT_EQ(bench.dut.out_o, expected.front().second) << "cycle " << bench.cycle << " seed " << bench.seed;
  }
}

}  // namespace
}  // namespace pipegs
