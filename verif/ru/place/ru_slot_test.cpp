// SPDX-License-Identifier: Apache-2.0
// ru_slot_test: rtl/ru/place/ru_slot.sv against ru_slot and its inverse ru_region.
#include <gtest/gtest.h>

#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/config.hpp"
#include "Vru_slot.h"

namespace pipegs {
namespace {

TEST(RuSlot, IsTheNumberAmongTheOwnedRegions) {
  const Config config = test_config();
  Vru_slot dut;
  for (int region = 0; region < config.regions(); ++region) {
    dut.region_i = region;
    dut.eval();
    const int unit = ru_owner(config, region);
    const uint64_t below = ru_own_mask(config, unit) & ((uint64_t{1} << region) - 1);
    EXPECT_EQ(dut.slot_o, ru_slot(config, region)) << "region " << region;
    EXPECT_EQ(dut.slot_o, std::popcount(below)) << "region " << region;
    EXPECT_EQ(ru_region(config, unit, dut.slot_o), region);
  }
}

}  // namespace
}  // namespace pipegs
