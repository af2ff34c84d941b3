// SPDX-License-Identifier: Apache-2.0
// su_bitonic_test: rtl/su/sort/su_bitonic.sv against cpp_model/su/sort/su_bitonic.hpp, and the network against the 0-1
// principle.
#include "cpp_model/su/sort/su_bitonic.hpp"

#include <algorithm>

#include "Vsu_bitonic.h"
#include "verif/su/su_keys.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

SortItems items_of(const std::vector<uint64_t>& keys) {
  SortItems items;
  for (size_t i = 0; i < keys.size(); ++i) items[i] = {false, keys[i], static_cast<uint32_t>(i)};
  return items;
}

TEST(SuBitonicModel, SortsEverySequenceOfZerosAndOnes) {  // then it sorts everything
  for (int count = 1; count <= kChannels; ++count) {
    for (uint32_t bits = 0; bits < 1u << count; ++bits) {
      std::vector<uint64_t> keys;
      for (int i = 0; i < count; ++i) keys.push_back(bits >> i & 1);
      SortItems items = items_of(keys);
      su_bitonic(items, count);
      std::sort(keys.begin(), keys.end());
      for (int i = 0; i < count; ++i)
        ASSERT_TRUE(!items[i].is_void && items[i].key == keys[i]) << bits << " of " << count;
    }
  }
}

struct SortBench : Bench<Vsu_bitonic>, Endpoint {
  SortBench(Pace source, Pace sink) : source(source), sink(sink) {
    add(static_cast<Endpoint&>(*this));
    dut.in_valid_i = dut.out_ready_i = 0;
  }
  void push(const std::vector<uint64_t>& keys) {
    for (size_t i = 0; i < keys.size(); ++i)
      pending.push_back({keys[i], static_cast<uint32_t>(i), i + 1 == keys.size(), false});
  }
  void push_end(uint32_t slot) { pending.push_back({rng() & 0xffffff, slot, true, true}); }
  void drive() override {
    if (!up && !pending.empty() && goes(source, rng)) up = true;
    dut.in_valid_i = up;
    dut.in_key_i = up ? pending.front().key : rng() & 0xffffff;
    dut.in_slot_i = up ? pending.front().slot : 0;
    dut.in_last_i = up ? pending.front().last : rng() & 1;
    dut.in_end_i = up ? pending.front().end : 0;
    dut.out_ready_i = goes(sink, rng);
  }
  void observe() override {
    if (up && dut.in_ready_o) {
      pending.pop_front();
      up = false;
      loads.push_back(cycle);
      EXPECT_TRUE(dut.active_o);
    }
    if (dut.out_valid_o && dut.out_ready_i) {
      sent.push_back({false, dut.out_key_o, dut.out_slot_o});
      ends.push_back(dut.out_end_o);
      sends.push_back(cycle);
      EXPECT_TRUE(dut.active_o);
    }
  }
  struct Beat {
    uint64_t key;
    uint32_t slot;
    bool last, end;
  };
  Pace source, sink;
  std::deque<Beat> pending;
  std::vector<SortItem> sent;
  std::vector<bool> ends;
  std::vector<uint64_t> loads, sends;
  bool up = false;
};

TEST(SuBitonic, EqualsTheNetworkForEveryCountAndArrangement) {
  const Config config = test_config();
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      SortBench bench(source, sink);
      bench.reset();
      std::vector<SortItem> expected;
      std::vector<bool> ends;
      for (const Arrangement arrangement : kArrangements) {
        for (int count = 1; count <= kChannels; ++count) {
          const std::vector<uint64_t> keys = su_keys(config, arrangement, count, bench.rng);
          bench.push(keys);
          SortItems items = items_of(keys);
          su_bitonic(items, count);
          expected.insert(expected.end(), items.begin(), items.begin() + count);
          ends.resize(expected.size(), false);
          for (uint64_t n = bench.rng() % 4; n > 1; --n) {  // an end or two between the batches
            bench.push_end(static_cast<uint32_t>(bench.rng() % 4));
            expected.push_back({false, 0, bench.pending.back().slot});
            ends.push_back(true);
          }
        }
      }
      bench.run_until([&] { return bench.sent.size() == expected.size(); });
      for (size_t i = 0; i < bench.sent.size(); ++i) {
        ASSERT_EQ(bench.ends[i], ends[i]) << "key " << i;
        if (!ends[i]) { ASSERT_EQ(bench.sent[i].key, expected[i].key) << "key " << i; }
        ASSERT_EQ(bench.sent[i].slot, expected[i].slot) << "key " << i;
      }
      EXPECT_TRUE(bench.dut.idle_o);
    }
  }
}

TEST(SuBitonic, SortsInOneCyclePerStageAndLoadsWhileSending) {
  const Config config = test_config();
  for (const auto& [keys, stages] : {std::pair{1, 0}, {2, 1}, {4, 3}, {8, 6}, {16, 10}}) {
    const int count = keys;
    SortBench bench(Pace::kAlways, Pace::kAlways);
    bench.reset();
    for (int batch = 0; batch < 20; ++batch) bench.push(su_keys(config, Arrangement::kRandom, count, bench.rng));
    bench.run_until([&] { return bench.sends.size() == static_cast<size_t>(20 * count); });
    SortItems items = items_of(su_keys(config, Arrangement::kRandom, count, bench.rng));
    EXPECT_EQ(su_bitonic(items, count), stages);
    EXPECT_EQ(bench.sends.front() - bench.loads[count - 1], static_cast<uint64_t>(stages + 2));
    const double period =
        (bench.sends.back() - bench.sends[count - 1]) / 19.0;  // load, start, stages; sending is hidden
    EXPECT_LE(period, count + stages + 2) << count << " keys";
    RecordProperty("cycles_for_" + std::to_string(count), std::to_string(period));
  }
}

}  // namespace
}  // namespace pipegs
