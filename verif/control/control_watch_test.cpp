// SPDX-License-Identifier: Apache-2.0
// control_watch_test: rtl/control/pipegs_control_watch.sv against its model in every cycle, and in its own words.
#include "Vpipegs_control_watch.h"
#include "cpp_model/control/control_watch.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

class Watch : public testing::Test, protected Endpoint {
 protected:
  Watch() {
    set(0, false, false);
    bench.add(*this);
    bench.reset();
  }
  void set(uint32_t limit, bool waits, bool moves) {
    bench.dut.limit_i = limit, bench.dut.waits_i = waits, bench.dut.moves_i = moves;
  }
  void drive() override {}
  void observe() override {
    auto& dut = bench.dut;
    const std::string at = "cycle " + std::to_string(bench.cycle) + ", seed " + std::to_string(bench.seed);
    ASSERT_EQ(dut.tell_o, model.tell()) << at;
    ASSERT_EQ(dut.silent_o, model.silent()) << at;
    told += dut.tell_o;
    model.step(dut.limit_i, dut.waits_i, dut.moves_i);
  }

  Bench<Vpipegs_control_watch> bench;
  ControlWatch model;
  int told = 0;
};

TEST_F(Watch, EqualsItsModelWhateverComes) {
  for (const uint64_t silence : {3, 30, 300}) {
    for (int i = 0; i < 20000 && !HasFatalFailure(); ++i) {
      const auto one_in = [&](uint64_t n) { return bench.rng() % n == 0; };
      if (one_in(200)) bench.dut.limit_i = one_in(8) ? 0 : static_cast<uint32_t>(bench.rng() % 40);
      if (one_in(20)) bench.dut.waits_i = !one_in(4);
      bench.dut.moves_i = one_in(silence);
      bench.step();
    }
  }
  EXPECT_GT(told, 500);
}

TEST_F(Watch, TellsOfSilenceAgainAndAgainAndOfNothingElse) {
  for (const uint32_t limit : {1u, 2u, 7u, 50u}) {
    set(limit, true, true);
    bench.step();
    bench.step();  // the limit counts from here
    told = 0;
    bench.dut.moves_i = false;
    for (uint32_t i = 0; i < limit; ++i) {
      EXPECT_FALSE(bench.dut.tell_o || bench.dut.silent_o) << "cycle " << i << " of " << limit;
      bench.step();
    }
    EXPECT_TRUE(bench.dut.tell_o && bench.dut.silent_o) << limit;
    for (uint32_t i = 0; i < 3 * limit; ++i) bench.step();
    EXPECT_EQ(told, 3) << "of each silence of " << limit << " cycles once";
    EXPECT_TRUE(bench.dut.silent_o);
    bench.dut.moves_i = true;
    bench.step();
    EXPECT_FALSE(bench.dut.tell_o || bench.dut.silent_o);
  }
}

TEST_F(Watch, IsOffWithoutALimitOrADebt) {
  for (const bool waits : {false, true}) {
    set(waits ? 0 : 3, waits, false);
    told = 0;
    for (int i = 0; i < 100; ++i) bench.step();
    EXPECT_EQ(told, 0);
  }
}

}  // namespace
}  // namespace pipegs
