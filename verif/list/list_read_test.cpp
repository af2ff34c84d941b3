// SPDX-License-Identifier: Apache-2.0
// list_read_test: rtl/list/pipegs_list_read.sv: every entry of a list comes to one SU, in its window, and every window
// ends.
#include "Vpipegs_list_read.h"
#include "verif/list/list_bench.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

using LinePort = std::remove_reference_t<decltype(Vpipegs_list_read::rsp_data_i)>;

struct ReadRun {
  using Dut = Vpipegs_list_read;
  explicit ReadRun(const ExternalMemoryOptions& options)
      : memory(options),
        counts(bench, config, bench.dut),
        port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o,
             static_cast<const LinePort*>(nullptr), bench.dut.rsp_valid_i, bench.dut.rsp_data_i, Pace::kAlways,
             &bench.dut.mem_lines_o),
        sus(bench, config, bench.dut.splat_valid_o, bench.dut.splat_ready_i, bench.dut.splat_room_i,
            bench.dut.splat_o) {
    bench.dut.start_i = 0;
    write_frame(config, bench.dut, Frame{});
    bench.reset();
  }
  uint64_t frame(uint64_t columns, uint64_t rows, size_t count) {
    const Frame frame = list_frame(config, bench.rng, columns, rows);
    ListRecords records;
    records.add(config, bench.rng, columns * rows, count);
    const Span overflow = wide_overflow(frame);
    ListWrite model(config, overflow, columns * rows);
    bench.dut.log_i =
        static_cast<CData>(list_log(config, area_lines(config, overflow.lines, Area::kLists), columns * rows));
    std::vector<std::vector<Splat>> expected(columns * rows);
    for (size_t i = 0; i < count; ++i) {
      MemoryLine& line = memory.line(model(records.numbers[i]));
      for (uint32_t& word : line) word = static_cast<uint32_t>(bench.rng());  // beside the record lies noise
      Words words(static_cast<size_t>(record_words<Splat>(config)) + 1);
      pack(config, records.splats[i], words.data());
      const int width = record_width<Splat>(config);
      for (int bit = 0; bit < width; bit += 32)
        put_bits(line.data(), bit, std::min(32, width - bit), get_bits(words.data(), bit, std::min(32, width - bit)));
      expected[records.numbers[i]].push_back(records.splats[i]);
    }
    for (uint64_t i = 0; i < columns * rows; ++i) counts.counts[i] = model.counts[i];
    write_frame(config, bench.dut, frame);
    sus.clear();
    bench.dut.start_i = 1;
    const uint64_t start = bench.cycle;
    bench.gated_step();
    bench.dut.start_i = 0;
    EXPECT_TRUE(
        bench.run_gated_until([&] { return sus.ended(columns * rows); }, 100 * (count + columns * rows) + 10000));
    const uint64_t cycles = bench.cycle - start;
    for (int i = 0; i < 20; ++i) bench.gated_step();
    EXPECT_EQ(bench.dut.busy_o, 0);
    for (uint64_t w = 0; w < columns * rows; ++w) {
      auto found = sus.entries[w];
      const auto by_index = [](const Splat& a, const Splat& b) { return a.index < b.index; };
      std::sort(found.begin(), found.end(), by_index);
      EXPECT_EQ(found.size(), expected[w].size()) << "window " << w << ", seed " << bench.seed;
      for (size_t i = 0; i < std::min(found.size(), expected[w].size()); ++i) {
        EXPECT_EQ(first_difference(config, expected[w][i], found[i]), "")
            << "window " << w << ", entry " << i << ", seed " << bench.seed;
        if (testing::Test::HasFailure()) return 0;
      }
    }
    EXPECT_EQ(sus.entries.size(), columns * rows) << "entries behind the last window";
    return cycles;
  }
  Config config = test_config();
  GatedBench<Dut> bench;
  ExternalMemory memory;
  ListCounts<Dut> counts;
  MemoryEndpoint<QData, LinePort> port;
  ListSus<CData, std::remove_reference_t<decltype(Dut::splat_o)>> sus;
};

TEST(ListRead, GivesEveryEntryOnceInItsWindowAtEveryPace) {
  for (const Pace memory_pace : kPaces) {
    for (const Pace sink : kPaces) {
      ReadRun run({.latency = 40, .jitter = 60});
      run.port.pace = memory_pace;
      run.sus.pace = sink;
      run.frame(6, 5, 2000);
      run.frame(1, 1, 200);
      run.frame(3, 2, 0);
      run.frame(30, 20, 700);  // many lists without an entry
      run.frame(6, 5, 500);
      EXPECT_GT(run.bench.gated, 0u);
      if (testing::Test::HasFailure()) return;
    }
  }
}

// SUs whose stores are full make room only for a record that stands at their door.
TEST(ListRead, OffersARecordThoughNoSuIsReady) {
  for (const Pace sink : kPaces) {
    ReadRun run({.latency = 40, .jitter = 60});
    run.sus.pace = sink;
    run.sus.full = true;
    run.frame(3, 2, 300);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ListRead, ReadsAheadOfTheWindowAndDealsInTurn) {
  ReadRun run({.latency = 60, .bytes_per_cycle = 64});
  constexpr uint64_t kEntries = 6000, kWindows = 100;
  const uint64_t cycles = run.frame(10, 10, kEntries);
  // The latency is paid once, an end costs a cycle and the place for a whole group of lines now and then some more; a
  // single SU takes every second cycle.
  EXPECT_LE(cycles, (run.config.units == 1 ? 2 : 1) * (kEntries + kWindows) + 5 * kWindows + 100);
  for (const uint64_t count : run.sus.count)
    EXPECT_NEAR(static_cast<double>(count), static_cast<double>(kEntries) / run.config.units, kEntries / 50);
}

}  // namespace
}  // namespace pipegs
