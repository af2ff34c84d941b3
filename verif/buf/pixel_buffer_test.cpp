// SPDX-License-Identifier: Apache-2.0
// pixel_buffer_test: rtl/buf/pipegs_pixel_buffer.sv against two arrays with fresh flags.
#include <array>
#include <optional>

#include "verif/support/bench.hpp"
#include "Vpipegs_pixel_buffer.h"

namespace pipegs {
namespace {

constexpr int kWords = 64;  // the module's default

using Half = std::array<std::optional<uint64_t>, kWords>;  // nothing: fresh

TEST(PixelBuffer, BothSidesSeeTheirHalfAndASwapMakesTheNextOneFresh) {
  Bench<Vpipegs_pixel_buffer> bench;
  auto& dut = bench.dut;
  dut.swap_i = dut.blend_read_i = dut.blend_write_i = dut.resolve_read_i = 0;
  bench.reset();
  std::array<Half, 2> halves;
  int blended = 0;
  std::optional<std::optional<uint64_t>> blend_expected, resolve_expected;  // outer: something was read
  for (int i = 0; i < 20000; ++i) {
    dut.swap_i = bench.rng() % 200 == 0;
    const bool access = !dut.swap_i;
    dut.blend_read_i = access && bench.rng() % 2;
    dut.blend_write_i = access && bench.rng() % 2;
    dut.resolve_read_i = access && bench.rng() % 2;
    dut.blend_raddr_i = bench.rng() % kWords;
    do dut.blend_waddr_i = bench.rng() % kWords;
    while (dut.blend_read_i && dut.blend_waddr_i == dut.blend_raddr_i);
    dut.blend_wdata_i = bench.rng();
    dut.resolve_raddr_i = bench.rng() % kWords;
    if (dut.blend_read_i) blend_expected = halves[blended][dut.blend_raddr_i];
    if (dut.resolve_read_i) resolve_expected = halves[1 - blended][dut.resolve_raddr_i];
    if (dut.blend_write_i) halves[blended][dut.blend_waddr_i] = dut.blend_wdata_i;
    if (dut.swap_i) {
      blended = 1 - blended;
      halves[blended].fill(std::nullopt);
      blend_expected.reset();
      resolve_expected.reset();
    }
    bench.step();
    if (blend_expected) {
      ASSERT_EQ(dut.blend_fresh_o, !*blend_expected) << "cycle " << bench.cycle;
      if (*blend_expected) { ASSERT_EQ(dut.blend_rdata_o, **blend_expected) << "cycle " << bench.cycle; }
    }
    if (resolve_expected) {
      ASSERT_EQ(dut.resolve_fresh_o, !*resolve_expected) << "cycle " << bench.cycle;
      if (*resolve_expected) { ASSERT_EQ(dut.resolve_rdata_o, **resolve_expected) << "cycle " << bench.cycle; }
    }
  }
}

}  // namespace
}  // namespace pipegs
