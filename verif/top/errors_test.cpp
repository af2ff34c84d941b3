// SPDX-License-Identifier: Apache-2.0
// errors_test: rtl/pipegs_errors.sv: each cause is told once, with the line that came first, and what it stops stays
// stopped.
#include "Vpipegs_errors.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

struct ErrorsBench : Bench<Vpipegs_errors> {
  ErrorsBench() {
    dut.restart_i = dut.full_i = dut.bad_i = dut.by_windows_i = dut.stride_i = 0;
    reset();
  }
  uint64_t told(int cause) {
    Words words(port_words<decltype(dut.error_line_o)>() + 2);
    read_port(dut.error_line_o, words.data());
    return get_bits(words.data(), cause * config.address_w(), config.address_w());
  }
  void lines(uint64_t first, uint64_t second) {
    Words words(port_words<decltype(dut.full_line_i)>() + 2);
    put_bits(words.data(), 0, config.address_w(), first);
    put_bits(words.data(), config.address_w(), config.address_w(), second);
    write_port(dut.full_line_i, words.data());
  }
  void begin(const Raster& raster, const Span& pixels, bool by_windows, uint64_t stride) {
    write_record(config, dut.raster_i, raster);
    write_record(config, dut.pixels_i, pixels);
    dut.by_windows_i = by_windows;
    dut.stride_i = static_cast<SData>(stride);
    dut.restart_i = 1;
    step();
    dut.restart_i = 0;
  }
  const Config config = test_config();
};

TEST(Errors, EachCauseIsToldOnceWithTheLineThatCameFirst) {
  for (int round = 0; round < 200; ++round) {
    ErrorsBench bench;
    auto& dut = bench.dut;
    const uint64_t mask = (uint64_t{1} << bench.config.address_w()) - 1;
    uint64_t first[2] = {}, times[2] = {}, last[2] = {};
    bool known[2] = {}, stopped = false;
    for (int cycle = 0; cycle < 60; ++cycle) {
      const uint64_t one = bench.rng() & mask, two = bench.rng() & mask, three = bench.rng() & mask;
      if (bench.rng() % 20 == 0) dut.full_i |= 1 + bench.rng() % 3;
      if (bench.rng() % 20 == 0) dut.bad_i = 1;
      bench.lines(one, two);
      dut.bad_line_i = three;
      const bool found[2] = {dut.full_i != 0, dut.bad_i != 0};
      const uint64_t line[2] = {(dut.full_i & 1) != 0 ? one : two, three};
      bench.step();
      bench.dut.eval();
      for (int cause = 0; cause < 2; ++cause) {
        if (found[cause] && !known[cause]) first[cause] = line[cause], known[cause] = true, stopped = true;
        if (dut.error_o >> cause & 1) ++times[cause], last[cause] = bench.told(cause);
      }
      ASSERT_EQ(dut.stop_o, stopped) << "cycle " << cycle << ", seed " << bench.seed;
    }
    for (int cause = 0; cause < 2; ++cause) {
      ASSERT_EQ(times[cause], known[cause] ? 1u : 0u) << "cause " << cause << ", seed " << bench.seed;
      ASSERT_EQ(last[cause], first[cause]) << "cause " << cause << ", seed " << bench.seed;
      if (known[cause]) { ASSERT_EQ(bench.told(cause), first[cause]) << "its line stays, seed " << bench.seed; }
    }
  }
}

// By windows, or down to the last row and as far as the last column of the frame, whatever the stride is.
TEST(Errors, PixelsUpToTheLastOneNeedTheirRoom) {
  const Config config = test_config();
  const auto side = static_cast<uint64_t>(config.window);
  const uint64_t lines = static_cast<uint64_t>(config.region_lines() * config.regions());
  for (int round = 0; round < 600; ++round) {
    ErrorsBench bench;
    Raster raster;
    raster.width = 1 + bench.rng() % std::min<uint64_t>(16384, 1024 * side);
    raster.height = 1 + bench.rng() % std::min<uint64_t>(16384, 1024 * side);
    const uint64_t columns = (raster.width + side - 1) / side, rows = (raster.height + side - 1) / side;
    const bool whole = bench.rng() % 3 == 0, by_windows = round % 3 == 0;
    raster.windows.last_x = whole ? columns - 1 : bench.rng() % columns;
    raster.windows.last_y = whole ? rows - 1 : bench.rng() % rows;
    const uint64_t stride = bench.rng() % (uint64_t{1} << config.stride_w());
    const uint64_t right = std::min(raster.width, (raster.windows.last_x + 1) * side);
    const uint64_t below = std::min(raster.height, (raster.windows.last_y + 1) * side);
    const uint64_t need = by_windows ? (raster.windows.last_y * columns + raster.windows.last_x + 1) * lines
                                     : (below - 1) * stride + (right + 15) / 16;
    const uint64_t room = need - 1 + round % 2;
    const bool aovs = config.has_aovs() && bench.rng() % 2 == 0;
    if (aovs) raster.aovs = {.wanted = 1 + bench.rng() % 15, .base = 1 << 30, .lines = need - bench.rng() % 2};
    const bool small = room < need, outgrown = aovs && raster.aovs.lines < need;
    bench.begin(raster, {1000, room}, by_windows, stride);
    int told = 0;
    for (int i = 0; i < 5; ++i) {
      bench.step();
      told += bench.dut.error_o;
    }
    ASSERT_EQ(told, small || outgrown ? 1 : 0)
        << columns << " columns, need " << need << ", stride " << stride << ", seed " << bench.seed;
    if (told != 0) { ASSERT_EQ(bench.told(0), small ? 1000 + room : raster.aovs.base + raster.aovs.lines); }
    ASSERT_EQ(bench.dut.stop_o, told != 0);
  }
}

}  // namespace
}  // namespace pipegs
