// SPDX-License-Identifier: Apache-2.0
// scheduler_test: rtl/pipegs_scheduler.sv through many frames: who works on which, what it counts, and what ends a
// frame.
//
// Idea    The test plays the machine: a front that works for some cycles, a back into which window ends go while it is
//         not held and whose RUs complete windows at a pace. It keeps which frame each has, and expects each output.
#include <algorithm>
#include <deque>

#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_scheduler.h"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

struct Job {
  Windows windows;
  uint64_t count;  // of windows
  bool same;       // it sorts as the frame before it
};

class Schedule {
 public:
  Schedule() {
    auto& dut = bench_.dut;
    dut.frame_valid_i = dut.same_i = dut.front_busy_i = dut.back_busy_i = dut.storing_i = dut.end_i = 0;
    dut.window_done_i = dut.overflow_sort_i = dut.written_i = 0;
    dut.idle_i = 1;
    write_record(config_, dut.windows_i, Windows{});
    write_overflow(false);
    bench_.reset();
  }

  // Runs frames until all are complete. A frame is offered one cycle in `offered_one_in`; the back is busy behind its
  // last window one cycle in `busy_one_in`.
  void run(std::deque<Job> jobs, Pace pace, uint64_t offered_one_in, uint64_t busy_one_in) {
    pace_ = pace;
    jobs_ = std::move(jobs);
    const size_t frames = jobs_.size();
    const size_t done_before = done_;
    for (uint64_t cycle = 0; done_ - done_before < frames || busy(); ++cycle) {
      ASSERT_LT(cycle, 2000000u) << "frames do not end, seed " << bench_.seed;
      drive(offered_one_in, busy_one_in);
      if (testing::Test::HasFailure()) return;
    }
    bench_.dut.frame_valid_i = 0;
  }

  uint64_t random(uint64_t below) { return bench_.rng() % below; }
  uint64_t overlaps() const { return overlapped_; }
  bool may_overlap() const { return !config_.has_lists() && !config_.has_stores(); }

 private:
  bool busy() const { return front_works_ || ahead_ || back_works_; }

  uint64_t write_overflow(bool some) {  // random lines, often the most there can be; gives their sum
    Words words(port_words<decltype(bench_.dut.overflow_alpha_i)>() + 2);
    uint64_t sum = 0;
    bench_.dut.overflow_sort_i = 0;
    for (int i = 0; some && i < config_.units; ++i) {
      const int width = config_.region_w() + 1;
      const auto most = static_cast<uint64_t>(config_.regions());
      const uint64_t lines = random(3) != 0 ? 0 : random(4) == 0 ? most : random(most + 1), sort = random(2);
      put_bits(words.data(), i * width, width, lines);
      bench_.dut.overflow_sort_i |= static_cast<CData>(sort << i);
      sum += lines + sort;
    }
    write_port(bench_.dut.overflow_alpha_i, words.data());
    return sum;
  }

