// SPDX-License-Identifier: Apache-2.0
// first_set_test: rtl/lib/math/pipegs_first_set.sv against std::countr_zero.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "Vpipegs_first_set.h"

namespace pipegs {
namespace {

TEST(FirstSet, FindsTheLowestBit) {
  std::mt19937_64 rng(1);
  Vpipegs_first_set dut;
  for (int i = 0; i < 20000; ++i) {
    const uint64_t mask = i == 0 ? 0 : rng() & (i % 2 ? rng() << rng() % 64 : ~uint64_t{0});
    dut.mask_i = mask;
    dut.eval();
    ASSERT_EQ(dut.one_hot_o, mask & (~mask + 1)) << "mask " << mask;
    ASSERT_EQ(dut.number_o, mask == 0 ? 0 : std::countr_zero(mask)) << "mask " << mask;
  }
}

}  // namespace
}  // namespace pipegs
