// SPDX-License-Identifier: Apache-2.0
// su_lean_test: rtl/su/pipegs_su.sv without what a scene may not call for: ties by index, overflow to memory, chains of
// more than sixteen keys. Against cpp_model/su/su.hpp; where something is called for all the same, an assertion says
// so.
#include <map>
#include <set>

#include "verif/su/su_bench.hpp"

namespace pipegs {
namespace {

// A layer of `count` splats, no two of one depth, at most `crowd` in a bucket.
void layer(SuBench& bench, size_t count, size_t crowd, uint64_t kind) {
  std::vector<Splat> splats;
  std::set<uint64_t> depths;
  std::map<uint64_t, size_t> buckets;
  while (splats.size() < count) {
    Splat splat = random_record<Splat>(kConfig, bench.rng);
    splat.kind = kData;
    size_t& held = buckets[su_bucket(kConfig, splat.depth, kOctave)];
    if (held == crowd || !depths.insert(splat.depth).second) continue;
    ++held;
    splats.push_back(splat);
    bench.in.push(splat);
  }
  su_sort(splats);
  bench.expected.insert(bench.expected.end(), splats.begin(), splats.end());
  Splat end;
  end.kind = kind;
  bench.in.push(end);
  bench.expected.push_back(end);
}

TEST(SuLean, SortsByDepthAloneAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      SuBench bench(source, sink, true);
      for (const size_t count : {0, 1, 2, 15, 16, 17, 100, 500, 3, 0})
        layer(bench, count, 16, bench.rng() % 3 ? kLayerEnd : kWindowEnd);
      bench.check(100000);
      EXPECT_EQ(bench.overflowed, 0u);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(SuLean, SaysSoWhenARecordFindsNoRoom) {
  SuBench bench(Pace::kAlways, Pace::kAlways, true);
  const auto push = [&](int depth) {
    Splat splat = random_record<Splat>(kConfig, bench.rng);
    splat.kind = kData, splat.depth = static_cast<uint64_t>(depth) << (kConfig.depth_w - kConfig.bucket_w());
    bench.in.push(splat);
  };
  for (int i = 0; i < kConfig.records; ++i) push(i % 64);
  for (int i = 0; i < 4 * kConfig.records; ++i) bench.step();
  const uint64_t before = bench.asleep;
  bench.step();
  ASSERT_EQ(bench.asleep, before + 1) << "the unit has no other reason for a clock";
  push(0);
  EXPECT_THROW(bench.run_until_sent(1, 100), std::runtime_error);
}

TEST(SuLean, SaysSoWhenABucketHoldsMoreThanSixteen) {
  SuBench bench(Pace::kAlways, Pace::kAlways, true);
  uint64_t depth = uint64_t{5} << (kConfig.depth_w - kConfig.bucket_w());
  for (int i = 0; i < 17; ++i) {
    Splat splat = random_record<Splat>(kConfig, bench.rng);
    splat.kind = kData, splat.depth = depth++;
    bench.in.push(splat);
  }
  bench.in.push({.kind = kLayerEnd});
  EXPECT_THROW(bench.run_until_sent(18, 20000), std::runtime_error);
}

}  // namespace
}  // namespace pipegs
