// SPDX-License-Identifier: Apache-2.0
// pu_spill_test: rtl/pu/rows/pu_spill.sv: every line reaches its place before the end behind it leaves. Without
// Overflow every line is for the store, or an assertion says so.
#include <map>

#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"
#include "verif/support/gated_bench.hpp"
#include "Vpu_spill.h"

namespace pipegs {
namespace {

// A line that follows from its record, so that a swapped line is seen.
Words line_of(const Config& config, const Alphas& alphas) {
  std::mt19937_64 rng(alphas.address * 64 + alphas.region);
  Words words(static_cast<size_t>(config.line_w()) / 32);
  for (uint32_t& word : words) word = static_cast<uint32_t>(rng());
  return words;
}

// The address of line n of unit 3, as pu_allocate gives it: above the number stands the area, with lists the unit.
uint64_t numbered(const Config& config, uint64_t n, uint64_t area = 0) {
  return (config.has_lists() ? 3 : area) << ru_number_w(config) | n;
}

struct SpillBench {
  Config config = test_config();
  Frame frame;
  GatedBench<Vpu_spill> bench;
  ExternalMemory memory{ExternalMemoryOptions{.bytes_per_cycle = 64}};
  CData write = 1, no_answer = 0;
  VlWide<16> answer;
  RecordSource<Alphas, decltype(bench.dut.alphas_i)> in{bench, config, bench.dut.alphas_valid_i,
                                                        bench.dut.alphas_ready_o, bench.dut.alphas_i};
  std::vector<std::pair<uint64_t, Words>> stored;
  Beside lines{bench,
               [this] {
                 if (!bench.dut.store_write_o) return;
                 Words line(port_words<decltype(bench.dut.store_line_o)>());
                 read_port(bench.dut.store_line_o, line.data());
                 line.resize(static_cast<size_t>(config.line_w()) / 32);
                 stored.emplace_back(bench.dut.store_address_o, line);
               },
               [this] {
                 if (!bench.dut.alphas_valid_i) return;
                 write_port(bench.dut.line_i, line_of(config, read_record<Alphas>(config, bench.dut.alphas_i)).data());
               }};
  MemoryEndpoint<QData, VlWide<16>> port{bench,
                                         memory,
                                         bench.dut.mem_valid_o,
                                         bench.dut.mem_ready_i,
                                         &write,
                                         bench.dut.mem_address_o,
                                         &bench.dut.mem_data_o,
                                         no_answer,
                                         answer};
  WordSink<CData> ends{bench, bench.dut.rows_end_valid_o, bench.dut.rows_end_ready_i, bench.dut.rows_end_kind_o};

  SpillBench() {
    frame.tables.overflow = 0x12345;
    write_frame(config, bench.dut, frame);
    bench.dut.unit_i = 3;
    bench.reset();
  }
};

TEST(PuSpill, PutsEveryLineInItsPlaceBeforeTheEndLeaves) {
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      SpillBench s;
      s.in.pace = source, s.port.pace = s.ends.pace = sink;
      std::vector<std::pair<uint64_t, Words>> stored;
      std::map<uint64_t, Words> spilled;
      const int pieces = s.config.alpha_memory_lines();
      for (uint64_t layer = 0; layer < 12; ++layer) {
        uint64_t lines = 0;
        for (uint64_t n = 0; n < 20; ++n) {
          Alphas alphas = random_record<Alphas>(s.config, s.bench.rng);
          alphas.kind = kData;
          alphas.ext &= static_cast<uint64_t>(s.config.overflow);
          if (alphas.ext) {
            alphas.address = numbered(s.config, lines++, layer % 2);
            Words line = line_of(s.config, alphas);
            line.resize(static_cast<size_t>(pieces) * 16);
            for (int piece = 0; piece < pieces; ++piece) {
              spilled[ru_overflow_line(s.config, wide_overflow(s.frame), 3, alphas.address) +
                      static_cast<uint64_t>(piece)] = Words(line.begin() + 16 * piece, line.begin() + 16 * (piece + 1));
            }
          } else {
            stored.emplace_back(alphas.address, line_of(s.config, alphas));
          }
          s.in.push(alphas);
        }
        s.in.push(Alphas{.kind = layer % 3 == 2 ? kWindowEnd : kLayerEnd});
        ASSERT_TRUE(s.bench.run_gated_until([&] { return s.ends.beats.size() == layer + 1; }));
        EXPECT_EQ(s.ends.beats.back()[0], layer % 3 == 2 ? kWindowEnd : kLayerEnd);
        for (const auto& [address, line] : spilled) {
          const MemoryLine& found = s.memory.line(address);
          ASSERT_EQ(Words(found.begin(), found.end()), line) << "memory line " << address << " of layer " << layer;
        }
        ASSERT_EQ(s.stored, stored) << "layer " << layer;
        spilled.clear();
      }
      EXPECT_EQ(s.port.requests > 0, s.config.overflow != 0);
      if (HasFailure()) { FAIL() << "source " << to_text(source) << ", sink " << to_text(sink); }
    }
  }
}

