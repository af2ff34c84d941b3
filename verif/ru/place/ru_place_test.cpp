// SPDX-License-Identifier: Apache-2.0
// ru_place_test: rtl/ru/place/ru_place.sv against region_x and region_y, and these against region_at.
#include <gtest/gtest.h>

#include "cpp_model/regions.hpp"
#include "verif/support/config.hpp"
#include "Vru_place.h"

namespace pipegs {
namespace {

TEST(RuPlace, IsWhereTheRegionLies) {
  const Config config = test_config();
  Vru_place dut;
  for (int region = 0; region < config.regions(); ++region) {
    dut.region_i = region;
    dut.eval();
    EXPECT_EQ(dut.column_o, region_x(config, region)) << "region " << region;
    EXPECT_EQ(dut.row_o, region_y(config, region)) << "region " << region;
    EXPECT_EQ(region_at(config, dut.column_o, dut.row_o), region);
    // Parts and their regions are numbered row by row.
    const int part = dut.row_o * 8 / config.part_side() * config.parts_x() + dut.column_o * 8 / config.part_side();
    EXPECT_EQ(region_part(config, region), part);
  }
}

}  // namespace
}  // namespace pipegs
