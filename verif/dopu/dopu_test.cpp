// SPDX-License-Identifier: Apache-2.0
// dopu_test: rtl/dopu/pipegs_dopu.sv whole, on random packed scenes, against the walk of its bit-accurate model.
#include "cpp_model/dopu/dopu.hpp"
#include "verif/dopu/dopu_bench.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

// What the frame must send: chunks, and ends as (chunks before, kind). With lists one walk from the first window on.
void expect(const World& world, std::vector<Chunk>& chunks, std::vector<std::pair<size_t, uint64_t>>& ends) {
  const Config& config = world.config;
  const Frame& frame = world.frame;
  const bool once = config.has_lists();
  for (uint64_t y = frame.raster.windows.first_y;
       y <= (once ? frame.raster.windows.first_y : frame.raster.windows.last_y); ++y) {
    for (uint64_t x = frame.raster.windows.first_x;
         x <= (once ? frame.raster.windows.first_x : frame.raster.windows.last_x); ++x) {
      std::vector<size_t> in_layer(static_cast<size_t>(config.layered ? config.grid : 1));
      dopu_window(config, frame, world.packed, static_cast<int>(x), static_cast<int>(y),
                  [&](int layer, const Chunk& chunk, uint64_t) {
                    chunks.push_back(chunk);
                    ++in_layer[static_cast<size_t>(layer)];
                  });
      size_t sent = chunks.size();
      for (const size_t n : in_layer) sent -= n;
      for (size_t layer = 0; layer < in_layer.size(); ++layer) {
        sent += in_layer[layer];
        if (layer + 1 == in_layer.size()) ends.push_back({sent, kWindowEnd});
        else if (in_layer[layer] != 0) ends.push_back({sent, kLayerEnd});
      }
    }
  }
}

void compare(Pace pace, Pace memory_pace, const ExternalMemoryOptions& options) {
  Bench<Vpipegs_dopu> bench;
  const Config config = test_config();
  bench.dut.start_i = 0;
  no_feedback(bench);
  ExternalMemory memory(options);
  Units units(bench, config, pace);
  Memory port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
              bench.dut.rsp_valid_i, bench.dut.rsp_data_i, memory_pace, &bench.dut.mem_lines_o);
  bench.reset();
  for (int frame = 0; frame < 6; ++frame) {  // one after another: nothing may be left of the frame before
    const size_t gaussians[] = {3000, 0, 1, 20000, 500, 60};
    const World world(bench.rng, gaussians[frame], 200, 150, frame == 4);
    world.load(memory);
    std::vector<Chunk> chunks;
    std::vector<std::pair<size_t, uint64_t>> ends;
    expect(world, chunks, ends);
    units.beats.clear();
    for (auto& mine : units.ends) mine.clear();
    start(bench, world);
    ASSERT_TRUE(bench.run_until([&] { return !bench.dut.busy_o; }, 2000000)) << "frame " << frame;
    ASSERT_EQ(units.beats.size(), chunks.size()) << "frame " << frame;
    for (size_t i = 0; i < chunks.size(); ++i) {
      ASSERT_EQ(first_difference(config, chunks[i], units.beats[i]), "")
          << "frame " << frame << ", chunk " << i << " of " << chunks.size();
    }
    for (int u = 0; u < config.units; ++u)
      ASSERT_EQ(units.ends[static_cast<size_t>(u)], ends) << "frame " << frame << ", unit " << u;
  }
  for (int u = 1; u < config.units; ++u)
    EXPECT_GT(units.count[u] * 3, units.count[0]) << "unit " << u << " got too little";
}

TEST(Dopu, EqualsItsModelWithAPromptMemory) {
  compare(Pace::kAlways, Pace::kAlways, {.latency = 10, .bytes_per_cycle = 64});
}
TEST(Dopu, EqualsItsModelWithASlowMemory) {
  compare(Pace::kAlways, Pace::kCoin, {.latency = 150, .bytes_per_cycle = 12.8, .jitter = 40});
}
TEST(Dopu, EqualsItsModelUnderBackPressure) { compare(Pace::kQuarter, Pace::kAlways, {.latency = 60, .jitter = 20}); }
TEST(Dopu, EqualsItsModelWithLazyUnits) { compare(Pace::kLazy, Pace::kLazy, {.latency = 60, .jitter = 20}); }
TEST(Dopu, EqualsItsModelByCoin) { compare(Pace::kCoin, Pace::kQuarter, {.latency = 60, .jitter = 20}); }

