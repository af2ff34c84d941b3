// SPDX-License-Identifier: Apache-2.0
// fifo_test: rtl/lib/pipegs_fifo.sv and rtl/buf/pipegs_sram_fifo.sv against std::queue. PIPEGS_SRAM says which one.
#include "verif/support/bench.hpp"
#ifdef PIPEGS_SRAM
#include "Vpipegs_sram_fifo.h"
#else
#include "Vpipegs_fifo.h"
#endif

namespace pipegs {
namespace {

// What tells them apart: the module's default depth, and when a word put in shows.
#ifdef PIPEGS_SRAM
using Queue = Vpipegs_sram_fifo;
constexpr uint32_t kDepth = 16;
constexpr uint64_t kLatency = 2;
#else
using Queue = Vpipegs_fifo;
constexpr uint32_t kDepth = 4;
constexpr uint64_t kLatency = 1;
#endif

TEST(Fifo, KeepsEveryWordInOrderAtEveryPace) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Bench<Queue> bench;
      WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i, source_pace);
      WordSink out(bench, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o, sink_pace);
      bench.reset();
      std::vector<Words> sent;
      for (int i = 0; i < 500; ++i) {
        sent.push_back({static_cast<uint32_t>(bench.rng())});
        in.push(sent.back());
      }
      bench.run_until([&] { return out.beats.size() == sent.size(); });
      for (size_t i = 0; i < out.beats.size(); ++i) ASSERT_EQ(out.beats[i][0], sent[i][0]) << "beat " << i;
    }
  }
}

TEST(Fifo, HoldsDepthWordsAndCountsThem) {
  Bench<Queue> bench;
  WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  bench.dut.out_ready_i = 0;
  bench.reset();
  for (uint32_t i = 0; i < kDepth + 3; ++i) in.push({i});
  for (int i = 0; i < 40; ++i) bench.step();
  EXPECT_EQ(in.taken, kDepth);
  EXPECT_EQ(bench.dut.count_o, kDepth);
  EXPECT_EQ(bench.dut.in_ready_o, 0);
}

TEST(Fifo, MovesOneWordPerCycle) {
  Bench<Queue> bench;
  WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  WordSink out(bench, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o);
  bench.reset();
  for (uint32_t i = 0; i < 100; ++i) in.push({i});
  bench.run_until([&] { return out.beats.size() == 100; });
  EXPECT_EQ(out.cycles.back() - out.cycles.front(), 99u);
}

TEST(Fifo, AWordShowsAsSoonAsItsHeadSays) {
  Bench<Queue> bench;
  bench.dut.in_valid_i = 0;
  bench.dut.out_ready_i = 0;
  bench.reset();
  bench.dut.in_valid_i = 1;
  bench.dut.in_i = 7;
  bench.step();
  bench.dut.in_valid_i = 0;
  uint64_t waited = 1;
  for (bench.dut.eval(); !bench.dut.out_valid_o && waited < 9; ++waited) bench.step();
  EXPECT_EQ(waited, kLatency);
  EXPECT_EQ(bench.dut.out_o, 7u);
}

}  // namespace
}  // namespace pipegs
