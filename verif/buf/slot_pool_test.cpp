// SPDX-License-Identifier: Apache-2.0
// slot_pool_test: rtl/buf/pipegs_slot_pool.sv against the set of slots in use.
#include <set>

#include "verif/support/bench.hpp"
#include "Vpipegs_slot_pool.h"

namespace pipegs {
namespace {

constexpr size_t kSlots = 16;  // the module's default

// One slot out and one back in a cycle, each with some probability in quarters.
void takes_and_gives_back(Bench<Vpipegs_slot_pool>& bench, std::set<uint32_t>& used, int take, int give, int cycles) {
  for (int i = 0; i < cycles; ++i) {
    bench.dut.slot_ready_i = static_cast<int>(bench.rng() % 4) < take;
    bench.dut.free_i = !used.empty() && static_cast<int>(bench.rng() % 4) < give;
    if (bench.dut.free_i) {
      auto slot = used.begin();
      std::advance(slot, bench.rng() % used.size());
      bench.dut.free_slot_i = static_cast<CData>(*slot);
    }
    bench.dut.clk_i = 0;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.used_o, used.size()) << "cycle " << i;
    const bool taken = bench.dut.slot_valid_o && bench.dut.slot_ready_i;
    if (taken) { ASSERT_TRUE(used.insert(bench.dut.slot_o).second) << "slot " << int(bench.dut.slot_o); }
    if (bench.dut.free_i) used.erase(bench.dut.free_slot_i);
    ASSERT_TRUE(bench.dut.active_o || !(taken || bench.dut.free_i)) << "cycle " << i;
    bench.dut.clk_i = 1;
    bench.dut.eval();
  }
}

TEST(SlotPool, HandsEverySlotOutOnceAndAgainWhenItCameBack) {
  Bench<Vpipegs_slot_pool> bench;
  bench.dut.slot_ready_i = 0;
  bench.dut.free_i = 0;
  bench.reset();
  std::set<uint32_t> used;
  takes_and_gives_back(bench, used, 2, 4, 16);  // some come back while there are slots that nobody ever had
  for (int round = 0; round < 50; ++round) {
    takes_and_gives_back(bench, used, 4, 0, 40);  // until none is left
    EXPECT_EQ(used.size(), kSlots);
    takes_and_gives_back(bench, used, 2, 2, 200);
    takes_and_gives_back(bench, used, 1, 4, 100);
  }
}

TEST(SlotPool, ASlotIsFreeAgainTwoCyclesAfterItCameBack) {
  Bench<Vpipegs_slot_pool> bench;
  bench.dut.slot_ready_i = 1;
  bench.dut.free_i = 0;
  bench.reset();
  for (size_t i = 0; i < kSlots; ++i) bench.step();
  bench.dut.free_i = 1;
  bench.dut.free_slot_i = 5;
  bench.step();
  bench.dut.free_i = 0;
  bench.dut.slot_ready_i = 0;
  EXPECT_EQ(bench.dut.slot_valid_o, 0);
  bench.step();
  bench.dut.eval();
  EXPECT_EQ(bench.dut.slot_valid_o, 1);
  EXPECT_EQ(bench.dut.slot_o, 5);
}

}  // namespace
}  // namespace pipegs
