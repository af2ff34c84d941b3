// SPDX-License-Identifier: Apache-2.0
// ru_count_test: rtl/ru/ru_count.sv against std::popcount.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "verif/support/config.hpp"
#include "Vru_count.h"

namespace pipegs {
namespace {

TEST(RuCount, CountsTheBits) {
  const Config config = test_config();
  const uint64_t all = config.regions() == 64 ? ~uint64_t{0} : (uint64_t{1} << config.regions()) - 1;
  std::mt19937_64 rng(1);
  Vru_count dut;
  for (int i = 0; i < 20000; ++i) {
    const uint64_t mask = i == 0   ? 0
                          : i == 1 ? all
                                   : (rng() | (i % 3 ? rng() : 0)) & (i % 2 ? rng() >> rng() % 64 : all) & all;
    dut.mask_i = mask;
    dut.eval();
    ASSERT_EQ(dut.count_o, std::popcount(mask)) << "mask " << mask;
  }
}

}  // namespace
}  // namespace pipegs
