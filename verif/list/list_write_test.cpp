// SPDX-License-Identifier: Apache-2.0
// list_write_test: rtl/list/pipegs_list_write.sv against its bit-accurate model, with the SRAM of the counts in the
// test.
#include "Vpipegs_list_write.h"
#include "verif/list/list_bench.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

// The memory's port: takes writes at a pace, in order.
class Writes : public Endpoint {
 public:
  explicit Writes(GatedBench<Vpipegs_list_write>& bench, const Config& config) : bench_(bench), config_(config) {
    bench.dut.mem_ready_i = 0;
    bench.add(*this);
  }
  void drive() override { bench_.dut.mem_ready_i = goes(pace, bench_.rng); }
  void observe() override {
    auto& dut = bench_.dut;
    const Splat splat = read_record<Splat>(config_, dut.mem_data_o);
    if (shown_) {
      EXPECT_TRUE(dut.mem_valid_o && dut.mem_address_o == last_ && splat == splat_)
          << "a request changed, cycle " << bench_.cycle;
    }
    shown_ = dut.mem_valid_o && !dut.mem_ready_i;
    last_ = dut.mem_address_o;
    splat_ = splat;
    if (!dut.mem_valid_o || !dut.mem_ready_i) return;
    EXPECT_FALSE(dut.done_o);
    lines.push_back({last_, splat});
  }
  Pace pace = Pace::kAlways;
  std::vector<std::pair<uint64_t, Splat>> lines;

 private:
  GatedBench<Vpipegs_list_write>& bench_;
  Config config_;
  bool shown_ = false;
  uint64_t last_ = 0;
  Splat splat_;
};

struct WriteRun {
  using Dut = Vpipegs_list_write;
  WriteRun()
      : pus(bench, config, bench.dut.splat_valid_i, bench.dut.splat_ready_o, bench.dut.splat_i, bench.dut.number_i),
        writes(bench, config),
        counts(bench, config, bench.dut) {
    bench.dut.restart_i = 0;
    write_frame(config, bench.dut, Frame{});
    bench.reset();
  }
  // One frame; gives its cycles from the first record taken to the last line written.
  uint64_t frame(uint64_t columns, uint64_t rows, size_t count) {
    auto& dut = bench.dut;
    const Frame frame = list_frame(config, bench.rng, columns, rows);
    write_frame(config, dut, frame);
    dut.restart_i = 1;
    bench.gated_step();
    dut.restart_i = 0;
    ListRecords records;
    records.add(config, bench.rng, columns * rows, count);
    pus.offer(records);
    writes.lines.clear();
    const uint64_t before = pus.taken;
    EXPECT_TRUE(bench.run_gated_until([&] { return pus.taken > before; }));
    const uint64_t start = bench.cycle;
    EXPECT_TRUE(bench.run_gated_until([&] { return dut.done_o != 0; }, 40 * count + 2 * columns * rows + 1000));
    const uint64_t cycles = bench.cycle - start;
    EXPECT_TRUE(pus.empty());
    const std::vector<uint64_t> when_done = counts.counts;
    for (int i = 0; i < 20; ++i) bench.gated_step();
    EXPECT_EQ(dut.done_o, 1);
    // Every record once, and each at the next line of its window in the order in which they were written.
    ListWrite model(config, wide_overflow(frame), columns * rows);
    std::vector<bool> seen(count);
    EXPECT_EQ(writes.lines.size(), count);
    for (const auto& [address, splat] : writes.lines) {
      if (splat.index >= count || seen[splat.index]) {
        ADD_FAILURE() << "record " << splat.index << " was not offered, or written twice, seed " << bench.seed;
        return 0;
      }
      seen[splat.index] = true;
      EXPECT_EQ(first_difference(config, records.splats[splat.index], splat), "");
      EXPECT_EQ(address, model(records.numbers[splat.index]))
          << "record " << splat.index << " of window " << records.numbers[splat.index] << ", seed " << bench.seed;
      if (testing::Test::HasFailure()) return 0;
    }
    for (uint64_t i = 0; i < columns * rows; ++i) EXPECT_EQ(when_done[i], model.counts[i]) << "window " << i;
    return cycles;
  }
  Config config = test_config();
  GatedBench<Dut> bench;
  ListPus<Dut, CData, std::remove_reference_t<decltype(Dut::splat_i)>, std::remove_reference_t<decltype(Dut::number_i)>>
      pus;
  Writes writes;
  ListCounts<Dut> counts;
};

TEST(ListWrite, EqualsItsModelAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      WriteRun run;
      run.pus.pace = source;
      run.writes.pace = sink;
      run.frame(7, 5, 3000);
      run.frame(1, 1, 300);  // every record in the same window
      run.frame(2, 1, 500);
      run.frame(64, 64, 2000);
      run.frame(3, 3, 0);
      run.frame(7, 5, 1000);
      EXPECT_GT(run.bench.gated, 0u);
      if (testing::Test::HasFailure()) return;
    }
  }
}

// The last line of a list is written, the record behind it stops everything.
TEST(ListWrite, StopsWhenAListIsFull) {
  for (const uint64_t windows : {1, 3, 9}) {
    for (const uint64_t half : {0, 132, 133, 140, 399, 420, 1206, 1300}) {
      WriteRun run;
      auto& dut = run.bench.dut;
      const Frame frame = list_frame(run.config, run.bench.rng, windows, 1);
      Areas areas = wide_areas();
      areas.overflow = 2 * half;
      write_frame(run.config, dut, frame, areas);
      const uint64_t room = lists_fit(half, windows) ? uint64_t{1} << list_log(run.config, half, windows) : 0;
      dut.restart_i = 1;
      run.bench.gated_step();
      dut.restart_i = 0;
      ListRecords records;
      for (uint64_t i = 0; i < room + 3; ++i) {
        records.splats.push_back(random_record<Splat>(run.config, run.bench.rng));
        records.splats.back().kind = kData;
        records.numbers.push_back(windows - 1);
      }
      run.pus.offer(records);
      for (uint64_t i = 0; i < 300 + 10 * room; ++i) run.bench.gated_step();
      EXPECT_EQ(dut.full_o, 1);
      EXPECT_EQ(dut.done_o, 0);
      EXPECT_EQ(run.writes.lines.size(), room) << windows << " windows, " << half << " lines";
      if (room != 0) {
        const uint64_t last = list_first(windows - 1, list_log(run.config, half, windows));
        EXPECT_EQ(dut.full_line_o, frame.tables.overflow + last + room);
      }
      for (const auto& [address, splat] : run.writes.lines)
        EXPECT_TRUE(address >= frame.tables.overflow && address < frame.tables.overflow + half) << address;
    }
  }
}

TEST(ListWrite, WritesARecordEveryCycle) {
  WriteRun run;
  EXPECT_LE(run.frame(5, 5, 2000), 2010u);
  EXPECT_LE(run.frame(1, 1, 2000), 2010u);
}

}  // namespace
}  // namespace pipegs