// The RUs report a window done after it got some chunks: what comes after is a subset in order, and every end still
// comes.
TEST(Dopu, SkipsTheRestOfAWindowThatIsDone) {
  Bench<Vpipegs_dopu> bench;
  const Config config = test_config();
  bench.dut.start_i = 0;
  no_feedback(bench);
  ExternalMemory memory({.latency = 40});
  Units units(bench, config, Pace::kAlways);
  Memory port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
              bench.dut.rsp_valid_i, bench.dut.rsp_data_i, Pace::kAlways, &bench.dut.mem_lines_o);
  Feedback feedback(bench, units, config);
  bench.reset();
  const World world(bench.rng, 20000, 200, 150);
  world.load(memory);
  std::vector<Chunk> chunks;
  std::vector<std::pair<size_t, uint64_t>> ends;
  expect(world, chunks, ends);
  feedback.frame = &world.frame;
  start(bench, world);
  ASSERT_TRUE(bench.run_until([&] { return !bench.dut.busy_o; }, 2000000));
  if (config.has_lists()) {  // lists are made before anything is done
    EXPECT_EQ(units.beats, chunks);
    return;
  }
  const size_t windows =
      static_cast<size_t>((world.frame.raster.windows.last_x + 1) * (world.frame.raster.windows.last_y + 1));
  EXPECT_EQ(feedback.ends, windows * static_cast<size_t>(config.units));
  EXPECT_GE(units.beats.size(), std::min(chunks.size(), 10 * windows) / 2);
  EXPECT_LT(units.beats.size(), chunks.size() / 2) << "of " << chunks.size();
  size_t next = 0;
  for (const Chunk& chunk : units.beats) {
    while (next < chunks.size() && !(chunks[next] == chunk)) ++next;
    ASSERT_LT(next, chunks.size()) << to_text(config, chunk) << " is not in the walk, or out of order";
  }
}

// Without a clock whenever active_o is low, with units that take a chunk every few hundred cycles: the same frame.
TEST(Dopu, NeedsNoClockWhenItSaysSo) {
  GatedBench<Vpipegs_dopu> bench;
  const Config config = test_config();
  bench.dut.start_i = 0;
  no_feedback(bench);
  ExternalMemory memory({.latency = 300, .bytes_per_cycle = 0.1, .jitter = 100, .queue = 1});
  Units units(bench, config, Pace::kAlways);
  units.rare = 600;
  Memory port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
              bench.dut.rsp_valid_i, bench.dut.rsp_data_i, Pace::kAlways, &bench.dut.mem_lines_o);
  bench.reset();
  const World world(bench.rng, 300, 3 * config.window, 2 * config.window);
  world.load(memory);
  std::vector<Chunk> chunks;
  std::vector<std::pair<size_t, uint64_t>> ends;
  expect(world, chunks, ends);
  write_frame(config, bench.dut, world.frame);
  bench.dut.start_i = 1;
  bench.gated_step();
  bench.dut.start_i = 0;
  for (int i = 0; i < 3000000 && bench.dut.busy_o; ++i) bench.gated_step();
  ASSERT_EQ(bench.dut.busy_o, 0);
  ASSERT_EQ(units.beats, chunks);
  for (const auto& mine : units.ends) ASSERT_EQ(mine, ends);
  EXPECT_GT(bench.gated, bench.cycle / 10) << "of " << bench.cycle << " cycles";
}

// The node tests of a frame in three cycles each, or its chunks in ten, whichever is more; the rest hides behind it.
TEST(Dopu, KeepsItsTestBusy) {
  Bench<Vpipegs_dopu> bench;
  const Config config = test_config();
  bench.dut.start_i = 0;
  no_feedback(bench);
  ExternalMemory memory({.latency = 60, .bytes_per_cycle = 51.2});
  Units units(bench, config, Pace::kAlways);
  Memory port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
              bench.dut.rsp_valid_i, bench.dut.rsp_data_i, Pace::kAlways, &bench.dut.mem_lines_o);
  bench.reset();
  const World world(bench.rng, 20000, 10 * config.window, 7 * config.window);
  world.load(memory);
  DopuCounts sum;
  for (uint64_t y = 0; y <= (config.has_lists() ? 0 : world.frame.raster.windows.last_y); ++y) {
    for (uint64_t x = 0; x <= (config.has_lists() ? 0 : world.frame.raster.windows.last_x); ++x) {
      const DopuCounts part = dopu_window(config, world.frame, world.packed, static_cast<int>(x), static_cast<int>(y),
                                          [](int, const Chunk&, uint64_t) {});
      sum.cell_tests += part.cell_tests, sum.group_tests += part.group_tests, sum.chunk_tests += part.chunk_tests,
          sum.chunks += part.chunks;
    }
  }
  const uint64_t before = bench.cycle;
  start(bench, world);
  ASSERT_TRUE(bench.run_until([&] { return !bench.dut.busy_o; }, 5000000));
  const double tests = static_cast<double>(sum.cell_tests + sum.group_tests + sum.chunk_tests);
  const double bound = std::max(3 * tests, 10.0 * static_cast<double>(sum.chunks)),
               cycles = static_cast<double>(bench.cycle - before);
  RecordProperty("roofline_ratio", std::to_string(cycles / bound));
  std::printf("dopu: %.0f tests, %llu chunks, %.0f cycles, roofline ratio %.3f\n", tests,
              static_cast<unsigned long long>(sum.chunks), cycles, cycles / bound);
  EXPECT_LT(cycles, 1.4 * bound);
}

}  // namespace
}  // namespace pipegs
