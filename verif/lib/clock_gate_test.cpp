// SPDX-License-Identifier: Apache-2.0
// clock_gate_test: rtl/lib/pipegs_clock_gate.sv: an enable of the low phase passes the next edge, whole and without
// glitches.
#include "verif/support/bench.hpp"
#include "Vpipegs_clock_gate.h"

namespace pipegs {
namespace {

TEST(ClockGate, PassesExactlyTheEdgesWhoseLowPhaseWasEnabled) {
  Bench<Vpipegs_clock_gate> bench;
  bench.dut.rst_ni = 1;
  bench.dut.scan_en_i = 0;
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

void expect_every_edge(bool reset, bool test) {
  Bench<Vpipegs_clock_gate> bench;
  bench.dut.rst_ni = !reset;
  bench.dut.scan_en_i = test;
  bench.dut.enable_i = 0;
  for (int i = 0; i < 10; ++i) {
    bench.dut.clk_i = 0;
    bench.dut.eval();
    bench.dut.clk_i = 1;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.clk_o, 1);
  }
}

TEST(ClockGate, PassesEveryEdgeInReset) { expect_every_edge(true, false); }

TEST(ClockGate, PassesEveryEdgeInTest) { expect_every_edge(false, true); }

}  // namespace
}  // namespace pipegs
