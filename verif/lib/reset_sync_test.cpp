// SPDX-License-Identifier: Apache-2.0
// reset_sync_test: rtl/lib/pipegs_reset_sync.sv: the reset comes without a clock and goes with the second edge.
#include "verif/support/bench.hpp"
#include "Vpipegs_reset_sync.h"

namespace pipegs {
namespace {

// The module, whose clock and reset change one at a time, and how many edges passed since the reset rose.
struct Reset {
  Reset() {
    bench.dut.clk_i = 0, bench.dut.rst_ni = 1, bench.dut.test_mode_i = 0;
    bench.dut.eval();
  }
  void clock(bool high) {
    if (high && !bench.dut.clk_i && bench.dut.rst_ni) ++edges;
    bench.dut.clk_i = high;
    bench.dut.eval();
  }
  void reset(bool low) {
    if (low) edges = 0;
    bench.dut.rst_ni = !low;
    bench.dut.eval();
  }
  bool released() const { return bench.dut.rst_no; }

  Bench<Vpipegs_reset_sync> bench;
  int edges = 0;
};

TEST(ResetSync, FallsAtOnceAndRisesWithTheSecondEdgeBehindTheReset) {
  Reset reset;
  reset.reset(true);
  ASSERT_FALSE(reset.released());
  int releases = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool before = reset.released();
    if (reset.bench.rng() % 4 != 0) reset.clock(!reset.bench.dut.clk_i);
    else reset.reset(reset.bench.rng() % 4 == 0);
    ASSERT_EQ(reset.released(), reset.edges >= 2) << "change " << i;
    releases += reset.released() && !before;
  }
  EXPECT_GT(releases, 500);
}

TEST(ResetSync, KeepsAPulseInWhichNoEdgeComes) {
  Reset reset;
  for (int i = 0; i < 6; ++i) reset.clock(i % 2 != 0);
  ASSERT_TRUE(reset.released());
  for (bool high : {false, true}) {
    reset.clock(high);
    reset.reset(true);
    EXPECT_FALSE(reset.released());
    reset.reset(false);
    EXPECT_FALSE(reset.released());
    for (int edge = 0; edge < 2; ++edge) {
      reset.clock(false);
      EXPECT_FALSE(reset.released()) << "edge " << edge;
      reset.clock(true);
    }
    EXPECT_TRUE(reset.released());
  }
}

TEST(ResetSync, IsInResetFromPowerUpOnWithoutAFallingEdge) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {  // the flip-flops start from noise
    Bench<Vpipegs_reset_sync> bench(seed);
    bench.dut.clk_i = 0, bench.dut.rst_ni = 0, bench.dut.test_mode_i = 0;
    bench.dut.eval();
    bench.dut.clk_i = 1;
    bench.dut.eval();
    EXPECT_EQ(bench.dut.rst_no, 0) << "seed " << seed;
  }
}

TEST(ResetSync, PassesTheResetInTheScanTest) {
  Reset reset;
  reset.bench.dut.test_mode_i = 1;
  for (int i = 0; i < 200; ++i) {
    const bool low = reset.bench.rng() % 2;
    reset.reset(low);
    ASSERT_EQ(reset.released(), !low);
    if (reset.bench.rng() % 2) reset.clock(!reset.bench.dut.clk_i);
    ASSERT_EQ(reset.released(), !low);
  }
}

}  // namespace
}  // namespace pipegs
