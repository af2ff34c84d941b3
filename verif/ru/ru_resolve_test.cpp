// SPDX-License-Identifier: Apache-2.0
// ru_resolve_test: rtl/ru/ru_resolve.sv against cpp_model/ru/ru_resolve.hpp.
#include <optional>

#include "cpp_model/ru/ru_resolve.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/ru/pixel_words.hpp"
#include "verif/ru/region_ports.hpp"
#include "verif/ru/written_pixels.hpp"
#include "verif/support/config.hpp"
#include "Vru_resolve.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();

// A word is two rows of a region, also where quads are blended.
const Config kWhole = [] {
  Config config = kConfig;
  config.quads = 0;
  return config;
}();

// One window: a pixel buffer with random, partly fresh words, and a memory that takes lines at some pace.
void resolve_window(Pace pace, uint64_t seed, bool raster, bool expect_rate) {
  Bench<Vru_resolve> bench(seed);
  auto& dut = bench.dut;
  Frame frame;
  frame.raster.width = kConfig.window + 1 + bench.rng() % kConfig.window;
  frame.raster.height = 2 * kConfig.window + 1 + bench.rng() % kConfig.window;
  frame.tables.pixels = bench.rng() % 1000000;
  const Picture picture = random_picture(kConfig, frame, bench.rng, raster);
  const uint64_t x = bench.rng() % 2, y = bench.rng() % 3;
  const int unit = bench.rng() % kConfig.units;
  dut.unit_i = unit;
  dut.raster_i = raster;
  dut.stride_i = static_cast<SData>(picture.stride);
  dut.start_i = dut.mem_ready_i = 0;
  bench.reset();

  std::vector<std::optional<Words>> words;
  WrittenPixels expected;
  RuState state = ru_start(kConfig, frame, unit);
  state.window_x = x;
  state.window_y = y;
  RegionSet outside;
  for (int r = 0; r < kConfig.regions(); ++r) outside.add(kConfig, r, !ru_inside(kConfig, frame, x, y, r));
  for (int slot = 0; slot < kConfig.regions() / kConfig.units; ++slot) {
    const int r = ru_region(kConfig, unit, slot);
    RegionState region = random_region(kConfig, bench.rng);
    const RegionState fresh = ru_fresh_region(kConfig, frame, x, y, r);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const bool is_fresh = bench.rng() % 3 == 0;
      words.push_back(is_fresh ? std::nullopt : std::optional(pixel_word(kWhole, region, quarter)));
      for (int i = 16 * quarter; i < 16 * quarter + 16 && is_fresh; ++i) {
        region.t[i] = fresh.t[i];
        for (size_t j = 0; j < 3; ++j) region.rgb[j][i] = fresh.rgb[j][i];
      }
    }
    state.regions[slot] = region;
    if (!outside.has(kConfig, r)) expected.expect(kConfig, frame, picture, state, r);
  }

  dut.start_i = 1;
  const auto side = static_cast<uint64_t>(kConfig.window);
  dut.line_i = raster ? ru_raster_line(picture, x * side, y * side) : ru_pixel_line(kConfig, frame, x, y, 0, 0);
  dut.columns_i = std::min(side, frame.raster.width - x * side);
  dut.rows_i = std::min(side, frame.raster.height - y * side);
  write_regions(kConfig, dut.outside_i, outside);
  EXPECT_TRUE(dut.ready_o);
  bench.step();
  dut.start_i = 0;
  dut.line_i = dut.columns_i = dut.rows_i = 0;
  write_regions(kConfig, dut.outside_i, {});
  uint64_t lines = 0;
  const uint64_t start = bench.cycle;
  for (; !dut.ready_o;) {
    ASSERT_LT(bench.cycle - start, 100000u);
    dut.mem_ready_i = goes(pace, bench.rng);
    dut.clk_i = 0;
    dut.eval();
    const bool reads = dut.read_o;
    const int address = dut.raddr_o;
    if (dut.mem_valid_o && dut.mem_ready_i) {
      ++lines;
      ASSERT_NO_FATAL_FAILURE(expected.take(dut.mem_address_o, dut.mem_halves_o, dut.mem_data_o, seed));
      ASSERT_EQ(dut.mem_wide_o, raster && WrittenPixels::wide(frame, picture, dut.mem_address_o));
    }
    bench.step();
    if (reads) {
      Words noise(words.size() + 100);
      write_port(dut.rdata_i, words[address] ? words[address]->data() : noise.data());
      dut.fresh_i = !words[address];
      dut.eval();
    }
  }
  EXPECT_TRUE(expected.empty());
  if (expect_rate) { EXPECT_LE(bench.cycle - start, lines + 2); }
}

TEST(RuResolve, WritesTheLinesOfItsModel) {
  for (const Pace pace : kPaces) {
    for (uint64_t i = 0; i < 60; ++i)
      ASSERT_NO_FATAL_FAILURE(resolve_window(pace, test_seed() + i, i % 2 != 0, pace == Pace::kAlways));
  }
}

TEST(RuResolve, PixelFieldsLieWhereTheDriverReadsThem) {
  Config config;                                                                     // the default widths
  EXPECT_EQ(ru_resolve(config, {1u << 18, {0, 0, 0}, false}), 0x8000000000000000u);  // T = 1, black
  EXPECT_EQ(ru_resolve(config, {7, {1, 2, 3}, true}), 0x0000000300020001u);          // T below 2^-15 is cut
  EXPECT_EQ(ru_rgba8(config, 0x8000000000000000u), 0xff000000u);                     // R, G, B are 0, A is 255
  EXPECT_EQ(ru_rgba8(config, 0x0000ffff20004000u), 0xffff80ffu);                     // 1, a half, almost 4
}

}  // namespace
}  // namespace pipegs
