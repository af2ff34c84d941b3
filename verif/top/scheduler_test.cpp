// SPDX-License-Identifier: Apache-2.0
// scheduler_test: rtl/scheduler.sv through many frames: when it is busy, what it counts, and what ends a frame.
#include <algorithm>

#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vscheduler.h"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

struct Schedule {
  Schedule() {
    auto& dut = bench.dut;
    dut.start_i = dut.window_done_i = dut.overflow_sort_i = dut.written_i = 0;
    dut.idle_i = 1;
    write_frame(config, dut, Frame{});
    write_overflow(0);
    bench.reset();
  }
  uint64_t write_overflow(int one_in) {  // random lines, often the most there can be; gives their sum
    Words words(port_words<decltype(bench.dut.overflow_alpha_i)>() + 2);
    uint64_t sum = 0;
    bench.dut.overflow_sort_i = 0;
    for (int i = 0; one_in > 0 && i < config.units; ++i) {
      const int width = config.region_w() + 1;
      const uint64_t most = static_cast<uint64_t>(config.regions());
      const uint64_t lines = bench.rng() % static_cast<uint64_t>(one_in) != 0 ? 0
                             : bench.rng() % 4 == 0                           ? most
                                                                              : bench.rng() % (most + 1);
      const uint64_t sort = bench.rng() % 2;
      put_bits(words.data(), i * width, width, lines);
      bench.dut.overflow_sort_i |= static_cast<CData>(sort << i);
      sum += lines + sort;
    }
    write_port(bench.dut.overflow_alpha_i, words.data());
    return sum;
  }
  // One frame: the RUs complete windows at a pace, idle_i is up one cycle in `idle_one_in`.
  void frame(uint64_t columns, uint64_t rows, Pace pace, uint64_t idle_one_in) {
    auto& dut = bench.dut;
    const size_t units = static_cast<size_t>(config.units);
    Frame frame = random_record<Frame>(config, bench.rng);
    frame.raster.windows.first_x = bench.rng() % (1024 - columns),
    frame.raster.windows.last_x = frame.raster.windows.first_x + columns - 1;
    frame.raster.windows.first_y = bench.rng() % (1024 - rows),
    frame.raster.windows.last_y = frame.raster.windows.first_y + rows - 1;
    write_frame(config, dut, frame);

    // Before the frame: nothing runs, the counts of the frame before stay.
    const uint64_t old_cycles = dut.cycles_o, old_overflow = dut.overflow_lines_o;
    for (int i = 0; i < 5; ++i) {
      dut.idle_i = bench.rng() % 2;
      write_overflow(2);
      bench.step();
      ASSERT_EQ(dut.busy_o, 0);
      ASSERT_EQ(dut.restart_o, 0);
      ASSERT_EQ(dut.cycles_o, old_cycles);
      ASSERT_EQ(dut.overflow_lines_o, old_overflow);
    }
    write_overflow(0);
    dut.start_i = 1;
    dut.idle_i = 1;
    bench.step();
    dut.start_i = 0;
    ASSERT_EQ(dut.restart_o, 1) << "no restart behind the start";

    std::vector<uint64_t> left(units, columns * rows);
    const uint64_t written = bench.rng() % 3 == 0
                                 ? ~uint64_t{0}
                                 : 1 + bench.rng() % 20;  // the cycle in which the lists are written; or never
    uint64_t preprocess = 0;
    uint64_t cycles = 0, overflow = 0, reported = 0, last = bench.rng() % units;  // one RU is the last one
    bool over = false;
    for (uint64_t cycle = 0; !over; ++cycle) {
      ASSERT_LT(cycle, 100000u) << "the frame does not end";
      ASSERT_EQ(dut.busy_o, 1) << "cycle " << cycle << " of " << columns << " x " << rows << ", seed " << bench.seed;
      ASSERT_EQ(dut.restart_o, cycle == 0);
      ASSERT_EQ(dut.cycles_o, cycles) << "cycle " << cycle;
      ASSERT_EQ(dut.overflow_lines_o, overflow) << "cycle " << cycle;
      ASSERT_EQ(dut.preprocess_cycles_o, preprocess) << "cycle " << cycle;
      dut.written_i = cycle == written;
      if (dut.written_i) preprocess = cycles;
      const bool complete = std::all_of(left.begin(), left.end(), [](uint64_t n) { return !n; });
      dut.idle_i = bench.rng() % idle_one_in == 0;
      dut.start_i = bench.rng() % 8 == 0;  // a start while it is busy changes nothing
      if (cycle > 0) over = complete && dut.idle_i;
      dut.window_done_i = 0;
      for (size_t i = 0; i < units && cycle > 0; ++i) {
        bool held = false;  // the last RU keeps its last window until the others are complete
        if (i == last && left[i] == 1) {
          for (size_t j = 0; j < units; ++j) held = held || (j != i && left[j] > 0);
        }
        if (left[i] == 0 || held || !goes(pace, bench.rng)) continue;
        dut.window_done_i |= static_cast<CData>(1u << i);
        --left[i];
      }
      if (cycle > 0) ++cycles;
      overflow += reported;  // lines are counted one cycle after they are reported
      reported = write_overflow(cycle == 0 ? 0 : 3);
      bench.step();
    }
    dut.start_i = dut.window_done_i = dut.written_i = 0;
    write_overflow(0);
    ASSERT_EQ(dut.preprocess_cycles_o, preprocess);
    ASSERT_EQ(dut.busy_o, 0) << "busy although all windows are complete and all is idle";
    ASSERT_EQ(dut.cycles_o, cycles);
    bench.step();
    ASSERT_EQ(dut.overflow_lines_o, overflow + reported);
  }

  Config config = test_config();
  Bench<Vscheduler> bench;
};

TEST(Scheduler, IsBusyUntilEveryWindowIsCompleteAndAllIsIdle) {
  for (const Pace pace : kPaces) {
    Schedule s;
    for (int i = 0; i < 60; ++i) {
      const uint64_t columns = 1 + s.bench.rng() % 6, rows = 1 + s.bench.rng() % 5;
      s.frame(columns, rows, pace, i % 3 == 0 ? 1 : i % 3 == 1 ? 2 : 40);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(Scheduler, CountsTheWindowsOfLargeFrames) {
  Schedule s;
  s.frame(300, 1, Pace::kAlways, 2);
  s.frame(1, 600, Pace::kAlways, 2);
  s.frame(40, 41, Pace::kAlways, 2);  // more than a column or row can count
  s.frame(129, 65, Pace::kAlways, 1);
}

}  // namespace
}  // namespace pipegs
