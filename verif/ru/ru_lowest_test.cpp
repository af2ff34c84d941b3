// ru_lowest_test: rtl/ru/ru_lowest.sv against std::countr_zero.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "verif/support/config.hpp"
#include "Vru_lowest.h"

namespace pipegs {
namespace {

TEST(RuLowest, FindsTheLowestBit) {
  const Config config = test_config();
  const uint64_t all = config.regions() == 64 ? ~uint64_t{0} : (uint64_t{1} << config.regions()) - 1;
  std::mt19937_64 rng(1);
  Vru_lowest dut;
  for (int i = 0; i < 20000; ++i) {
    const uint64_t mask = (rng() & (i % 2 ? rng() << rng() % 64 : ~uint64_t{0})) & all;
    dut.mask_i = mask;
    dut.eval();
    ASSERT_EQ(dut.one_hot_o, mask & (~mask + 1)) << "mask " << mask;
    ASSERT_EQ(dut.number_o, mask == 0 ? 0 : std::countr_zero(mask)) << "mask " << mask;
  }
}

}  // namespace
}  // namespace pipegs
