// SPDX-License-Identifier: Apache-2.0
// su_split_test: rtl/su/sort/su_split.sv against cpp_model/su/sort/su_split.hpp: the same groups, in the same order.
#include "cpp_model/su/sort/su_split.hpp"

#include <algorithm>
#include <numeric>

#include "Vsu_split.h"
#include "verif/su/su_keys.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();

// The splitter with a store of keys and one of links beside it.
struct SplitBench : Bench<Vsu_split>, Endpoint {
  explicit SplitBench(Pace sink) : sink(sink) {
    add(static_cast<Endpoint&>(*this));
    dut.start_i = dut.out_ready_i = 0;
  }
  void drive() override {
    dut.out_ready_i = goes(sink, rng);
    dut.key_i = shown;
    dut.link_i = shown_link;
  }
  void observe() override {
    if (dut.out_valid_o && dut.out_ready_i) {
      EXPECT_EQ(dut.out_key_o, keys.at(dut.out_slot_o));
      if (fresh) groups.emplace_back();
      groups.back().push_back(place.at(dut.out_slot_o));
      fresh = dut.out_last_o;
      EXPECT_TRUE(dut.active_o);
    }
    if (dut.key_read_o) {
      shown = keys.at(dut.key_slot_o);
      shown_link = links.at(dut.key_slot_o);
    }
    if (dut.link_write_o) links.at(dut.link_slot_o) = dut.link_o;
  }
  // Returns the cycles it took. The keys are a chain in the order of `set`, in any slots; `groups` names them by their
  // place in the set.
  uint64_t split(const std::vector<uint64_t>& set, const KeyRange& range) {
    slots.resize(kConfig.records);
    std::iota(slots.begin(), slots.end(), 0u);
    std::shuffle(slots.begin(), slots.end(), rng);
    keys.assign(kConfig.records, 0);
    links.assign(kConfig.records, 0);
    place.assign(kConfig.records, 0);
    for (size_t i = 0; i < set.size(); ++i) {
      keys[slots[i]] = set[i];
      place[slots[i]] = static_cast<uint32_t>(i);
      links[slots[i]] = i + 1 < set.size() ? slots[i + 1] : static_cast<uint32_t>(rng() % kConfig.records);
    }
    groups.clear();
    fresh = true;
    dut.start_i = 1;
    dut.head_i = slots[0];
    dut.count_i = set.size();
    dut.min_i = range.min;
    dut.max_i = range.max;
    const uint64_t begin = cycle;
    step();
    dut.start_i = 0;
    dut.min_i = dut.max_i = dut.count_i = dut.head_i = 0;
    run_until([&] { return dut.idle_o; }, 200 * set.size() + 1000);
    return cycle - begin;
  }
  uint64_t split(const std::vector<uint64_t>& set) { return split(set, su_minmax(set)); }
  Pace sink;
  std::vector<uint64_t> keys;
  std::vector<std::vector<uint32_t>> groups;
  std::vector<uint32_t> slots, links, place;
  uint64_t shown = 0, shown_link = 0;
  bool fresh = true;
};

TEST(SuSplitModel, GroupsAreSmallInOrderAndComplete) {
  std::mt19937_64 rng(test_seed());
  for (const Arrangement arrangement : kArrangements) {
    for (const size_t count : {1, 2, 15, 16, 17, 100, 512, 5000}) {
      const std::vector<uint64_t> keys = su_keys(kConfig, arrangement, count, rng);
      SplitStats stats;
      uint64_t above = 0;
      size_t total = 0;
      for (const std::vector<uint32_t>& group : su_split(keys, su_minmax(keys), &stats)) {
        ASSERT_GE(group.size(), 1u);
        ASSERT_LE(group.size(), 16u);
        uint64_t near = ~uint64_t{0}, far = 0;
        for (const uint32_t slot : group) near = std::min(near, keys[slot]), far = std::max(far, keys[slot]);
        ASSERT_TRUE(total == 0 || near > above) << to_text(arrangement) << " " << count;
        above = far;
        total += group.size();
      }
      EXPECT_EQ(total, count);
      EXPECT_LE(stats.visits, 14 * count) << to_text(arrangement) << " " << count;
    }
  }
}

TEST(SuSplit, EqualsItsModelForEveryArrangementAndPace) {
  const size_t most = kConfig.records;
  for (const Pace sink : kPaces) {
    SplitBench bench(sink);
    bench.reset();
    for (const Arrangement arrangement : kArrangements) {
      for (const size_t count : {size_t{1}, size_t{2}, size_t{15}, size_t{16}, size_t{17}, size_t{33}, size_t{100},
                                 most / 2, most - 1, most}) {
        const std::vector<uint64_t> keys = su_keys(kConfig, arrangement, count, bench.rng);
        bench.split(keys);
        ASSERT_EQ(bench.groups, su_split(keys, su_minmax(keys)))
            << to_text(arrangement) << ", " << count << " keys, sink " << to_text(sink);
      }
    }
  }
}

// The keys of one bucket of depth: the range is that of the bucket.
TEST(SuSplit, TakesARangeThatIsWiderThanTheKeys) {
  SplitBench bench(Pace::kAlways);
  bench.reset();
  const uint64_t width = uint64_t{1} << (kConfig.key_w() - kConfig.bucket_w());
  for (const size_t count : {16, 17, 100, kConfig.records}) {
    for (const uint64_t spread : {width, uint64_t{1} << 12, uint64_t{count}}) {  // of the keys
      std::set<uint64_t> seen;
      const KeyRange range{5 * width, 6 * width - 1};
      while (seen.size() < count) seen.insert(range.max - bench.rng() % spread);
      std::vector<uint64_t> keys(seen.begin(), seen.end());
      std::shuffle(keys.begin(), keys.end(), bench.rng);
      bench.split(keys, range);
      ASSERT_EQ(bench.groups, su_split(keys, range)) << count << " keys";
    }
  }
}

TEST(SuSplit, SendsAChainOfSixteenAtOnce) {
  SplitBench bench(Pace::kAlways);
  bench.reset();
  EXPECT_EQ(bench.split(su_keys(kConfig, Arrangement::kRandom, 16, bench.rng)), 16u + 2u);
}

TEST(SuSplit, TakesOneCyclePerKeyAndPass) {
  SplitBench bench(Pace::kAlways);
  bench.reset();
  for (const size_t count : {16, 90, 350, 512}) {
    uint64_t cycles = 0, bound = 0;
    for (int i = 0; i < 20; ++i) {
      const std::vector<uint64_t> keys = su_keys(kConfig, Arrangement::kRandom, count, bench.rng);
      cycles += bench.split(keys);
      SplitStats stats;
      const size_t groups = su_split(keys, su_minmax(keys), &stats).size();
      bound += stats.visits + 21 * stats.passes + count + 2 * groups + 3;
    }
    EXPECT_LE(cycles, bound) << count << " keys";
    std::printf("%zu keys: %.2f cycles per key in the splitter alone\n", count, cycles / 20.0 / count);
  }
}

}  // namespace
}  // namespace pipegs
