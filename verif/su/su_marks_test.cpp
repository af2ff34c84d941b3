// SPDX-License-Identifier: Apache-2.0
// su_marks_test: rtl/su/pipegs_su.sv against cpp_model/su/su.hpp when a layer's end is a watermark (order=2).
#include "verif/su/su_bench.hpp"
#include "verif/su/su_windows.hpp"

namespace pipegs {
namespace {

Splat random_splat(std::mt19937_64& rng) { return random_record<Splat>(kConfig, rng); }

// How the other SUs seem to be doing.
enum class Others { kWell, kSpill, kNow };

struct MarksBench : SuBench {
  using SuBench::SuBench;
  void push(const std::vector<Splat>& beats) {
    for (const Splat& beat : beats) in.push(beat);
    sent.insert(sent.end(), beats.begin(), beats.end());
    expected = su_stream(kConfig, sent, kOctave);
  }
  void window(size_t count, int marks) { push(su_window(kConfig, count, marks, false, rng, random_splat)); }
  Splat data(uint64_t depth) {
    Splat splat = random_splat(rng);
    splat.kind = kData;
    splat.depth = depth;
    return splat;
  }
  Splat end(uint64_t kind, uint64_t mark) {
    Splat splat = data(mark);
    splat.kind = kind;
    return splat;
  }
  std::vector<Splat> sent;
};

constexpr uint64_t kNear = 1000;
uint64_t depth_of(uint64_t bucket) { return su_bucket_range(kConfig, bucket, kOctave).first; }

TEST(SuMarks, SortsWindowsAtEveryPace) {
  std::mt19937_64 rng(test_seed());
  uint64_t overflowed = 0;
  for (int round = 0; round < 8; ++round) {
    for (const Pace source : kPaces) {
      for (const Pace sink : kPaces) {
        MarksBench bench(source, sink, rng() % 2, memory_options(rng), static_cast<int>(rng() % 4));
        const size_t most = round % 2 ? kConfig.records * 2 : kConfig.records / 2;
        for (int i = 0; i < 6; ++i)
          bench.window(rng() % std::min<size_t>(most, 700),
                       rng() % 4 ? static_cast<int>(rng() % (Config::window_marks() + 1)) : 0);
        while (bench.out.size() < bench.expected.size() && bench.cycle < 1000000) {
          if (rng() % 300 == 0) bench.dut.spill_i = rng() % 4 == 0;  // may be heeded or not
          bench.step();
        }
        bench.check(1000);
        overflowed += bench.overflowed;
        if (testing::Test::HasFailure()) return;
      }
    }
  }
  if (kConfig.records < 100) { EXPECT_GT(overflowed, 1000u) << "spilling was meant to be tested too"; }
}

TEST(SuMarks, GatingItsClockChangesNoCycle) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      std::vector<uint64_t> cycles[2];
      for (const bool gated : {false, true}) {
        MarksBench bench(source, sink, gated);
        std::mt19937_64 rng(test_seed() + 7);
        for (const size_t count : {5, 0, 30, 100})
          bench.push(su_window(kConfig, count, static_cast<int>(rng() % 9), false, rng, random_splat));
        while (bench.out.size() < bench.expected.size() && bench.cycle < 100000) {
          bench.dut.spill_i = bench.cycle / 100 % 7 == 0;
          bench.step();
        }
        bench.dut.spill_i = 0;
        bench.check(1000);
        cycles[gated] = bench.out.cycles;
      }
      ASSERT_EQ(cycles[0], cycles[1]) << "source " << to_text(source) << ", sink " << to_text(sink);
    }
  }
}

TEST(SuMarks, ReleasesRecordsBeforeTheirWindowIsComplete) {
  MarksBench bench(Pace::kAlways, Pace::kAlways, true);
  const uint64_t mark = depth_of(40) + 5;
  std::vector<Splat> beats;
  for (int i = 0; i < 6; ++i) beats.push_back(bench.data(depth_of(39 - i % 3) + i));
  for (int i = 0; i < 3; ++i) beats.push_back(bench.data(depth_of(40) + i));  // below the mark, but not their bucket
  for (int i = 0; i < 3; ++i) beats.push_back(bench.data(depth_of(41 + i)));
  beats.push_back(bench.end(kLayerEnd, mark));
  bench.push(beats);
  for (int i = 0; i < 200; ++i) bench.step();
  EXPECT_EQ(bench.out.size(), 7u) << "six records and the mark";
  bench.push({bench.data(mark), bench.end(kLayerEnd, depth_of(42))});  // the next mark releases two buckets more
  for (int i = 0; i < 200; ++i) bench.step();
  EXPECT_EQ(bench.out.size(), 7u + 3 + 1 + 1 + 1);
  bench.push({bench.end(kWindowEnd, 0)});
  bench.check(1000);
}

