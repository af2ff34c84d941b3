// SPDX-License-Identifier: Apache-2.0
// ru_unorm_test: rtl/ru/ru_unorm.sv against its bit-accurate model and the nearest code, for every colour.
#include <gtest/gtest.h>

#include <cmath>

#include "cpp_model/ru/ru_resolve.hpp"
#include "verif/support/config.hpp"
#include "Vru_unorm.h"

namespace pipegs {
namespace {

TEST(RuUnorm, IsTheNearestCodeOfEveryColour) {
  const Config config = test_config();
  Vru_unorm dut;
  for (uint64_t color = 0; color < uint64_t{1} << config.rgb_w; ++color) {
    dut.color_i = static_cast<SData>(color);
    dut.eval();
    ASSERT_EQ(dut.code_o, ru_unorm(config, color)) << "colour " << color;
    const double exact = std::ldexp(static_cast<double>(color), 2 - config.rgb_w);
    ASSERT_EQ(dut.code_o, std::min(1023.0, std::floor(1023 * exact + 0.5))) << "colour " << color;
  }
}

}  // namespace
}  // namespace pipegs
