// sram_fifo_test: rtl/buf/sram_fifo.sv against std::queue.
#include "verif/support/bench.hpp"
#include "Vsram_fifo.h"

namespace pipegs {
namespace {

constexpr uint32_t kDepth = 16;  // the module's default

TEST(SramFifo, KeepsEveryWordInOrderAtEveryPace) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Bench<Vsram_fifo> bench;
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

TEST(SramFifo, HoldsDepthWordsAndCountsThem) {
  Bench<Vsram_fifo> bench;
  WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  bench.dut.out_ready_i = 0;
  bench.reset();
  for (uint32_t i = 0; i < kDepth + 3; ++i) in.push({i});
  for (int i = 0; i < 40; ++i) bench.step();
  EXPECT_EQ(in.taken, kDepth);
  EXPECT_EQ(bench.dut.count_o, kDepth);
  EXPECT_EQ(bench.dut.in_ready_o, 0);
}

TEST(SramFifo, MovesOneWordPerCycle) {
  Bench<Vsram_fifo> bench;
  WordSource in(bench, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i);
  WordSink out(bench, bench.dut.out_valid_o, bench.dut.out_ready_i, bench.dut.out_o);
  bench.reset();
  for (uint32_t i = 0; i < 100; ++i) in.push({i});
  bench.run_until([&] { return out.beats.size() == 100; });
  EXPECT_EQ(out.cycles.back() - out.cycles.front(), 99u);
}

}  // namespace
}  // namespace pipegs
