// SPDX-License-Identifier: Apache-2.0
// ru_offset_test: rtl/ru/place/ru_offset.sv against ru_pixel_line and ru_raster_line, for every word of a window.
#include <gtest/gtest.h>

#include <random>

#include "cpp_model/ru/ru.hpp"
#include "verif/support/config.hpp"
#include "Vru_offset.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();

TEST(RuOffset, IsThatOfTheModelForEveryWord) {
  Vru_offset dut;
  std::mt19937_64 rng(7);
  const Frame frame;
  for (int i = 0; i < 200; ++i) {
    const Picture picture{.format = i % 4 != 0, .base = 0, .stride = i == 1 ? 4095 : rng() % 4096};
    const int rows = i < 8 ? kConfig.window : 1 + static_cast<int>(rng() % static_cast<uint64_t>(kConfig.window));
    dut.raster_i = picture.format != 0;
    dut.stride_i = static_cast<SData>(picture.stride);
    dut.rows_i = static_cast<CData>(rows);
    const int columns = 1 + static_cast<int>(rng() % static_cast<uint64_t>(kConfig.window));
    dut.columns_i = static_cast<CData>(columns);
    for (int region = 0; region < kConfig.regions(); ++region) {
      if (8 * region_y(kConfig, region) >= rows) continue;
      for (int quarter = 0; quarter < 4; ++quarter) {
        dut.region_i = static_cast<CData>(region);
        dut.quarter_i = static_cast<CData>(quarter);
        dut.eval();
        const auto x = static_cast<uint64_t>(8 * region_x(kConfig, region));
        const int row = 8 * region_y(kConfig, region) + 2 * quarter;
        const std::string at = "region " + std::to_string(region) + ", word " + std::to_string(quarter) + ", " +
                               std::to_string(rows) + " rows, format " + std::to_string(picture.format);
        if (picture.format == 0) {
          ASSERT_EQ(dut.offset_o, ru_pixel_line(kConfig, frame, 0, 0, region, 2 * quarter)) << at;
          ASSERT_EQ(dut.two_o, kConfig.pixel_w == 64) << at;
          ASSERT_TRUE(dut.shown_o && dut.more_o) << at;
          continue;
        }
        ASSERT_EQ(dut.shown_o, row < rows) << at;
        if (!dut.shown_o) continue;
        ASSERT_EQ(dut.offset_o, ru_raster_line(picture, x, static_cast<uint64_t>(row))) << at;
        ASSERT_EQ(dut.half_o, ru_raster_half(x)) << at;
        ASSERT_EQ(dut.wide_o, static_cast<int>(x | 8) < columns) << at << ", " << columns << " columns";
        ASSERT_EQ(dut.two_o, row + 1 < rows) << at;
        if (quarter < 3) { ASSERT_EQ(dut.more_o, row + 2 < rows) << at; }
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
