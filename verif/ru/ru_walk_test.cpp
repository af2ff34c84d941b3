// SPDX-License-Identifier: Apache-2.0
// ru_walk_test: rtl/ru/ru_walk.sv against cpp_model/ru/ru_walk.hpp.
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vru_walk.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
using Source = RecordSource<Sorted, decltype(Vru_walk::in_i)>;
using Sink = RecordSink<Fetch, decltype(Vru_walk::out_o)>;

Sorted random_splat(std::mt19937_64& rng, uint64_t kind = kData) {
  Sorted splat = random_record<Sorted>(kConfig, rng);
  splat.kind = kind;
  splat.address %= uint64_t{1} << (kConfig.alpha_address_w() - 1);
  if (rng() % 2) splat.mask &= rng() & rng();
  return splat;
}

void expect_walk(std::vector<Fetch>& expected, const Sorted& splat, int unit, uint64_t done) {
  Fetch fetch{.kind = splat.kind,
              .region = 0,
              .address = splat.address,
              .ext = splat.ext,
              .skip = 0,
              .unit = splat.unit,
              .red = splat.red,
              .green = splat.green,
              .blue = splat.blue,
              .index = splat.index};
  if (splat.kind != kData) {
    expected.push_back(fetch);
    return;
  }
  for (int r = 0; r < kConfig.regions(); ++r) {
    if (!((splat.mask & ru_own_mask(kConfig, unit)) >> r & 1)) continue;
    fetch.skip = done >> r & 1;
    if (fetch.skip && splat.ext) continue;
    fetch.region = r;
    fetch.address = ru_line(splat, r);
    expected.push_back(fetch);
  }
}

void compare(const std::vector<Fetch>& expected, const Sink& out) {
  ASSERT_EQ(out.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    const Fetch found = out.at(i);
    if (expected[i].kind != kData) {
      ASSERT_EQ(found.kind, expected[i].kind) << "beat " << i;
    } else {
      ASSERT_EQ(first_difference(kConfig, expected[i], found), "") << "beat " << i;
    }
  }
}

TEST(RuWalk, WalksTheOwnedRegionsThatAreNotDone) {
  for (int unit = 0; unit < kConfig.units; ++unit) {
    for (const Pace source_pace : kPaces) {
      for (const Pace sink_pace : kPaces) {
        Bench<Vru_walk> bench;
        Source in(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i, source_pace);
        Sink out(bench, kConfig, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o, sink_pace);
        bench.dut.unit_i = unit;
        bench.dut.window_done_i = 0;
        const uint64_t done = unit == 0 ? 0 : random_splat(bench.rng).mask;
        bench.dut.done_i = done;
        bench.reset();
        std::vector<Fetch> expected;
        for (int i = 0; i < 300; ++i) {
          const Sorted splat = random_splat(bench.rng, bench.rng() % 8 == 0 ? kLayerEnd : kData);
          in.push(splat);
          expect_walk(expected, splat, unit, done);
        }
        bench.run_until([&] { return in.empty() && bench.dut.idle_o; });
        compare(expected, out);
      }
    }
  }
}

TEST(RuWalk, DoneOfAnEarlierWindowSkipsNothing) {
  Bench<Vru_walk> bench;
  Source in(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  Sink out(bench, kConfig, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o);
  bench.dut.unit_i = 0;
  bench.dut.window_done_i = 0;
  bench.dut.done_i = ~uint64_t{0} >> (64 - kConfig.regions());
  bench.reset();
  std::vector<Fetch> expected;
  const auto send = [&](uint64_t kind, uint64_t done) {
    const Sorted splat = random_splat(bench.rng, kind);
    in.push(splat);
    expect_walk(expected, splat, 0, done);
    bench.run_until([&] { return in.empty() && bench.dut.idle_o; });
  };
  const auto leave_window = [&] {
    bench.dut.window_done_i = 1;
    bench.step();
    bench.dut.window_done_i = 0;
  };
  const uint64_t done = bench.dut.done_i;
  send(kData, done);
  send(kWindowEnd, done);
  send(kData, 0);
  send(kWindowEnd, 0);
  leave_window();  // the lanes are in the second window, the walk in the third
  send(kData, 0);
  leave_window();
  send(kData, done);
  compare(expected, out);
}

TEST(RuWalk, WalksOneRegionPerCycleAndADoneSplatOfMemoryInOne) {
  Bench<Vru_walk> bench;
  Source in(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  Sink out(bench, kConfig, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o);
  bench.dut.unit_i = 0;
  bench.dut.window_done_i = 0;
  bench.dut.done_i = 0;
  bench.reset();
  std::vector<Fetch> expected;
  for (int i = 0; i < 50; ++i) {
    Sorted splat = random_splat(bench.rng);
    splat.mask |= 1;
    in.push(splat);
    expect_walk(expected, splat, 0, 0);
  }
  bench.run_until([&] { return out.size() == expected.size(); });
  EXPECT_EQ(out.cycles.back() - out.cycles.front() + 1, expected.size());
  bench.dut.done_i = ~uint64_t{0} >> (64 - kConfig.regions());
  for (int i = 0; i < 100; ++i) {
    Sorted splat = random_splat(bench.rng);
    splat.ext = 1;
    in.push(splat);
  }
  const uint64_t start = bench.cycle;
  bench.run_until([&] { return in.empty(); });
  EXPECT_LE(bench.cycle - start, 102u);
}

}  // namespace
}  // namespace pipegs
