// SPDX-License-Identifier: Apache-2.0
// saturate_test: rtl/lib/math/pipegs_saturate.sv against the model's function: random numbers of every size and all
// ends.
#include "Vpipegs_saturate.h"
#include "cpp_model/fixed.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

TEST(Saturate, EqualsTheModel) {
  Bench<Vpipegs_saturate> bench;
  constexpr int kIn = 32, kOut = 16;  // the module's defaults
  int held = 0;
  const auto check = [&](int64_t value) {
    bench.dut.in_i = static_cast<uint32_t>(value);
    bench.dut.eval();
    const int64_t expected = saturate(value, kOut);
    ASSERT_EQ(static_cast<int16_t>(bench.dut.out_o), expected) << value;
    held += expected != value;
  };
  for (int i = 0; i < 100000; ++i) check(static_cast<int32_t>(bench.rng()) >> (bench.rng() % kIn));
  for (const int64_t end : {-(int64_t{1} << (kIn - 1)), -(int64_t{1} << (kOut - 1)), int64_t{0},
                            (int64_t{1} << (kOut - 1)) - 1, (int64_t{1} << (kIn - 1)) - 1}) {
    for (int64_t value = end - 3; value <= end + 3; ++value)
      if (saturate(value, kIn) == value) check(value);
  }
  EXPECT_GT(held, 10000);
}

}  // namespace
}  // namespace pipegs
