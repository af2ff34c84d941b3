// SPDX-License-Identifier: Apache-2.0
// open_test: rtl/pipegs_open.sv against its model, and what others build on: the rectangle of a walk holds each of its
// open regions, and within a window it only shrinks.
#include "Vpipegs_open.h"
#include "cpp_model/open.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

// RUs that close regions of a window, and go on to the next one each in its own time.
struct Closing {
  const Config& config;
  std::vector<RegionSet> done;   // of each RU
  std::vector<uint64_t> window;  // of each RU, its number
  explicit Closing(const Config& c) : config(c), done(static_cast<size_t>(c.units)), window(done.size()) {}
  static uint64_t x_of(uint64_t window) { return window % 7; }
  static uint64_t y_of(uint64_t window) { return window / 7; }
  bool together() const {
    return std::all_of(window.begin(), window.end(), [&](uint64_t one) { return one == window.front(); });
  }
  RegionSet all() const {
    RegionSet sum;
    for (const RegionSet& one : done) sum |= one;
    return sum;
  }
  Open expected() const { return together() ? open_of(config, all(), x_of(window[0]), y_of(window[0])) : Open{}; }
  void write(Vpipegs_open& dut) const {
    Words bits(sizeof(dut.progress_i) / 4 + 2);
    const int units = config.units, regions = config.regions(), w = config.window_w();
    for (int u = 0; u < units; ++u) {
      const auto k = static_cast<size_t>(u);
      for (int r = 0; r < regions; ++r) put_bits(bits.data(), u * regions + r, 1, done[k].has(config, r));
      put_bits(bits.data(), units * regions + u * w, w, x_of(window[k]));
      put_bits(bits.data(), units * (regions + w) + u * w, w, y_of(window[k]));
    }
    write_port(dut.progress_i, bits.data());
  }
};

// Each walk with what is said of it.
template <class Each>
void walks(const Config& config, const Open& open, Each&& each) {
  for (const uint64_t walk : all_walks(config)) each(walk, walk_closed(config, open, walk));
}

bool inside(const Config& config, uint64_t walk, const Closed& closed, int region) {
  const WalkSquare square = walk_square(config, walk);
  const int x = region_x(config, region) - static_cast<int>(square.x) / 8,
            y = region_y(config, region) - static_cast<int>(square.y) / 8, side = static_cast<int>(square.side) / 8;
  return x >= static_cast<int>(closed.left) && x < side - static_cast<int>(closed.right) &&
         y >= static_cast<int>(closed.top) && y < side - static_cast<int>(closed.bottom);
}

TEST(OpenModel, HoldsEveryOpenRegionAndOnlyShrinks) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 20; ++i) {
    RegionSet closed;
    Open before = open_of(config, closed, 0, 0);
    for (int step = 0; step < 60; ++step) {
      for (uint64_t k = rng() % 12; k > 0; --k)
        closed.add(config, static_cast<int>(rng() % static_cast<uint64_t>(config.regions())));
      const Open open = open_of(config, closed, 0, 0);
      std::vector<Closed> old;
      walks(config, before, [&](uint64_t, const Closed& one) { old.push_back(one); });
      size_t number = 0;
      walks(config, open, [&](uint64_t walk, const Closed& one) {
        bool some = false;
        for (int r = 0; r < config.regions(); ++r) {
          if (closed.has(config, r) || !walk_has(config, walk, static_cast<uint64_t>(region_part(config, r)))) continue;
          some = true;
          ASSERT_TRUE(inside(config, walk, one, r)) << "walk " << walk << ", region " << r;
        }
        const Closed& last = old[number++];
        if (!some) {
          ASSERT_EQ(one, Closed{});
          return;
        }
        ASSERT_GE(one.left, last.left);
        ASSERT_GE(one.right, last.right);
        ASSERT_GE(one.top, last.top);
        ASSERT_GE(one.bottom, last.bottom);
      });
      before = open;
    }
  }
}

