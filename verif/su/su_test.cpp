// SPDX-License-Identifier: Apache-2.0
// su_test: rtl/su/pipegs_su.sv with all it wires together against cpp_model/su/su.hpp, where every end releases
// everything.
#include "verif/su/su_bench.hpp"

namespace pipegs {
namespace {

TEST(Su, SortsLayersOfEverySizeAndArrangementAtEveryPace) {
  std::mt19937_64 rng(test_seed());
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      for (const bool gated : {false, true}) {
        SuBench bench(source, sink, gated, memory_options(rng), static_cast<int>(rng() % 4));
        for (const Arrangement arrangement : kArrangements) {
          for (const size_t count : {0, 1, 2, 15, 16, 17, 100})
            bench.layer(arrangement, count, rng() % 3 ? kLayerEnd : kWindowEnd);
        }
        for (int i = 0; i < 20; ++i) bench.layer(kArrangements[rng() % 8], rng() % 40, kLayerEnd);
        bench.check(3000000);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(Su, GatingItsClockChangesNoCycle) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      std::vector<uint64_t> cycles[2];
      for (const bool gated : {false, true}) {
        SuBench bench(source, sink, gated);
        for (const size_t count : {0, 40, 3, 17, 90, 0, 0, kConfig.records + 30, 1, 60})
          bench.layer(Arrangement::kRandom, count, kLayerEnd);
        bench.check(3000000);
        cycles[gated] = bench.out.cycles;
      }
      ASSERT_EQ(cycles[0], cycles[1]) << "source " << to_text(source) << ", sink " << to_text(sink);
    }
  }
}

TEST(Su, SleepsWhileTheOutputIsBlocked) {
  SuBench bench(Pace::kAlways, Pace::kQuarter, true);
  for (int i = 0; i < 20; ++i) bench.layer(Arrangement::kRandom, 12, kLayerEnd);
  bench.check(100000);
  EXPECT_GT(bench.asleep, bench.cycle / 5);
  bench.blocked = true;
  bench.layer(Arrangement::kRandom, 12, kLayerEnd);
  for (int i = 0; i < 200; ++i) bench.step();
  const uint64_t before = bench.asleep;
  for (int i = 0; i < 50; ++i) bench.step();
  EXPECT_EQ(bench.asleep, before + 50);
  bench.blocked = false;
  bench.check(1000);
}

TEST(Su, SortsLargeLayersOfEveryArrangement) {
  std::mt19937_64 rng(test_seed() + 1);
  const size_t store = kConfig.records;
  for (const Arrangement arrangement : kArrangements) {
    SuBench bench(Pace::kAlways, rng() % 2 ? Pace::kAlways : Pace::kCoin, true, memory_options(rng));
    for (const size_t count :
         {store - 1, store, store + 1, store + 7, store + 8, 2 * store, 5 * store + 3, size_t{1000}}) {
      bench.layer(arrangement, count, kLayerEnd);
    }
    bench.check(20000000);
    if (testing::Test::HasFailure()) return;
  }
}

// Runs are made while the set still grows, of whole lines of its list.
TEST(Su, SortsWhatIsInMemoryWhileTheSetStillGrows) {
  const size_t records = kConfig.records;
  SuBench bench(Pace::kAlways, Pace::kAlways, true);
  std::vector<Splat> splats;
  const auto push = [&](size_t count) {
    for (const uint64_t key : su_keys(kConfig, Arrangement::kRandom, count, bench.rng)) {
      Splat splat = random_record<Splat>(kConfig, bench.rng);
      splat.kind = kData;
      splat.depth = key >> kConfig.index_w, splat.index = key & ((uint64_t{1} << kConfig.index_w) - 1);
      splats.push_back(splat);
      bench.in.push(splat);
    }
    for (size_t i = 0; i < 40 * records + 3000; ++i) bench.step();
  };
  push(2 * records + 3);
  EXPECT_GE(bench.fetched, records / 8);
  push(5);
  su_sort(splats);
  bench.expected = splats;
  bench.expected.push_back({.kind = kLayerEnd});
  bench.in.push({.kind = kLayerEnd});
  bench.check(1000000);
}

TEST(Su, SortsFiveThousand) {
  std::mt19937_64 rng(test_seed() + 2);
  SuBench bench(Pace::kAlways, Pace::kAlways, true, memory_options(rng));
  bench.layer(Arrangement::kRandom, 5000, kLayerEnd);
  bench.layer(Arrangement::kEqualDepth, 5000, kWindowEnd);
  bench.layer(Arrangement::kClustered, 5000, kLayerEnd);
  bench.layer(Arrangement::kOutlier, 30, kWindowEnd);
  bench.check(50000000);
}

TEST(Su, WritesOverflowToItsOwnAreas) {
  ExternalMemoryOptions options;
  SuBench bench(Pace::kAlways, Pace::kAlways, true, options, 2);
  const size_t pool = kConfig.records, count = pool + 9;
  bench.layer(Arrangement::kRandom, 3, kLayerEnd);
  bench.layer(Arrangement::kRandom, count, kWindowEnd);
  bench.check(10000000);
  const SuTraffic traffic = su_external_traffic(kConfig, count);
  EXPECT_EQ(bench.overflowed, traffic.written);
  EXPECT_EQ(bench.fetched, traffic.read) << "nothing for ends";
  const auto base = [](Area area) { return kOverflow + area_first(kConfig, kOverflowLines, 2, area); };
  const uint64_t records = base(Area::kRecords), keys = base(Area::kKeys), sorted = base(Area::kRuns);
  const ExternalMemory before;
  const auto touched = [&](uint64_t at) { return bench.memory.line(at) != before.line(at); };
  const uint64_t runs = su_run_lines(kConfig, pool / 8 * 8) + su_run_lines(kConfig, count - pool / 8 * 8);
  EXPECT_TRUE(touched(records) && touched(records + count - 1) && touched(keys) && touched(keys + (count - 1) / 8) &&
              touched(sorted) && touched(sorted + runs - 1));
  EXPECT_FALSE(touched(records + count) || touched(keys - 1) || touched(keys + (count - 1) / 8 + 1) ||
               touched(sorted + runs));
}

// A set is sorted, or its areas have no room and the SU says so: in no case a line goes elsewhere.
TEST(Su, StopsWhenAnAreaIsFull) {
  int full = 0, sorted = 0;
  const size_t count = 3 * static_cast<size_t>(kConfig.records) + 5;
  for (uint64_t lines = 1; lines < 64 * count; lines = 5 * lines / 4 + 1) {
    SuBench bench(Pace::kAlways, Pace::kAlways, true, {}, 1);
    Frame frame;
    frame.tables.overflow = kOverflow;
    Areas areas = wide_areas();
    areas.overflow = lines;
    write_frame(kConfig, bench.dut, frame, areas);
    const auto first = [&](Area area) { return kOverflow + area_first(kConfig, lines, 1, area); };
    bench.memory.set_lines(first(Area::kRecords) + area_lines(kConfig, lines, Area::kRecords));
    bench.layer(Arrangement::kRandom, count, kWindowEnd);
    for (int i = 0; i < 400000 && bench.out.size() < bench.expected.size() && !bench.dut.full_o; ++i) bench.step();
    if (bench.dut.full_o) {
      ++full;
      EXPECT_EQ(bench.dut.mem_valid_o, 0);
      const uint64_t line = bench.dut.full_line_o;
      bool at_end = false;
      for (const Area area : {Area::kKeys, Area::kMerged, Area::kRuns, Area::kRecords})
        at_end |= line == first(area) + area_lines(kConfig, lines, area);
      EXPECT_TRUE(at_end) << "line " << line << " of " << lines;
      continue;
    }
    ++sorted;
    ASSERT_EQ(bench.out.size(), bench.expected.size());
    for (size_t i = 0; i < bench.out.size(); ++i)
      ASSERT_EQ(first_difference(kConfig, bench.expected[i], bench.out.at(i)), "") << lines << " lines";
  }
  EXPECT_GT(full, 5);
  EXPECT_GT(sorted, 2);
}

// From one run to as many as need three merges: the traffic is that of the number of records, whatever the keys.
TEST(Su, MergesAsOftenAsTheNumberOfRecordsNeedsAndNoMore) {
  std::mt19937_64 rng(test_seed() + 3);
  const size_t pool = kConfig.records / 8 * 8, ways = kConfig.su_ways();
  size_t most = 0;
  for (const size_t count : {pool * ways, pool * ways + 1, pool * ways * ways, pool * ways * ways + 1, size_t{3001}}) {
    if (count <= static_cast<size_t>(kConfig.records) || count > 20000) continue;
    for (const Arrangement arrangement : {kArrangements[rng() % 8], kArrangements[rng() % 8]}) {
      SuBench bench(Pace::kAlways, rng() % 2 ? Pace::kAlways : Pace::kCoin, true, memory_options(rng));
      bench.layer(arrangement, count, rng() % 2 ? kLayerEnd : kWindowEnd);
      bench.check(3000000);
      const SuTraffic traffic = su_external_traffic(kConfig, count);
      ASSERT_EQ(bench.overflowed, traffic.written) << count << " records, " << to_text(arrangement);
      ASSERT_EQ(bench.fetched, traffic.read) << count << " records, " << to_text(arrangement);
      most = std::max(most, static_cast<size_t>(traffic.levels));
    }
  }
  EXPECT_GE(most, kConfig.records < 100 ? 3u : 1u);
}

TEST(Su, TellsWhatItWaitsFor) {
  SuBench bench(Pace::kAlways, Pace::kAlways, false);
  std::fill_n(bench.perf, 4, 0);
  for (int i = 0; i < 10; ++i) bench.step();
  EXPECT_EQ(bench.perf[1], 10u);  // starved
  bench.layer(Arrangement::kRandom, 16, kLayerEnd);
  for (int i = 0; i < 21; ++i) bench.step();  // one in the register in front of it
  EXPECT_EQ(bench.perf[0], 20u);              // busy
  bench.blocked = true;
  for (int i = 0; i < 120; ++i) bench.step();  // until all sixteen wait for the output
  bench.perf[2] = 0;
  for (int i = 0; i < 50; ++i) bench.step();
  EXPECT_EQ(bench.perf[2], 50u);  // blocked
  EXPECT_EQ(bench.perf[3], 0u);
  bench.blocked = false;
  bench.check(1000);
}

TEST(Su, CollectsLayersWhileTheOutputIsBlockedAsLongAsThePoolHasRoom) {
  SuBench bench(Pace::kAlways, Pace::kAlways, false);
  // The fourth layer does not fit beside three others, three splats of which have left their slots.
  const size_t records = kConfig.records, count = (records + 3) / 4 + 1;
  for (int i = 0; i < 6; ++i) bench.layer(Arrangement::kRandom, count, kLayerEnd);
  bench.blocked = true;
  for (size_t i = 0; i < 20 * records + 1000; ++i) bench.step();
  EXPECT_EQ(bench.in.taken,
            records + 3 + 3 + 2);  // the slots of the three splats at the output are free again; two wait in front
  EXPECT_EQ(bench.overflowed, 0u) << "a layer that has to wait does not go to memory";
  bench.blocked = false;
  bench.check(100000);
}

TEST(Su, KeepsManySmallLayers) {
  SuBench bench(Pace::kAlways, Pace::kAlways, false);
  bench.blocked = true;
  for (int i = 0; i < 40; ++i) bench.layer(Arrangement::kRandom, 1, i % 3 == 2 ? kWindowEnd : kLayerEnd);
  for (int i = 0; i < 2000; ++i) bench.step();
  EXPECT_GE(bench.in.taken, 2 * std::min<size_t>(40, kConfig.records)) << "as many live as slots reach";
  bench.blocked = false;
  bench.check(100000);
}

// Cycles per key when layers of this size follow each other without a pause, all units of time included.
double cycles_per_key(size_t count, Arrangement arrangement, int layers) {
  ExternalMemoryOptions options;
  SuBench bench(Pace::kAlways, Pace::kAlways, true, options);
  for (int i = 0; i < layers; ++i) bench.layer(arrangement, count, kLayerEnd);
  bench.check(20000000);
  return static_cast<double>(bench.out.cycles.back() - bench.out.cycles[count]) / (layers - 1) / count;
}

// Of the default machine: others have other bounds.
TEST(Su, KeepsItsPace) {
  if (!(kConfig == Config{})) return;
  struct Case {
    size_t count;
    double bound;
  };
  for (const auto& [count, bound] :
       {Case{16, 4.2}, Case{40, 3.7}, Case{90, 3.3}, Case{200, 3.1}, Case{350, 3.0}, Case{512, 2.9}, Case{1000, 2.7},
        Case{2000, 14.5}}) {  // the last does not fit the pool
    const double random = cycles_per_key(count, Arrangement::kRandom, 8);
    const double narrow = cycles_per_key(count, Arrangement::kNarrow, 8);
    const double clustered = cycles_per_key(count, Arrangement::kClustered, 8);
    std::printf("%4zu keys per layer: %.2f cycles per key, 64 neighbouring depths %.2f, clustered %.2f\n", count,
                random, narrow, clustered);
    EXPECT_LE(random, bound) << count << " keys";
  }
}

// The share of an SU in windows of ten thousand to a million records: cycles for each record within twice of each
// other, all units of time included, and bytes within three times those of the record, however depths are spread.
TEST(Su, SortsSetsThatDoNotFitAtOnePace) {
  if (!(kConfig == Config{})) return;
  constexpr Arrangement kSpreads[] = {Arrangement::kRandom, Arrangement::kEqualDepth, Arrangement::kExtremes,
                                      Arrangement::kOutlier, Arrangement::kClustered};
  double fastest = 1e9, slowest = 0;
  for (const size_t count : {2500, 25000}) {  // more of them on the timing model: load_test
    for (const Arrangement arrangement : kSpreads) {
      SuBench bench(Pace::kAlways, Pace::kAlways, false);
      bench.layer(arrangement, count, kWindowEnd);
      bench.check(100 * count);
      if (testing::Test::HasFailure()) return;
      const double cycles = static_cast<double>(bench.out.cycles.back()) / count;
      const double bytes = 64.0 * static_cast<double>(bench.overflowed + bench.fetched) / count;
      std::printf("%6zu records, %-11s: %.2f cycles and %.1f bytes per record\n", count, to_text(arrangement), cycles,
                  bytes);
      EXPECT_LE(bytes, 192.0);
      EXPECT_LE(cycles, 26.0);
      fastest = std::min(fastest, cycles);
      slowest = std::max(slowest, cycles);
    }
  }
  EXPECT_LE(slowest, 2 * fastest);
}

}  // namespace
}  // namespace pipegs
