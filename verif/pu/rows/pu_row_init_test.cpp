// SPDX-License-Identifier: Apache-2.0
// pu_row_init_test: rtl/pu/rows/pu_row_init.sv (row 7, the largest factors) against its bit-accurate model; the other
// rows in pu_rows_test.
#include "cpp_model/pu/rows/pu_row_init.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_row_init.h"

namespace pipegs {
namespace {

TEST(PuRowInit, EqualsItsModel) {
  const Config config = test_config();
  Vpu_row_init dut;
  std::mt19937_64 rng(test_seed());
  const auto field = [](int64_t value, int width) {
    return static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1);
  };
  for (int i = 0; i < 100000; ++i) {
    // As large as coefficients in range can make them: docs/units/pu.md.
    Region region = random_record<Region>(config, rng);
    region.power /= 2, region.slope_x /= 2, region.slope_y /= 2, region.curve_x /= 2, region.curve_y /= 2,
        region.twist /= 2;
    dut.power_i = field(region.power, config.power_w());
    dut.slope_x_i = field(region.slope_x, config.gradient_w());
    dut.slope_y_i = field(region.slope_y, config.gradient_w());
    dut.curve_x_i = field(region.curve_x, config.curve_w());
    dut.curve_y_i = field(region.curve_y, config.curve_w());
    dut.twist_i = field(region.twist, config.curve_w());
    dut.eval();
    const Row row = pu_row_init(region, 7);
    ASSERT_EQ(dut.power_o, field(row.power, config.power_w())) << to_text(config, region);
    ASSERT_EQ(dut.slope_o, field(row.slope, config.gradient_w())) << to_text(config, region);
  }
}

}  // namespace
}  // namespace pipegs
