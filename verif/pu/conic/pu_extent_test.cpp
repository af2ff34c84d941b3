// SPDX-License-Identifier: Apache-2.0
// pu_extent_test: rtl/pu/conic/pu_extent.sv against its bit-accurate model; the test plays the slots and the multiplier
// of pu_conic.
#include "cpp_model/pu/conic/pu_extent.hpp"

#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_extent.h"

namespace pipegs {
namespace {

TEST(PuExtent, EqualsItsModel) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  Vpu_extent dut;
  auto field = [](int64_t value, int width) { return static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1); };
  auto random_mantissa = [&] {
    return (rng() & ((uint64_t{1} << config.mantissa_w) - 1)) | (uint64_t{1} << (config.mantissa_w - 1));
  };
  PuExtent expected{};
  for (int i = 0; i < 20000; ++i) {
    Covariance r;
    r.a_m = random_mantissa(), r.c_m = random_mantissa();
    r.a_e = static_cast<int64_t>(rng() % 50) - config.mantissa_w - 4;
    r.c_e = static_cast<int64_t>(rng() % 50) - config.mantissa_w - 4;
    r.opacity = rng() & ((uint64_t{1} << config.opacity_w()) - 1);
    if (rng() % 2 == 0) r.opacity >>= rng() % static_cast<uint64_t>(config.opacity_w());
    uint64_t t = 0;
    for (int phase = 0; phase < 8; ++phase) {
      const int waits = phase == 5 ? static_cast<int>(rng() % 3) : 0;
      for (int wait = waits; wait >= 0; --wait) {
        dut.phase_i = static_cast<CData>(1 << phase), dut.advance_i = wait == 0;
        dut.opacity_i = r.opacity;
        dut.a_e_i = static_cast<SData>(field(r.a_e, config.float_e_w())),
        dut.c_e_i = static_cast<SData>(field(r.c_e, config.float_e_w()));
        dut.product_i = phase == 3   ? r.a_m * t
                        : phase == 4 ? r.c_m * t
                                     : rng() & ((uint64_t{1} << (config.mantissa_w + 4)) - 1);
        dut.clk_i = 0, dut.eval();
        if (phase == 2) t = dut.t_o;
        if (phase == 5 && i > 0) {
          ASSERT_EQ(dut.extent_x_o, expected.x) << "record " << i;
          ASSERT_EQ(dut.extent_y_o, expected.y) << "record " << i;
        }
        dut.clk_i = 1, dut.eval();
      }
    }
    expected = pu_extent(config, r);
  }
}

}  // namespace
}  // namespace pipegs
