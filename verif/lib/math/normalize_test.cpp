// SPDX-License-Identifier: Apache-2.0
// normalize_test: rtl/lib/math/pipegs_normalize.sv against its bit-accurate model, and the model against its
// definition.
#include "cpp_model/lib/math/normalize.hpp"

#include "Vpipegs_normalize.h"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

constexpr int kWidth = 28;  // the module's default
constexpr int64_t kHigh = int64_t{1} << (kWidth - 1);

// Every bit length, both signs, and the ends of the range.
int64_t random_value(std::mt19937_64& rng) {
  const int64_t value = static_cast<int64_t>(rng() % kHigh) >> (rng() % kWidth);
  return rng() % 2 == 0 ? value : ~value;
}

TEST(Normalize, ModelShiftsUntilTheTwoTopBitsDiffer) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 100000; ++i) {
    const int64_t x = random_value(rng);
    const Normalized n = normalize(kWidth, x);
    ASSERT_EQ(n.value, x * (int64_t{1} << n.shift)) << x;
    ASSERT_GE(n.value, -kHigh);
    ASSERT_LT(n.value, kHigh);
    if (x == 0) {
      ASSERT_EQ(n.shift, kWidth - 1);
    } else {
      ASSERT_TRUE(n.value >= kHigh / 2 || n.value < -kHigh / 2) << x;
    }
  }
}

TEST(Normalize, EqualsItsModel) {
  VerilatedContext context;
  Vpipegs_normalize dut(&context);
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 100000; ++i) {
    const int64_t x = i == 0 ? 0 : i == 1 ? -1 : i == 2 ? -kHigh : i == 3 ? kHigh - 1 : random_value(rng);
    dut.in_i = static_cast<IData>(x & (2 * kHigh - 1));
    dut.eval();
    const Normalized n = normalize(kWidth, x);
    ASSERT_EQ(dut.out_o, static_cast<IData>(n.value & (2 * kHigh - 1))) << x;
    ASSERT_EQ(dut.shift_o, n.shift) << x;
  }
}

}  // namespace
}  // namespace pipegs
