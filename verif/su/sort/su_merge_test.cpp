// SPDX-License-Identifier: Apache-2.0
// su_merge_test: rtl/su/sort/su_merge.sv against std::sort of all lanes together. Without IndexTies no two splats of a
// layer have one depth, or an assertion says so.
#include <algorithm>
#include <set>

#include "Vsu_merge.h"
#include "cpp_model/su/su.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();

// All lanes' sources, and the sink.
struct MergeBench : Bench<Vsu_merge>, Endpoint {
  MergeBench(Pace source, Pace sink)
      : source(source),
        lanes(kConfig.units),
        up(kConfig.units),
        out(*this, kConfig, dut.out_valid_o, dut.out_ready_i, dut.out_o, sink) {
    add(static_cast<Endpoint&>(*this));
    dut.in_valid_i = 0;
  }
  void drive() override {
    Words words(port_words<decltype(dut.in_i)>() + 8);
    unsigned valid = 0;
    for (int k = 0; k < kConfig.units; ++k) {
      if (!up[k] && !lanes[k].empty() && goes(source, rng)) up[k] = true;
      if (!up[k]) continue;
      valid |= 1u << k;
      Words beat(record_words<Splat>(kConfig) + 1);
      pack(kConfig, lanes[k].front(), beat.data());
      const int width = record_width<Splat>(kConfig);
      for (int at = 0; at < width; at += 32) {
        const int part = std::min(32, width - at);
        put_bits(words.data(), k * width + at, part, get_bits(beat.data(), at, part));
      }
    }
    dut.in_valid_i = valid;
    write_port(dut.in_i, words.data());
  }
  void observe() override {
    for (int k = 0; k < kConfig.units; ++k) {
      if (up[k] && (dut.in_ready_o >> k & 1)) {
        lanes[k].pop_front();
        up[k] = false;
        EXPECT_TRUE(dut.active_o);
      }
    }
  }
  // One layer with this many splats in each lane; returns what shall come out.
  std::vector<Sorted> layer(const std::vector<size_t>& counts, uint64_t kind, uint64_t depths) {
    std::vector<Sorted> expected;
    std::set<uint64_t> taken;
    for (int k = 0; k < kConfig.units; ++k) {
      std::vector<Splat> splats;
      for (size_t i = 0; i < counts[k]; ++i) {
        Splat splat = random_record<Splat>(kConfig, rng);
        splat.kind = kData;
        splat.depth %= depths;
        if (!kConfig.index_ties && !taken.insert(splat.depth).second) continue;
        splat.index = (next_index += 1 + rng() % 7) % (uint64_t{1} << kConfig.index_w);
        splats.push_back(splat);
      }
      su_sort(splats);
      for (const Splat& s : splats) {
        lanes[k].push_back(s);
        expected.push_back(su_sorted(kConfig, s, static_cast<uint64_t>(k)));
      }
      Splat end;
      end.kind = kind;
      lanes[k].push_back(end);
    }
    std::sort(expected.begin(), expected.end(), [](const Sorted& a, const Sorted& b) {
      return a.depth != b.depth ? a.depth < b.depth : a.index < b.index;
    });
    if (kConfig.has_watermarks() && kind != kWindowEnd) return expected;  // a watermark, an end of a part stay
    expected.push_back({});
    expected.back().kind = kind;
    return expected;
  }
  Pace source;
  std::vector<std::deque<Splat>> lanes;
  std::vector<bool> up;
  uint64_t next_index = 0;
  RecordSink<Sorted, decltype(dut.out_o)> out;
};

TEST(SuMerge, MergesByDepthThenIndexAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      MergeBench bench(source, sink);
      bench.reset();
      std::vector<Sorted> expected;
      for (int n = 0; n < 60; ++n) {
        std::vector<size_t> counts;
        for (int k = 0; k < kConfig.units; ++k) counts.push_back(bench.rng() % 3 == 0 ? 0 : bench.rng() % 20);
        const uint64_t depths = bench.rng() % 2 ? 1 + bench.rng() % 4 : uint64_t{1} << kConfig.depth_w;
        const uint64_t kind = n % 3 == 2 ? kWindowEnd : n % 3 == 1 && kConfig.has_watermarks() ? kPartEnd : kLayerEnd;
        for (const Sorted& s : bench.layer(counts, kind, depths)) expected.push_back(s);
      }
      bench.run_until([&] { return bench.out.size() == expected.size(); });
      for (size_t i = 0; i < bench.out.size(); ++i) {
        if (expected[i].kind != kData) {  // an end's other fields mean nothing
          ASSERT_EQ(bench.out.at(i).kind, expected[i].kind) << "beat " << i;
        } else {
          ASSERT_EQ(first_difference(kConfig, expected[i], bench.out.at(i)), "") << "beat " << i;
        }
      }
    }
  }
}

TEST(SuMerge, SendsOneBeatPerCycle) {
  MergeBench bench(Pace::kAlways, Pace::kAlways);
  bench.reset();
  const size_t beats =
      bench.layer(std::vector<size_t>(kConfig.units, 100), kLayerEnd, uint64_t{1} << kConfig.depth_w).size();
  bench.run_until([&] { return bench.out.size() == beats; });
  EXPECT_EQ(bench.out.cycles.back() - bench.out.cycles.front(), beats - 1);
}

// Two of one depth, in one lane or in two.
TEST(SuMerge, SaysSoWhenTwoSplatsAreOfOneDepth) {
  if (kConfig.index_ties) GTEST_SKIP() << "equal depths are ordered by index";
  for (const size_t lane : {0, 1}) {
    MergeBench bench(Pace::kAlways, Pace::kAlways);
    bench.reset();
    for (const uint64_t depth : {5, 7}) bench.lanes[0].push_back({.depth = depth, .index = depth});
    bench.lanes[lane].push_back({.depth = 7, .index = 8});
    for (auto& splats : bench.lanes) splats.push_back({.kind = kLayerEnd});
    EXPECT_THROW(bench.run_until([&] { return bench.out.size() == 4; }), std::runtime_error) << "lane " << lane;
  }
}

}  // namespace
}  // namespace pipegs
