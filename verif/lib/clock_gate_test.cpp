// clock_gate_test: rtl/lib/clock_gate.sv: an enable of the low phase passes the next edge, whole and without glitches.
#include "verif/support/bench.hpp"
#include "Vclock_gate.h"

namespace pipegs {
namespace {

TEST(ClockGate, PassesExactlyTheEdgesWhoseLowPhaseWasEnabled) {
  Bench<Vclock_gate> bench;
  bench.dut.rst_ni = 1;
  for (int i = 0; i < 1000; ++i) {
    const bool enable = bench.rng() % 2;
    bench.dut.clk_i = 0;
    bench.dut.enable_i = enable;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.clk_o, 0);
    bench.dut.clk_i = 1;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.clk_o, enable) << "cycle " << i;
    bench.dut.enable_i = !enable;  // a change while the clock is high must not pass
    bench.dut.eval();
    ASSERT_EQ(bench.dut.clk_o, enable) << "glitch in cycle " << i;
  }
}

TEST(ClockGate, PassesEveryEdgeInReset) {
  Bench<Vclock_gate> bench;
  bench.dut.rst_ni = 0;
  bench.dut.enable_i = 0;
  for (int i = 0; i < 10; ++i) {
    bench.dut.clk_i = 0;
    bench.dut.eval();
    bench.dut.clk_i = 1;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.clk_o, 1);
  }
}

}  // namespace
}  // namespace pipegs