// One region less on any side would be one too few: what is said is the most that holds.
TEST(OpenModel, IsTheSmallestRectangle) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 200; ++i) {
    RegionSet closed = ~RegionSet{};
    for (uint64_t k = 1 + rng() % 5; k > 0; --k) {
      const int r = static_cast<int>(rng() % static_cast<uint64_t>(config.regions()));
      closed.mask[static_cast<size_t>(region_part(config, r))] &= ~(uint64_t{1} << region_bit(config, r));
    }
    const Closed said = open_of(config, closed, 0, 0).whole;
    for (uint64_t Closed::*side : {&Closed::left, &Closed::right, &Closed::top, &Closed::bottom}) {
      Closed more = said;
      ++(more.*side);
      bool all = true;
      for (int r = 0; r < config.regions(); ++r)
        all = all && (closed.has(config, r) || inside(config, kWholeWalk, more, r));
      ASSERT_FALSE(all);
    }
  }
}

TEST(Open, SaysACycleLaterWhatTheRusShow) {
  const Config config = test_config();
  Bench<Vpipegs_open> bench;
  Closing rus(config);
  rus.write(bench.dut);
  bench.reset();
  auto& rng = bench.rng;
  uint64_t known = 0, apart = 0, some = 0;
  uint64_t kind = 0;  // of the window: some regions, none, all at once, all but one, row by row
  for (int i = 0; i < 4000; ++i) {
    const Open expected = rus.expected();
    rus.write(bench.dut);
    bench.step();
    const Open found = read_record<Open>(config, bench.dut.open_o);
    ASSERT_EQ(found.known, expected.known) << "cycle " << i;
    if (expected.known) ASSERT_EQ(first_difference(config, expected, found), "") << "cycle " << i;
    known += found.known, apart += !found.known, some += !(found.whole == Closed{});
    // The next cycle.
    for (size_t u = 0; u < rus.done.size(); ++u) {
      const bool ahead =
          std::any_of(rus.window.begin(), rus.window.end(), [&](uint64_t one) { return one > rus.window[u]; });
      if (ahead ? rng() % 4 == 0 : rus.together() && rng() % 300 == 0) {
        ++rus.window[u];
        rus.done[u] = {};
        kind = rng() % 5;
        continue;
      }
      for (int r = 0; r < config.regions(); ++r) {
        if (ru_owner(config, r) != static_cast<int>(u)) continue;
        const bool now = kind == 0   ? rng() % 64 == 0
                         : kind == 1 ? false
                         : kind == 2 ? rng() % 2000 == 0 || rus.done[u].count() > 0
                         : kind == 3 ? r != 17 % config.regions() && rng() % 8 == 0
                                     : region_y(config, r) <= static_cast<int>(rng() % 40) && rng() % 4 == 0;
        if (now) rus.done[u].add(config, r);
      }
    }
  }
  EXPECT_GT(known, 1000u);
  EXPECT_GT(apart, 20u);
  EXPECT_GT(some, 200u);
}

// What another RU says of a region is not heard: only its owner knows. Of all regions at once it would leave none open,
// and then nothing is said either.
TEST(Open, OnlyTheOwnerClosesARegion) {
  const Config config = test_config();
  if (config.units == 1) GTEST_SKIP();
  Bench<Vpipegs_open> bench;
  Closing rus(config);
  bench.reset();
  for (int r = 0; r < config.regions(); ++r) {
    for (size_t u = 0; u < rus.done.size(); ++u)
      if (region_x(config, r) < 2 && ru_owner(config, r) != static_cast<int>(u)) rus.done[u].add(config, r);
  }
  rus.write(bench.dut);
  bench.step();
  EXPECT_EQ(read_record<Open>(config, bench.dut.open_o), open_of(config, {}, 0, 0));
}

}  // namespace
}  // namespace pipegs
