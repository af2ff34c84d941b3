// SPDX-License-Identifier: Apache-2.0
// dopu_test: rtl/dopu/pipegs_dopu.sv whole, on random packed scenes, against the walk of its bit-accurate model.
#include "verif/dopu/dopu_bench.hpp"

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

using Ends = std::vector<std::pair<size_t, uint64_t>>;

TEST(Dopu, EqualsItsModelWhateverStandsAroundIt) {
  for (const Around& around : kAround) {
    SCOPED_TRACE(around.name);
    Dopu<> dopu(around.memory, around.pace, around.memory_pace);
    Units& units = dopu.units;
    std::vector<Chunk> chunks;
    Ends ends;
    six_frames(
        dopu,
        [&](const World& world) {
          chunks.clear(), ends.clear(), units.beats.clear();
          for (auto& mine : units.ends) mine.clear();
          expect(world, chunks, ends);
        },
        [&](const World& world) {
          ASSERT_EQ(units.beats.size(), chunks.size());
          for (size_t i = 0; i < chunks.size(); ++i) {
            ASSERT_EQ(first_difference(world.config, chunks[i], units.beats[i]), "")
                << "chunk " << i << " of " << chunks.size();
          }
          for (const auto& mine : units.ends) ASSERT_EQ(mine, ends);
        });
    for (int u = 1; u < dopu.config.units; ++u)
      EXPECT_GT(units.count[u] * 3, units.count[0]) << "unit " << u << " got too little";
  }
}

// The RUs report a window done after it got some chunks: what comes after is a subset in order, and every end still
// comes.
TEST(Dopu, SkipsTheRestOfAWindowThatIsDone) {
  Dopu<> dopu({.latency = 40});
  const Config& config = dopu.config;
  Units& units = dopu.units;
  Feedback feedback(dopu.bench, units, config);
  const World world(dopu.bench.rng, 20000, 200, 150);
  std::vector<Chunk> chunks;
  Ends ends;
  expect(world, chunks, ends);
  feedback.frame = &world.frame;
  dopu.frame(world);
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
  Dopu<GatedBench<Vpipegs_dopu>> dopu({.latency = 300, .bytes_per_cycle = 0.1, .jitter = 100, .queue = 1});
  dopu.units.rare = 600;
  const World world(dopu.bench.rng, 300, 3 * dopu.config.window, 2 * dopu.config.window);
  std::vector<Chunk> chunks;
  Ends ends;
  expect(world, chunks, ends);
  dopu.frame(world, true);
  ASSERT_EQ(dopu.units.beats, chunks);
  for (const auto& mine : dopu.units.ends) ASSERT_EQ(mine, ends);
  EXPECT_GT(dopu.bench.gated, dopu.bench.cycle / 10) << "of " << dopu.bench.cycle << " cycles";
}

// The node tests of a frame in three cycles each, or its chunks in ten, whichever is more; the rest hides behind it.
TEST(Dopu, KeepsItsTestBusy) {
  Dopu<> dopu({.latency = 60, .bytes_per_cycle = 51.2});
  const World world(dopu.bench.rng, 20000, 10 * dopu.config.window, 7 * dopu.config.window);
  const DopuCounts sum = dopu_counts(world);
  const double tests = static_cast<double>(sum.cell_tests + sum.group_tests + sum.chunk_tests);
  const double bound = std::max(3 * tests, 10.0 * static_cast<double>(sum.chunks)),
               cycles = static_cast<double>(dopu.frame(world));
  RecordProperty("roofline_ratio", std::to_string(cycles / bound));
  std::printf("dopu: %.0f tests, %llu chunks, %.0f cycles, roofline ratio %.3f\n", tests,
              static_cast<unsigned long long>(sum.chunks), cycles, cycles / bound);
  EXPECT_LT(cycles, 1.4 * bound);
}

}  // namespace
}  // namespace pipegs
