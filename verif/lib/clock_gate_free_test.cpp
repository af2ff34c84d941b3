// SPDX-License-Identifier: Apache-2.0
// clock_gate_free_test: rtl/lib/pipegs_clock_gate.sv with ClockGates = 0: the clock passes as it is, whatever else
// there is.
#include "Vpipegs_clock_gate.h"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

TEST(ClockGateFree, PassesTheClockAsItIs) {
  Bench<Vpipegs_clock_gate> bench;
  for (int i = 0; i < 1000; ++i) {
    const uint64_t inputs = bench.rng();
    bench.dut.rst_ni = inputs & 1;
    bench.dut.scan_en_i = inputs >> 1 & 1;
    bench.dut.enable_i = inputs >> 2 & 1;
    bench.dut.clk_i = inputs >> 3 & 1;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.clk_o, bench.dut.clk_i) << "step " << i << ", seed " << bench.seed;
  }
}

}  // namespace
}  // namespace pipegs