  // One cycle: inputs as the machine would set them, outputs as they must be, then what the edge changes.
  void drive(uint64_t offered_one_in, uint64_t busy_one_in) {
    auto& dut = bench_.dut;
    const size_t units = left_.size();
    const std::string at = "cycle " + std::to_string(bench_.cycle) + ", seed " + std::to_string(bench_.seed);
    dut.frame_valid_i = !jobs_.empty() && random(offered_one_in) == 0;
    dut.same_i = !jobs_.empty() && jobs_.front().same;
    dut.idle_i = !busy() && random(2) == 0;
    dut.front_busy_i = front_works_ && !front_restart_ && front_left_ > 0;
    const bool completed = std::all_of(left_.begin(), left_.end(), [](uint64_t n) { return n == 0; });
    dut.back_busy_i = back_works_ && random(busy_one_in) != 0;
    dut.storing_i = random(busy_one_in) != 0;
    dut.written_i = random(50) == 0;
    // Ends go in only of the back's frame, and RUs complete only what went in.
    dut.end_i = enter_ > 0 && !back_restart_ && goes(pace_, bench_.rng);
    dut.window_done_i = 0;
    for (size_t i = 0; i < units; ++i) {
      if (left_[i] > enter_ && goes(pace_, bench_.rng)) dut.window_done_i |= static_cast<CData>(1u << i);
    }
    const uint64_t lines = write_overflow(true);
    write_record(config_, dut.windows_i, front_.windows);
    dut.clk_i = 0;
    dut.eval();

    const bool ready = !front_works_ && !ahead_ && ((!back_works_ && was_idle_) || (may_overlap() && dut.same_i));
    ASSERT_EQ(dut.frame_ready_o, ready) << at;
    ASSERT_EQ(dut.busy_o, busy()) << at;
    ASSERT_EQ(dut.front_restart_o, front_restart_) << at;
    ASSERT_EQ(dut.back_restart_o, back_restart_) << at;
    ASSERT_EQ(dut.begin_o, begin_) << at;
    ASSERT_EQ(dut.hold_o, enter_ == 0) << at;
    ASSERT_EQ(dut.done_o, finished_) << at;
    ASSERT_EQ(dut.cycles_o, cycles_) << at;
    ASSERT_EQ(dut.preprocess_cycles_o, preprocess_) << at;
    ASSERT_EQ(dut.overflow_lines_o, overflow_) << at;
    // The RUs are heard only while they work on the front's frame, from the third cycle behind their restart on.
    ASSERT_EQ(dut.listen_o, !ahead_ && !back_restart_ && since_restart_ >= 3) << at;

    const bool take = dut.frame_valid_i && ready, hand = ahead_ && !back_works_;
    const bool finish = back_works_ && !back_restart_ && completed && !dut.back_busy_i && !dut.storing_i;
    if (take && back_works_) ++overlapped_;
    overflow_ += reported_;
    if (busy() && dut.written_i) preprocess_ = cycles_;
    if (busy() && !begin_) ++cycles_;
    reported_ = busy() ? lines : 0;
    if (take && !busy()) cycles_ = preprocess_ = overflow_ = 0;
    begin_ = take && !busy();
    if (front_works_ && !front_restart_) {
      if (front_left_ == 0) front_works_ = false;
      else --front_left_;
    }
    since_restart_ = back_restart_ ? 1 : since_restart_ + 1;
    front_restart_ = take;
    back_restart_ = hand;
    finished_ = finish;
    done_ += finish;
    if (hand) {
      ahead_ = false;
      enter_ = front_.count;
      for (uint64_t& left : left_) left = front_.count;
    } else {
      enter_ -= dut.end_i;
      for (size_t i = 0; i < units; ++i) left_[i] -= dut.window_done_i >> i & 1;
    }
    was_idle_ = dut.idle_i;
    if (finish) back_works_ = false;
    if (hand) back_works_ = true;
    if (take) {
      front_ = jobs_.front();
      jobs_.pop_front();
      front_works_ = ahead_ = true;
      front_left_ = random(front_.count * 8 + 1);
    }
    bench_.step();
  }

  const Config config_ = test_config();
  Bench<Vpipegs_scheduler> bench_;
  Pace pace_ = Pace::kAlways;
  std::deque<Job> jobs_;
  Job front_{};
  bool front_works_ = false, ahead_ = false, back_works_ = false, was_idle_ = true;
  bool front_restart_ = false, back_restart_ = false, begin_ = false, finished_ = false;
  uint64_t front_left_ = 0;  // cycles
  uint64_t enter_ = 0, since_restart_ = 3;
  std::vector<uint64_t> left_ = std::vector<uint64_t>(static_cast<size_t>(config_.units));
  uint64_t cycles_ = 0, preprocess_ = 0, overflow_ = 0, reported_ = 0;
  size_t done_ = 0, overlapped_ = 0;
};

Job job(Schedule& s, uint64_t columns, uint64_t rows, bool same) {
  Job one{.windows = {}, .count = columns * rows, .same = same};
  one.windows.first_x = s.random(1024 - columns), one.windows.last_x = one.windows.first_x + columns - 1;
  one.windows.first_y = s.random(1024 - rows), one.windows.last_y = one.windows.first_y + rows - 1;
  return one;
}

TEST(Scheduler, TakesFramesWhenTheFrontIsFreeAndEndsThemWhenTheBackHasStoredAll) {
  for (const Pace pace : kPaces) {
    for (const uint64_t offered_one_in : {1, 40}) {
      Schedule s;
      for (const uint64_t busy_one_in : {1, 2, 40}) {
        std::deque<Job> jobs;
        for (int i = 0; i < 30; ++i) jobs.push_back(job(s, 1 + s.random(6), 1 + s.random(5), s.random(4) != 0));
        s.run(jobs, pace, offered_one_in, busy_one_in);
        if (testing::Test::HasFailure()) return;
      }
      if (s.may_overlap() && offered_one_in == 1) { EXPECT_GT(s.overlaps(), 10u) << "frames never overlapped"; }
      if (!s.may_overlap()) { EXPECT_EQ(s.overlaps(), 0u); }
    }
  }
}

TEST(Scheduler, CountsTheWindowsOfLargeFrames) {
  Schedule s;
  std::deque<Job> jobs;
  for (const auto& [columns, rows] : {std::pair{300, 1}, {1, 600}, {40, 41}, {129, 65}})  // more than a column counts
    jobs.push_back(job(s, static_cast<uint64_t>(columns), static_cast<uint64_t>(rows), true));
  s.run(jobs, Pace::kAlways, 1, 1);
}

}  // namespace
}  // namespace pipegs
