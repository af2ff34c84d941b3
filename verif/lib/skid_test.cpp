// SPDX-License-Identifier: Apache-2.0
// skid_test: rtl/lib/pipegs_skid.sv against std::queue.
#include "verif/support/bench.hpp"
#include "Vpipegs_skid.h"

namespace pipegs {
namespace {

TEST(Skid, KeepsEveryWordInOrderAtEveryPace) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Bench<Vpipegs_skid> bench;
      WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i, source_pace);
      WordSink out(bench, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o, sink_pace);
      bench.reset();
      for (uint32_t i = 0; i < 500; ++i) in.push({i * 2654435761u});
      bench.run_until([&] { return out.beats.size() == 500; });
      for (uint32_t i = 0; i < out.beats.size(); ++i) ASSERT_EQ(out.beats[i][0], i * 2654435761u) << "beat " << i;
    }
  }
}

TEST(Skid, MovesOneWordPerCycleWithOneCycleOfLatency) {
  Bench<Vpipegs_skid> bench;
  WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  WordSink out(bench, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o);
  bench.reset();
  const uint64_t start = bench.cycle;
  for (uint32_t i = 0; i < 100; ++i) in.push({i});
  bench.run_until([&] { return out.beats.size() == 100; });
  EXPECT_EQ(out.cycles.front(), start + 1);
  EXPECT_EQ(out.cycles.back() - out.cycles.front(), 99u);
}

}  // namespace
}  // namespace pipegs
