// SPDX-License-Identifier: Apache-2.0
// pu_row_unit_test: rtl/pu/rows/pu_row_unit.sv against its bit-accurate model, with pauses between the steps, and the
// bit-accurate model against Eq. 3.
#include "cpp_model/pu/rows/pu_row_unit.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_row_unit.h"

namespace pipegs {
namespace {

TEST(PuRowUnit, WalksARowLikeItsModel) {
  const Config config = test_config();
  Vpu_row_unit dut;
  std::mt19937_64 rng(test_seed());
  const auto field = [](int64_t value, int width) {
    return static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1);
  };
  for (int i = 0; i < 20000; ++i) {
    const Region region = random_record<Region>(config, rng);
    Row row{region.power / 2, region.slope_x / 2};
    const int64_t curve = region.curve_x / 2, first = row.power, slope = row.slope;
    dut.power_i = field(row.power, config.power_w());
    dut.slope_i = field(row.slope, config.gradient_w());
    dut.curve_i = field(curve, config.curve_w());
    dut.load_i = 1;
    for (int dx = 0; dx < 8; dx += config.pixels_per_row) {
      do {  // a pause holds the pixels
        dut.clk_i = 0, dut.eval(), dut.clk_i = 1, dut.eval();
        dut.load_i = dut.step_i = 0;
        dut.power_i = field(static_cast<int64_t>(rng()), config.power_w());
      } while (rng() % 4 == 0);
      dut.step_i = 1;
      Words words(port_words<decltype(dut.power_o)>() + 2);
      read_port(dut.power_o, words.data());
      for (int pixel = 0; pixel < config.pixels_per_row; ++pixel) {
        ASSERT_EQ(get_bits(words.data(), pixel * config.power_w(), config.power_w()),
                  field(row.power, config.power_w()))
            << "pixel " << dx + pixel << " of " << to_text(config, region);
        const int64_t n = dx + pixel;  // Eq. 3 along a row: exact, nothing is rounded
        ASSERT_EQ(row.power, first + (slope - curve) * n + curve * n * n);
        row = pu_row_unit(row, curve);
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
