// SPDX-License-Identifier: Apache-2.0
// ru_own_test: rtl/ru/place/ru_own.sv against ru_own_mask, for every unit.
#include <gtest/gtest.h>

#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/config.hpp"
#include "Vru_own.h"

namespace pipegs {
namespace {

TEST(RuOwn, DealsEveryRegionToOneUnit) {
  const Config config = test_config();
  Vru_own dut;
  uint64_t all = 0;
  for (int unit = 0; unit < config.units; ++unit) {
    dut.unit_i = unit;
    dut.eval();
    EXPECT_EQ(dut.own_o, ru_own_mask(config, unit)) << "unit " << unit;
    EXPECT_EQ(all & dut.own_o, 0u);
    all |= dut.own_o;
  }
  EXPECT_EQ(std::popcount(all), config.regions());
}

}  // namespace
}  // namespace pipegs
