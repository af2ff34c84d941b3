// SPDX-License-Identifier: Apache-2.0
// control_done_test: rtl/control/pipegs_control_done.sv against its model in every cycle, and against a queue of
// writes.
//
// A core writes lines and ends frames at random; a memory answers the writes in their order. Each write in the queue
// bears the number of its frame: a frame must not be told while one of its writes, or one of those before it, is in the
// queue; each is told once, and only a give-up makes that it is not told at all.
#include "Vpipegs_control_done.h"
#include "cpp_model/control/control_done.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

class Done : public testing::Test, protected Endpoint {
 protected:
  Done() {
    bench.add(*this);
    auto& dut = bench.dut;
    dut.core_done_i = dut.give_up_i = dut.writes_i = dut.answered_i = 0;
    bench.reset();
  }
  bool chance(int percent) { return static_cast<int>(bench.rng() % 100) < percent; }
  void drive() override {
    auto& dut = bench.dut;
    dut.writes_i = static_cast<CData>(writes.size());
    // A frame ends one cycle or more behind its last write, and has written; none ends in the cycle behind another one.
    dut.core_done_i = wrote_ && !dut.core_done_i && chance(end_percent);
    dut.answered_i = !writes.empty() && chance(answer_percent);
    dut.give_up_i = chance(give_up_percent);
  }
  void observe() override {
    auto& dut = bench.dut;
    const std::string at = "cycle " + std::to_string(bench.cycle) + ", seed " + std::to_string(bench.seed);
    const bool give_up = dut.give_up_i;
    ASSERT_EQ(dut.done_o, model.done(give_up)) << at;
    ASSERT_EQ(dut.waiting_o, model.waiting()) << at;
    // In its own words, beside the model.
    if (dut.done_o) {
      ASSERT_LT(told, ended) << "a frame is told that did not end, " << at;
      ASSERT_TRUE(writes.empty() || writes.front() > told) << "frame " << told << " has an unanswered write, " << at;
      ++told;
      last_told = bench.cycle;
    }
    ASSERT_EQ(dut.waiting_o != 0, told + (dut.done_o ? 0 : 1) <= ended) << at;
    if (dut.answered_i) {
      writes.pop_front();
      last_answer = bench.cycle;
    }
    if (dut.core_done_i) {
      ++ended;
      wrote_ = false;
    }
    if (give_up) {  // writes that are out are answered all the same
      given_up += ended - told;
      told = ended;
    }
    const bool writes_now = writes.size() < static_cast<size_t>(Config::bus_writes()) && chance(write_percent);
    if (writes_now) {
      writes.push_back(ended);
      wrote_ = true;
    }
    most = std::max(most, ended - told);
    model.step(dut.core_done_i, give_up, dut.writes_i, dut.answered_i);
  }

  Bench<Vpipegs_control_done> bench;
  ControlDone model;
  std::deque<uint64_t> writes;                 // the frame of each that is not answered
  uint64_t ended = 0, told = 0, given_up = 0;  // frames
  uint64_t most = 0;                           // frames that have waited at once
  uint64_t last_answer = 0, last_told = 0;     // cycles
  int write_percent = 0, end_percent = 0, answer_percent = 0, give_up_percent = 0;

 private:
  bool wrote_ = false;  // the frame that runs has written a line
};

TEST_F(Done, TellsEachFrameOnceAndNotBeforeItsWritesAreAnswered) {
  for (const int write : {3, 30, 100}) {
    for (const int answer : {3, 30, 100}) {
      for (const int end : {2, 50, 100}) {
        for (const int give_up : {0, 1}) {
          write_percent = write, answer_percent = answer, end_percent = end, give_up_percent = give_up;
          const uint64_t before = ended, lost = given_up;
          for (int i = 0; i < 2000 && !HasFatalFailure(); ++i) bench.step();
          write_percent = end_percent = give_up_percent = 0, answer_percent = 100;
          for (int i = 0; i < 6 * Config::bus_writes() && !HasFatalFailure(); ++i) bench.step();
          ASSERT_EQ(told, ended) << "write " << write << " %, answer " << answer << " %, end " << end << " %";
          ASSERT_EQ(bench.dut.waiting_o, 0);
          EXPECT_GT(ended, before);
          if (give_up == 0) { EXPECT_EQ(given_up, lost); }
        }
      }
    }
  }
  EXPECT_GT(given_up, 50u);
  EXPECT_GT(most, static_cast<uint64_t>(Config::bus_writes()) / 2);
}

TEST_F(Done, TellsOneCycleBehindTheLastAnswer) {
  for (int round = 0; round < 50 && !HasFatalFailure(); ++round) {
    const uint64_t before = told;
    write_percent = 100, answer_percent = 10 * (round % 2);
    for (int i = 0; i < 5 + round; ++i) bench.step();
    write_percent = 0, end_percent = 100;
    bench.step();  // the last write is among those that are accepted
    const uint64_t end = bench.cycle - 1;
    end_percent = 0, answer_percent = round % 3 == 0 ? 100 : 30;
    ASSERT_TRUE(bench.run_until([&] { return told > before; }));
    EXPECT_EQ(last_told, std::max(last_answer, end) + 1);
    EXPECT_TRUE(writes.empty());
  }
}

// Each of two that wait is told one cycle behind its own last answer. A third waits with the second one.
TEST_F(Done, AFrameThatWaitsIsNotHeldUpByThoseBehindIt) {
  std::vector<uint64_t> last;  // write of each frame
  for (int frame = 0; frame < 3; ++frame) {
    write_percent = 100;
    for (int i = 0; i < 8; ++i) bench.step();
    write_percent = 0, end_percent = 100;
    bench.step();
    end_percent = 0;
    last.push_back(writes.size());
  }
  EXPECT_EQ(most, 3u);
  answer_percent = 100;
  const uint64_t begin = bench.cycle;
  ASSERT_TRUE(bench.run_until([&] { return told == 1; }));
  EXPECT_EQ(last_told, begin + last[0]);
  ASSERT_TRUE(bench.run_until([&] { return told == 3; }));
  EXPECT_EQ(last_told, begin + last[2] + 1);
  EXPECT_TRUE(writes.empty());
}

// Frames end faster than the writes of one are answered, for ever: they are told all the same.
TEST_F(Done, FramesAreToldHoweverFastOthersFollow) {
  write_percent = end_percent = 100, answer_percent = 20;
  for (int i = 0; i < 20000 && !HasFatalFailure(); ++i) {
    bench.step();
    ASSERT_LE(ended - told, 4u * static_cast<uint64_t>(Config::bus_writes()));
  }
  EXPECT_GT(told, 1000u);
}

}  // namespace
}  // namespace pipegs
