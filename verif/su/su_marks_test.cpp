// SPDX-License-Identifier: Apache-2.0
// su_marks_test: rtl/su/pipegs_su.sv against cpp_model/su/su.hpp when a layer's end is a watermark (order=2).
#include "verif/su/su_bench.hpp"
#include "verif/su/su_windows.hpp"

namespace pipegs {
namespace {

Splat random_splat(std::mt19937_64& rng) { return random_record<Splat>(kConfig, rng); }

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
        bench.check(1000000);
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
        for (const size_t count : {5, 0, 30, 100, kConfig.records + 30})
          bench.push(su_window(kConfig, count, static_cast<int>(rng() % 9), false, rng, random_splat));
        bench.check(1000000);
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

// Records that come without a pause hold up no bucket that a mark released: each goes after one of them.
TEST(SuMarks, ReleasesBucketsWhileRecordsCome) {
  if (kConfig.records < 100) return;  // a smaller pool is full before
  MarksBench bench(Pace::kAlways, Pace::kAlways, true);
  std::vector<Splat> beats;
  for (uint64_t bucket = 2; bucket < 22; ++bucket) beats.push_back(bench.data(depth_of(bucket)));
  beats.push_back(bench.end(kLayerEnd, depth_of(22)));
  for (int i = 0; i < kConfig.records - 30; ++i) beats.push_back(bench.data(depth_of(23) + static_cast<uint64_t>(i)));
  bench.push(beats);
  bench.run_until_sent(21, 10000);
  std::printf("%d records came meanwhile\n", static_cast<int>(bench.in.taken) - 21);
  EXPECT_LE(bench.in.taken, 21u + 60);
  bench.push({bench.end(kWindowEnd, 0)});
  bench.check(100000);
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

// A bucket holds more than the pool: the mark behind it ends the spill. What is left returns to the pool, and what
// comes later stays in it, or it goes on in memory if it is more than half a pool.
TEST(SuMarks, ASpillEndsWithTheNextMark) {
  const auto records = static_cast<uint64_t>(kConfig.records);
  for (const uint64_t left : {uint64_t{0}, uint64_t{1}, records / 2, records / 2 + 1, 3 * records}) {
    MarksBench bench(Pace::kAlways, Pace::kAlways, left % 2 == 0);
    std::vector<Splat> beats;
    for (uint64_t i = 0; i < left; ++i) beats.push_back(bench.data(depth_of(9 + i % 2) + i));
    for (uint64_t i = 0; i < records + 5; ++i) beats.push_back(bench.data(depth_of(4) + i));
    beats.push_back(bench.end(kLayerEnd, depth_of(8)));
    bench.push(beats);
    bench.run_until_sent(records + 5, 100 * records + 10000);
    bench.blocked = true;  // the mark waits for the merge, and what is left for the mark
    for (uint64_t i = 0; i < 60 * records + 5000; ++i) bench.step();
    bench.blocked = false;
    for (uint64_t i = 0; i < 60 * records + 5000; ++i) bench.step();
    EXPECT_EQ(bench.out.size(), records + 5 + 1) << left << " are left";
    const bool stays = left > records / 2;
    EXPECT_EQ(bench.dut.spilling_o, stays) << left << " are left";
    const uint64_t before = bench.overflowed;
    beats.clear();
    for (uint64_t i = 0; i < records / 2; ++i) beats.push_back(bench.data(depth_of(11) + i));
    beats.push_back(bench.end(kLayerEnd, depth_of(10)));
    bench.push(beats);
    bench.run_until_sent(bench.out.size() + (left + 1) / 2 + 1, 100 * (records + left) + 10000);
    EXPECT_EQ(bench.overflowed > before, stays) << left << " are left";
    bench.push({bench.end(kWindowEnd, 0)});
    bench.window(records / 2, 5);
    bench.check(1000000);
  }
}

// Whatever the marks do, twice as many records are written at most, and a mark reads the list once. Rounds of two
// buckets each: all come before the first mark, or most is left in memory at each mark, or half a pool returns.
enum class Rounds { kAtOnce, kStay, kReturn };

TEST(SuMarks, WritesAtMostTwiceAsManyRecordsAsCome) {
  const auto records = static_cast<uint64_t>(kConfig.records), last = records > 100 ? uint64_t{10} : uint64_t{26};
  for (const Rounds rounds : {Rounds::kAtOnce, Rounds::kStay, Rounds::kReturn}) {
    MarksBench bench(Pace::kAlways, Pace::kAlways, true);
    uint64_t count = 0;
    std::vector<Splat> beats;
    const auto add = [&](uint64_t bucket) {
      const uint64_t here = rounds == Rounds::kAtOnce ? records / 4 + 3 : records - 1;
      for (uint64_t i = 0; i < here; ++i, ++count) beats.push_back(bench.data(depth_of(bucket + i % 2) + i));
    };
    for (uint64_t bucket = 2; rounds == Rounds::kAtOnce && bucket < last; ++bucket) add(bucket);
    for (uint64_t bucket = 2; bucket < last; ++bucket) {
      if (rounds != Rounds::kAtOnce) add(bucket);
      beats.push_back(bench.end(kLayerEnd, depth_of(bucket + (rounds == Rounds::kReturn ? 1 : 0))));
    }
    beats.push_back(bench.end(kWindowEnd, 0));
    bench.push(beats);
    bench.check(10000000);
    std::printf("%d records: %d lines written, %d read\n", static_cast<int>(count), static_cast<int>(bench.overflowed),
                static_cast<int>(bench.fetched));
    EXPECT_GT(bench.overflowed, count);
    EXPECT_LE(bench.overflowed, (rounds == Rounds::kReturn ? 2 : 1) * (count + count / 8 + 24) + count / 4 + 24);
    EXPECT_LE(bench.fetched, 2 * count + count / 4 + last * (count / 8 + 1));
  }
}

TEST(SuMarks, WaitsWhenWhatItReleasedIsBlocked) {
  MarksBench bench(Pace::kAlways, Pace::kAlways, true);
  const size_t records = kConfig.records;
  std::vector<Splat> beats;
  for (size_t i = 0; i < records / 2; ++i) beats.push_back(bench.data(kNear + i));
  beats.push_back(bench.end(kLayerEnd, depth_of(20)));
  for (size_t i = 0; i < 2 * records; ++i) beats.push_back(bench.data(depth_of(21 + i % 3) + i));
  beats.push_back(bench.end(kLayerEnd, depth_of(22)));
  beats.push_back(bench.end(kWindowEnd, 0));
  bench.push(beats);
  bench.blocked = true;  // the merge waits for another SU
  for (size_t i = 0; i < 20 * records + 1000; ++i) bench.step();
  EXPECT_LT(bench.in.taken, records + 3 + 4);  // two wait in front, two behind
  EXPECT_EQ(bench.overflowed, 0u);
  bench.blocked = false;
  bench.check(1000000);
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
