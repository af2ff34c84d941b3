// SPDX-License-Identifier: Apache-2.0
// pu_align_test: rtl/pu/conic/pu_align.sv against its bit-accurate model.
#include "cpp_model/pu/conic/pu_align.hpp"

#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_align.h"

namespace pipegs {
namespace {

TEST(PuAlign, EqualsItsModel) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  Vpu_align dut;
  constexpr int kDataW = 66;  // the module's default
  int fits = 0;
  for (int i = 0; i < 200000; ++i) {
    const Int128 wide = static_cast<Int128>((static_cast<Uint128>(rng()) << 64) | rng());
    const Int128 m = (wide >> (128 - kDataW)) >> (rng() % kDataW);
    const int64_t shift = static_cast<int64_t>(rng() % 90) - 4 + (rng() % 16 == 0 ? 1000 : 0);
    const uint32_t words[3] = {static_cast<uint32_t>(m), static_cast<uint32_t>(m >> 32),
                               static_cast<uint32_t>(m >> 64) & 3};
    write_port(dut.product_i, words);
    dut.shift_i = static_cast<SData>((shift - 1) & 0x1fff);
    dut.enable_i = 1, dut.clk_i = 0, dut.eval();
    dut.clk_i = 1, dut.eval();
    dut.enable_i = 0, dut.clk_i = 0, dut.shift_i = static_cast<SData>(rng() & 0x1fff), dut.eval();
    dut.clk_i = 1, dut.eval();
    const struct {
      int width;
      bool fits;
    } cases[] = {
        {config.a_w(), dut.fits_a_o != 0}, {config.bc_w(), dut.fits_bc_o != 0}, {config.def_w(), dut.fits_def_o != 0}};
    for (const auto& c : cases) {
      PuAlign align{config.coeff_f, 0};
      const int64_t value = align(m, -shift - config.coeff_f, c.width);
      ASSERT_EQ(c.fits, !align.dead) << "shift " << shift << " width " << c.width;
      const uint64_t mask = (uint64_t{1} << c.width) - 1;
      if (c.fits) {
        ASSERT_EQ((dut.floor_o + dut.up_o) & mask, static_cast<uint64_t>(value) & mask) << "shift " << shift;
      }
      fits += c.fits;
    }
  }
  EXPECT_GT(fits, 100000);
}

}  // namespace
}  // namespace pipegs