TEST(SuMarks, FreesSlotsOfReleasedRecordsWithinAWindow) {
  MarksBench bench(Pace::kAlways, Pace::kAlways, true);
  std::vector<Splat> beats;
  for (uint64_t bucket = 2; bucket < 30; ++bucket) {  // far more than fit together
    for (int i = 0; i < kConfig.records / 2; ++i)
      beats.push_back(bench.data(depth_of(bucket) + static_cast<uint64_t>(i)));
    beats.push_back(bench.end(kLayerEnd, depth_of(bucket + 1)));
  }
  beats.push_back(bench.end(kWindowEnd, 0));
  bench.push(beats);
  bench.check(300000);
  EXPECT_EQ(bench.overflowed, 0u);
}

TEST(SuMarks, RemembersMarksWhileItSpills) {
  for (const bool first : {false, true}) {
    MarksBench bench(Pace::kAlways, Pace::kCoin, true);
    const size_t records = kConfig.records;
    std::vector<Splat> beats;
    if (first) beats.push_back(bench.end(kLayerEnd, depth_of(3)));
    for (size_t i = 0; i < records + 5; ++i) beats.push_back(bench.data(depth_of(3 + i % 40) + i));
    for (uint64_t bucket = 3; bucket < 33; ++bucket) {
      beats.push_back(bench.end(kLayerEnd, depth_of(bucket)));
      if (bucket % 3 == 0) beats.push_back(bench.data(depth_of(bucket + bench.rng() % 5)));
    }
    beats.push_back(bench.end(kWindowEnd, 0));
    bench.push(beats);
    bench.window(records / 4, 3);
    bench.check(1000000);
    EXPECT_GT(bench.overflowed, records);
  }
}

TEST(SuMarks, SpillsInsteadOfWaitingWhenAnotherSpills) {
  for (const Others others : {Others::kWell, Others::kSpill, Others::kNow}) {
    MarksBench bench(Pace::kAlways, Pace::kAlways, others == Others::kSpill);
    const size_t records = kConfig.records;
    std::vector<Splat> beats;
    for (size_t i = 0; i < records / 2; ++i) beats.push_back(bench.data(kNear + i));
    beats.push_back(bench.end(kLayerEnd, depth_of(20)));
    for (size_t i = 0; i < 2 * records; ++i) beats.push_back(bench.data(depth_of(21 + i % 3) + i));
    beats.push_back(bench.end(kLayerEnd, depth_of(22)));
    beats.push_back(bench.end(kWindowEnd, 0));
    bench.push(beats);
    bench.blocked = true;  // the merge waits for another SU
    bench.dut.spill_i = others == Others::kSpill;
    for (size_t i = 0; i < 20 * records + 1000; ++i) bench.step();
    EXPECT_FALSE(bench.dut.spilling_o);
    if (others == Others::kSpill) {
      EXPECT_EQ(bench.in.taken, beats.size()) << "a spilling SU never blocks";
    } else {
      EXPECT_LT(bench.in.taken, records + 3 + 2);  // two wait in front
      EXPECT_EQ(bench.overflowed, 0u);
    }
    if (others == Others::kNow) {
      bench.dut.spill_i = 1;
      for (size_t i = 0; i < 20 * records + 1000; ++i) bench.step();
      EXPECT_EQ(bench.in.taken, beats.size());
    }
    bench.blocked = false;
    bench.dut.spill_i = 0;
    bench.check(1000000);
  }
}

TEST(SuMarks, TheNearestBucketIsReadyAtOnce) {
  MarksBench bench(Pace::kAlways, Pace::kAlways, true);
  std::vector<Splat> beats;
  for (int i = 0; i < kConfig.records - 1; ++i)
    beats.push_back(bench.data(depth_of(10 + i % 30) + static_cast<uint64_t>(i)));
  beats.push_back(bench.end(kWindowEnd, 0));
  bench.push(beats);
  bench.run_until_sent(1, 10000);
  uint64_t last = 2 * beats.size() - 1;  // the end is taken about then
  std::printf("%d records: first splat %d cycles after the end\n", kConfig.records - 1,
              static_cast<int>(bench.out.cycles[0] - last));
  EXPECT_LE(bench.out.cycles[0], last + 150);
  bench.check(100000);
}

}  // namespace
}  // namespace pipegs
