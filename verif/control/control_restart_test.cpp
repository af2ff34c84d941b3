// SPDX-License-Identifier: Apache-2.0
// control_restart_test: rtl/control/pipegs_control_restart.sv against its model in every cycle, and what it promises.
//
// The memory side is played as far as it counts here: reads of each epoch that are unanswered. A core that is not kept
// apart asks for more at random, so the epoch may turn only while it is.
#include "Vpipegs_control_restart.h"
#include "cpp_model/control/control_restart.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

class Restart : public testing::Test, protected Endpoint {
 protected:
  Restart() {
    bench.add(*this);
    bench.dut.give_up_i = bench.dut.drained_i = bench.dut.test_mode_i = 0;
    bench.reset();
  }
  void drive() override {
    auto& dut = bench.dut;
    if (turned_) std::swap(reads_, old_reads_);  // what was asked for until now is old from here on
    for (int* reads : {&old_reads_, &reads_}) {
      if (*reads > 0 && static_cast<int>(bench.rng() % 100) < answer_percent) --*reads;
    }
    dut.give_up_i = static_cast<int>(bench.rng() % 100) < give_up_percent;
    dut.drained_i = old_reads_ == 0;
  }
  void observe() override {
    auto& dut = bench.dut;
    const std::string at = "cycle " + std::to_string(bench.cycle) + ", seed " + std::to_string(bench.seed);
    const bool give_up = dut.give_up_i;
    ASSERT_EQ(dut.epoch_o, model.epoch()) << at;
    ASSERT_EQ(dut.core_rst_no, !model.core_reset()) << at;
    ASSERT_EQ(dut.apart_o, model.apart()) << at;
    ASSERT_EQ(dut.ready_o, model.ready(give_up)) << at;
    // In its own words, beside the model.
    if (dut.epoch_o != epoch_) {
      ASSERT_FALSE(dut.core_rst_no) << "the epoch turned and the core is not in reset, " << at;
      ASSERT_TRUE(drained_) << "the epoch turned before the reads of the one before were answered, " << at;
      ++turns;
    }
    if (given_up_) { ASSERT_TRUE(dut.apart_o) << "given up, and the core is not kept apart, " << at; }
    if (dut.apart_o || give_up) { ASSERT_FALSE(dut.ready_o) << "a frame may be taken, " << at; }
    if (!dut.core_rst_no && low_ == 0) { ASSERT_GT(apart_, 0) << "in reset, and not apart before, " << at; }
    if (dut.core_rst_no && low_ > 0) { ASSERT_GE(low_, Config::reset_cycles()) << "a short reset, " << at; }
    if (dut.core_rst_no) ++high_;
    else high_ = 0;
    if (!dut.apart_o && apart_ > 0) { ASSERT_GT(high_, Config::reset_cycles()) << "soon behind the reset, " << at; }
    low_ = dut.core_rst_no ? 0 : low_ + 1;
    apart_ = dut.apart_o ? apart_ + 1 : 0;
    longest = std::max(longest, low_);
    given_up_ = give_up && !dut.apart_o;
    drained_ = dut.drained_i;
    if (!dut.apart_o && reads_ < 20 && bench.rng() % 2 == 0) ++reads_;
    model.step(give_up, drained_);
    turned_ = model.epoch() != (dut.epoch_o != 0);
    epoch_ = dut.epoch_o;
  }

  void forget() {  // the machine is reset
    model.reset();
    reads_ = old_reads_ = low_ = high_ = 0;
    apart_ = 1;
    epoch_ = 0;
    turned_ = given_up_ = drained_ = false;
  }

  Bench<Vpipegs_control_restart> bench;
  ControlRestart model;
  int give_up_percent = 0, answer_percent = 100, longest = 0;
  uint64_t turns = 0;

 private:
  int reads_ = 0, old_reads_ = 0;
  int low_ = 0, high_ = 0, apart_ = 1;  // cycles until now: in reset, out of it, kept apart
  CData epoch_ = 0;
  bool turned_ = false, given_up_ = false, drained_ = false;
};

TEST_F(Restart, KeepsItsPromisesAtEveryPace) {
  for (const int give_up : {1, 5, 30, 100}) {
    for (const int answer : {3, 20, 100}) {
      give_up_percent = give_up;
      answer_percent = answer;
      const uint64_t before = turns;
      for (int i = 0; i < 5000 && !HasFatalFailure(); ++i) bench.step();
      EXPECT_GT(turns - before, 3u) << "give-ups " << give_up << " %, answers " << answer << " %";
    }
  }
  EXPECT_GT(longest, 20);
}

TEST_F(Restart, ResetsForItsCyclesWhenNothingIsOut) {
  auto& dut = bench.dut;
  const int cycles = Config::reset_cycles();
  for (int i = 0; i < 3 * cycles; ++i) bench.step();
  ASSERT_EQ(dut.apart_o, 0);
  const CData epoch = dut.epoch_o;
  give_up_percent = 100;
  bench.step();
  give_up_percent = 0;
  int apart = 0, low = 0, turned = 0;
  for (; dut.apart_o; bench.step()) {
    EXPECT_EQ(dut.core_rst_no, apart == 0 || apart > cycles + 1) << "cycle " << apart;
    ++apart;
    low += !dut.core_rst_no;
    turned += !dut.core_rst_no && dut.epoch_o != epoch;
  }
  EXPECT_EQ(apart, 2 * cycles + 2);
  EXPECT_EQ(low, cycles + 1);
  EXPECT_EQ(turned, cycles);
}

// The tester's reset passes at once, whatever the flip-flops hold.
TEST_F(Restart, PassesTheResetInTheScanTest) {
  auto& dut = bench.dut;
  dut.test_mode_i = 1;
  for (int i = 0; i < 400; ++i) {
    dut.rst_ni = bench.rng() % 2;
    dut.give_up_i = bench.rng() % 2;
    dut.clk_i = bench.rng() % 2;
    dut.eval();
    ASSERT_EQ(dut.core_rst_no, dut.rst_ni) << "change " << i;
  }
}

// A reset of the machine: whatever was, the first epoch begins, and the core leaves reset its cycles later.
TEST_F(Restart, BeginsAgainAfterAReset) {
  for (int round = 0; round < 40 && !HasFatalFailure(); ++round) {
    give_up_percent = round % 2 == 0 ? 20 : 0;
    for (uint64_t i = bench.rng() % 30; i > 0; --i) bench.step();
    bench.reset(1 + static_cast<int>(bench.rng() % 3));
    forget();
  }
}

}  // namespace
}  // namespace pipegs