// The last line of the area is written, the one behind it is not, nor any that comes later.
TEST(PuSpill, StopsBeforeItsAreaEnds) {
  for (const uint64_t area : {0, 1}) {
    SpillBench s;
    if (!s.config.overflow || (s.config.has_lists() && area != 0)) continue;
    const auto pieces = static_cast<uint64_t>(s.config.alpha_memory_lines());
    Areas areas = wide_areas();
    areas.overflow = 3200;
    write_frame(s.config, s.bench.dut, s.frame, areas);
    for (int i = 0; i < 3; ++i) s.bench.step();
    const uint64_t lines = area_lines(s.config, areas.overflow, Area::kEven) / pieces;
    const Span overflow = overflow_span(s.frame, areas);
    for (uint64_t n = 0; n < lines; ++n) s.in.push(Alphas{.address = numbered(s.config, n, area), .ext = 1});
    ASSERT_TRUE(s.bench.run_until([&] { return s.port.requests == lines * pieces; }));
    for (int i = 0; i < 10; ++i) s.bench.step();
    EXPECT_EQ(s.bench.dut.full_o, 0);
    for (uint64_t n = lines; n < lines + 5; ++n) s.in.push(Alphas{.address = numbered(s.config, n, area), .ext = 1});
    for (int i = 0; i < 50; ++i) s.bench.step();
    EXPECT_EQ(s.bench.dut.full_o, 1);
    EXPECT_EQ(s.bench.dut.full_line_o, ru_overflow_line(s.config, overflow, 3, numbered(s.config, lines, area)));
    EXPECT_EQ(s.port.requests, lines * pieces);
    EXPECT_EQ(s.in.taken, lines + 1);
  }
}

// Numbers wrap behind the last one: those near it have no place, however large the area is.
TEST(PuSpill, StopsBeforeItsNumbersWrap) {
  SpillBench s;
  if (!s.config.overflow) GTEST_SKIP() << "no line spills";
  Areas areas = wide_areas();
  areas.overflow = uint64_t{1} << 33;
  write_frame(s.config, s.bench.dut, s.frame, areas);
  const uint64_t last = (uint64_t{1} << ru_number_w(s.config)) - 1;
  s.in.push(Alphas{.address = last - static_cast<uint64_t>(s.config.regions()), .ext = 1});
  for (int i = 0; i < 20; ++i) s.bench.step();
  EXPECT_EQ(s.bench.dut.full_o, 0);
  s.in.push(Alphas{.address = last, .ext = 1});
  for (int i = 0; i < 20; ++i) s.bench.step();
  EXPECT_EQ(s.bench.dut.full_o, 1);
}

TEST(PuSpill, KeepsUpWithTheRowUnitsWhenEveryLineSpills) {
  SpillBench s;
  if (!s.config.overflow) GTEST_SKIP() << "no line spills";
  for (uint64_t n = 0; n < 200; ++n) s.in.push(Alphas{.address = n, .ext = 1});
  s.bench.run_until([&] { return s.in.taken > 0; });
  const uint64_t first = s.bench.cycle;
  s.bench.run_until([&] { return s.in.empty(); });
  EXPECT_EQ(s.bench.cycle - first, 199u * static_cast<uint64_t>(s.config.alpha_memory_lines() + 1));
}

TEST(PuSpill, SaysSoWhenALineIsForMemory) {
  SpillBench s;
  if (s.config.overflow) GTEST_SKIP() << "the memory takes it";
  s.in.push(Alphas{.address = 1});
  s.in.push(Alphas{.address = 2, .ext = 1});
  EXPECT_THROW(s.bench.run_until([&] { return s.in.taken == 2; }), std::runtime_error);
  EXPECT_EQ(s.stored.front().first, 1u);
}

}  // namespace
}  // namespace pipegs
