// SPDX-License-Identifier: Apache-2.0
// sleep_test: rtl/lib/pipegs_sleep.sv against a count of quiet cycles.
#include "Vpipegs_sleep.h"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

constexpr int kPatience = 127;  // the module's default

TEST(Sleep, FallsAsleepAfterItsPatienceAndWakesAtOnce) {
  Bench<Vpipegs_sleep> bench;
  bench.dut.moved_i = bench.dut.wake_i = 0;
  bench.reset();
  int quiet = 0, asleep = 0;
  for (int i = 0; i < 50000; ++i) {
    bench.dut.moved_i = bench.rng() % 100 == 0;
    bench.dut.wake_i = bench.rng() % 300 == 0;
    bench.dut.clk_i = 0;
    bench.dut.eval();
    ASSERT_EQ(bench.dut.asleep_o, quiet >= kPatience && !bench.dut.wake_i) << "cycle " << i;
    asleep += bench.dut.asleep_o;
    bench.dut.clk_i = 1;
    bench.dut.eval();
    quiet = bench.dut.moved_i || bench.dut.wake_i ? 0 : quiet + 1;
  }
  EXPECT_GT(asleep, 0);
}

}  // namespace
}  // namespace pipegs
