// SPDX-License-Identifier: Apache-2.0
// timing_test: the timing model against the RTL, on small frames; and the model against itself.
//
// Rule    Cycles of the frame and of each window, bytes of each stream and every event at a border of two units in
//         every cycle (sim/timing/lockstep.hpp) are the same. A failure names the first cycle and unit in which they
//         part. The RTL of each configuration is built before the tests run (verif/frame/CMakeLists.txt).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "scenes/generate/generate.hpp"
#include "sim/design/design_point.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/timing/timing_check.hpp"
#include "verif/frame/machines.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

constexpr const char* kMemory = "lpddr5-6400x4";

struct View {
  Scene scene;
  Camera camera;
};

// Our own scene; frames of a few windows begin at its pixel (384, 384), the densest part of its first view.
const View& own_view() {
  static const View view{generate_scene(1), generated_cameras()[0]};
  return view;
}

// All that one run needs: the packed scene stays where it is.
struct TimedFrame {
  TimedFrame(const View& view, SimulateOptions given, int windows = 0, std::array<int, 2> pixel = {384, 384})
      : options(std::move(given)) {
    const int side = options.config.window, x = pixel[0] / side * side, y = pixel[1] / side * side;
    if (windows > 0)
      options.crop = {x, y, std::min(x + windows * side, view.camera.width), std::min(y + side, view.camera.height)};
    simulate_pack(view.scene, view.camera, this->options, simulation);
    trace = timing_trace(simulation.input);
  }
  TimingResult run(const TimingOptions& timing = {}) const {
    return timing_run(trace, options.config, options.memory, timing);
  }
  RtlTiming rtl(Lockstep& lockstep) const {
    return rtl_timing(simulation.input, options.config, options.memory, 1, &lockstep);
  }

  SimulateOptions options;
  Simulation simulation;
  TimingTrace trace;
};

SimulateOptions machine(const std::vector<std::string>& settings) {
  SimulateOptions options;
  options.memory.dram = kMemory;
  for (const std::string& setting : settings) config_set(options.config, setting);
  return options;
}

SimulateOptions design_point(std::string_view name) {
  SimulateOptions options;
  options.memory.dram = kMemory;
  options.config = find_design_point(name).config;
  return options;
}

// One that whole frames are tested on: its RTL is there.
SimulateOptions frame_machine(size_t number) {
  SimulateOptions options = pipegs::machine(number);
  options.memory = {.dram = kMemory};
  return options;
}

// Tells how many lines overflowed.
uint64_t expect_exact(const TimedFrame& frame) {
  SCOPED_TRACE(config_difference(frame.options.config));
  Lockstep lockstep(frame.trace, frame.options.config, frame.options.memory);
  const RtlTiming rtl = frame.rtl(lockstep);
  EXPECT_EQ(timing_differences(frame.run(), rtl), std::vector<std::string>{});
  EXPECT_FALSE(lockstep.first()) << lockstep.first()->text();
  EXPECT_GT(lockstep.events(), rtl.window_ends.size());
  return rtl.overflow_lines;
}

TEST(Timing, EveryDesignPointOnOurOwnScene) {
  for (const DesignPoint& one : design_points()) {
    if (!there_today(one.config)) continue;
    SCOPED_TRACE(one.name);
    expect_exact(TimedFrame(own_view(), design_point(one.name), 3));
  }
}

// Half of it behind a narrower bus, with clocks that never stop.
TEST(Timing, HalfAndQuarterOfTheMachine) {
  for (const size_t half : todays({kHalf})) expect_exact(TimedFrame(own_view(), frame_machine(half), 2));
  EXPECT_GT(expect_exact(TimedFrame(own_view(), frame_machine(kTiny), 1)), 0u);
}

// The lanes of `exact`, with the numbers of sim/fine.cfg, blend living quads only. Behind a slow memory the RUs wait
// for splats, behind a fast one for the pixels of the window before.
TEST(Timing, LivingQuads) {
  for (const size_t fine : todays({kFine})) {
    SimulateOptions options = frame_machine(fine);
    expect_exact(TimedFrame(own_view(), options, 3));
    expect_exact(TimedFrame({random_scene(9, 300, 0), test_camera(130, 97)}, options));
    options.memory = {.dram = "ideal", .latency = 2, .bytes_per_cycle = 64, .jitter = 3};
    const TimedFrame frame(own_view(), options, 3);
    expect_exact(frame);
    EXPECT_EQ(frame.run().cycles, frame.run({.every_cycle = true}).cycles);
  }
}

// `fast`; its frame of our own scene is that of every design point.
TEST(Timing, WindowsOfFourParts) {
  SimulateOptions options = design_point("fast");
  expect_exact(TimedFrame({random_scene(9, 300, 0), test_camera(260, 150)}, options));
  options.memory = {.dram = "ideal", .latency = 2, .bytes_per_cycle = 64, .jitter = 3};
  const TimedFrame frame({random_scene(9, 900, 0), test_camera(130, 97)}, options);
  expect_exact(frame);
  EXPECT_EQ(frame.run().cycles, frame.run({.every_cycle = true}).cycles);
}

// Groups' ranges are chosen a cycle later, proxies or not.
TEST(Timing, ProxiesOfGroups) {
  for (const size_t number : todays({kHidden, kCrowded})) {
    for (const double pixels : {0.0, 16.0}) {
      SCOPED_TRACE(pixels);
      SimulateOptions options = frame_machine(number);
      options.lod_pixels = pixels;
      expect_exact(TimedFrame(own_view(), options, 4));
    }
  }
}

// Windows are counted, and go whole or by parts, also with more than the SUs hold.
TEST(Timing, WindowsWalkedPartByPart) {
  for (const uint64_t most : {0, 1, 600}) {
    SCOPED_TRACE(most);
    SimulateOptions options = design_point("fast");
    options.walk_most = most;
    expect_exact(TimedFrame({random_scene(9, 900, 0), test_camera(300, 150)}, options));
    options.memory = {.dram = "ideal", .latency = 2, .bytes_per_cycle = 64, .jitter = 3};
    const TimedFrame frame({random_scene(9, 900, 0), test_camera(130, 97)}, options);
    expect_exact(frame);
    EXPECT_EQ(frame.run().cycles, frame.run({.every_cycle = true}).cycles);
  }
  SimulateOptions options = design_point("fast");
  options.walk_most = 1;
  expect_exact(TimedFrame(own_view(), options, 3));
  std::vector<Gaussian> wall;  // one depth: no watermark releases any of it
  for (int i = 0; i < 28900; ++i) {
    const float x = 0.008f * static_cast<float>(i % 170), y = 0.008f * static_cast<float>(i / 170);
    wall.push_back(gaussian_at({x - 0.68f, y - 0.68f, 2}, 0.006f, 0.02));
  }
  EXPECT_GT(expect_exact(TimedFrame({scene_of(wall), test_camera(128, 128)}, options)), 0u);
}

// A wall that is opaque from the left on, and much behind it: regions close one after the other, all at once, or never.
Scene wall_before(int columns, float opacity) {
  std::vector<Gaussian> all;
  for (int i = 0; i < columns * 24; ++i) {
    const float x = 0.06f * static_cast<float>(i % columns) - 0.7f, y = 0.06f * static_cast<float>(i / columns) - 0.7f;
    for (int layer = 0; layer < 3; ++layer)
      all.push_back(gaussian_at({x, y, 2 + 0.01f * static_cast<float>(layer)}, 0.08f, opacity));
  }
  std::mt19937_64 rng(5);
  for (int i = 0; i < 6000; ++i) {
    const auto at = [&](double low, double high) { return static_cast<float>(draw_uniform(rng, low, high)); };
    const float z = at(2.5, 8);
    const float x = z * at(-0.4, 0.4), y = z * at(-0.4, 0.4);
    all.push_back(gaussian_at({x, y, z}, 0.02f, 0.3f));
  }
  return scene_of(all);
}

TEST(Timing, WhatLiesBesideTheOpenRectangleIsLeftOut) {
  for (const size_t number : todays({kFast, kCrowded})) {
    SimulateOptions options = frame_machine(number);
    if (number != kFast) expect_exact(TimedFrame(own_view(), options, 3));
    for (const int columns : {0, 6, 17, 24}) {
      for (const uint64_t most : {0, 1}) {
        SCOPED_TRACE(columns);
        options.walk_most = most;
        const TimedFrame frame({wall_before(columns, 0.99f), test_camera(300, 150)}, options);
        expect_exact(frame);
        EXPECT_EQ(frame.run().cycles, frame.run({.every_cycle = true}).cycles);
      }
    }
    options.memory = {.dram = "ideal", .latency = 2, .bytes_per_cycle = 64, .jitter = 3};
    expect_exact(TimedFrame({wall_before(24, 0.99f), test_camera(130, 97)}, options));
    expect_exact(TimedFrame({wall_before(24, 0.5f), test_camera(130, 97)}, options));
  }
}

TEST(Timing, OtherMemories) {
  for (const char* name : {"dop", "late", "tspp", "exact"}) {
    SimulateOptions options = design_point(name);
    if (!there_today(options.config)) continue;
    options.memory.dram = "lpddr5-6400x1";
    expect_exact(TimedFrame(own_view(), options, 1));
    options.memory = {.dram = "ideal", .latency = 300, .bytes_per_cycle = 12.8, .jitter = 100};
    expect_exact(TimedFrame(own_view(), options, 1));
    options.memory = {
        .dram = "ideal", .latency = 2, .bytes_per_cycle = 64, .jitter = 3};  // hides no unit's first steps
    expect_exact(TimedFrame(own_view(), options, 2));
  }
}

TEST(Timing, SmallStoresBehindAMemoryOfRandomLatency) {
  for (const size_t number : {kTiny, kTinyExact}) {
    SimulateOptions options = frame_machine(number);
    options.memory = {.dram = "ideal", .latency = 40, .bytes_per_cycle = 64, .jitter = 200};
    EXPECT_GT(expect_exact(TimedFrame(own_view(), options, 1)), 0u);
  }
}

// Half lines, and words below the picture that are not written; behind a fast memory the RUs wait for their pixels.
TEST(Timing, PixelsInRasterOrder) {
  const View odd{random_scene(9, 300, 0), test_camera(130, 97)};
  for (const char* name : {"dop", "late", "tspp", "fast"}) {
    SCOPED_TRACE(name);
    SimulateOptions options = design_point(name);
    if (!there_today(options.config)) continue;
    options.raster = true;
    expect_exact(TimedFrame(odd, options));
    expect_exact(TimedFrame(own_view(), options, 2));
    options.memory = {.dram = "ideal", .latency = 2, .bytes_per_cycle = 64, .jitter = 3};
    expect_exact(TimedFrame(odd, options));
  }
  for (const size_t fine : todays({kFine})) {
    SimulateOptions options = frame_machine(fine);
    options.raster = true;
    expect_exact(TimedFrame(odd, options));
  }
}

TEST(Timing, FramesOfLittleWork) {
  const std::vector<View> views = {{scene_of({}), test_camera(100, 70)},
                                   {scene_of({gaussian_at({0.1f, 0.05f, 2})}), test_camera(64, 64)},
                                   {random_scene(3, 400, 1), test_camera(130, 9, 60)},
                                   {random_scene(9, 300, 0), test_camera(128, 96)}};
  for (const View& view : views) {
    for (const char* name : {"dop", "dpc", "gscore", "exact"}) {
      if (there_today(design_point(name).config)) expect_exact(TimedFrame(view, design_point(name)));
    }
  }
}

// The comparison itself: a model whose memory answers one cycle later, and one whose trace has one line more to blend.
TEST(Timing, WhereTheyPartIsNamed) {
  SimulateOptions options = design_point("dop");
  options.memory = {.dram = "ideal", .latency = 100};
  const TimedFrame frame(own_view(), options, 2);
  ExternalMemoryOptions slower = options.memory;
  ++slower.latency;
  Lockstep lockstep(frame.trace, options.config, slower);
  const RtlTiming rtl = frame.rtl(lockstep);
  ASSERT_TRUE(lockstep.first());
  EXPECT_GE(lockstep.first()->cycle, 100);
  EXPECT_LT(lockstep.first()->cycle, 4000);  // the table of cells is asked for at once, and the planes take longer
  EXPECT_EQ(lockstep.first()->model, "nothing");
  const std::vector<std::string> lines = timing_differences(timing_run(frame.trace, options.config, slower), rtl);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines[0].rfind("cycles: RTL", 0), 0u) << lines[0];

  TimingTrace other = frame.trace;
  TimingWindow& last = other.windows.back();
  const auto blended = std::find_if(last.done_after.begin(), last.done_after.end(),
                                    [](uint32_t lines) { return lines != TimingWindow::kNotDone; });
  ASSERT_NE(blended, last.done_after.end());
  *blended = TimingWindow::kNotDone;
  Lockstep with_other(other, options.config, options.memory);
  frame.rtl(with_other);
  ASSERT_TRUE(with_other.first());
  EXPECT_GT(with_other.first()->cycle, static_cast<int64_t>(rtl.window_ends[0]));
  EXPECT_GT(with_other.events(), lockstep.events());
}

// A unit is stepped only in cycles for which it was woken: those left out must not matter.
TEST(Timing, SteppingEveryUnitInEveryCycleChangesNothing) {
  for (const DesignPoint& one : design_points()) {
    SCOPED_TRACE(one.name);
    for (const bool tiny : {false, true}) {
      SimulateOptions options = design_point(one.name);
      if (tiny) {
        for (const char* setting : {"alpha_lines=64", "fetch_lines=4", "records=16"})
          config_set(options.config, setting);
        options.config.nearest_nodes = options.config.has_walks() ? 128 : 16;
      }
      const TimedFrame frame(own_view(), options, 2);
      const TimingResult woken = frame.run(), always = frame.run({.every_cycle = true});
      EXPECT_EQ(woken.cycles, always.cycles) << (tiny ? "stores that overflow" : "");
      EXPECT_EQ(woken.window_ends, always.window_ends);
      EXPECT_EQ(woken.overflow_lines, always.overflow_lines);
      const ExternalMemoryOptions fast = {.dram = "ideal", .latency = 2};
      EXPECT_EQ(timing_run(frame.trace, options.config, fast).cycles,
                timing_run(frame.trace, options.config, fast, {.every_cycle = true}).cycles);
      if (tiny) EXPECT_GT(woken.overflow_lines, 0u);
    }
  }
}

TEST(Timing, ATraceServesAllThatDifferInStoresAndUnits) {
  const TimedFrame frame(own_view(), design_point("dop"), 2);
  const TimedFrame other(own_view(), machine({"units=2", "alpha_lines=128", "late=1"}), 2);
  EXPECT_EQ(timing_run(frame.trace, other.options.config, other.options.memory).cycles, other.run().cycles);
  EXPECT_THROW(timing_run(frame.trace, machine({"grid=8"}).config), std::invalid_argument);
  EXPECT_THROW(timing_run(frame.trace, machine({"order=1"}).config), std::invalid_argument);
}

TEST(Timing, ATraceDoesNotDependOnThreads) {
  for (const char* name : {"dop", "dpc", "exact"}) {
    const TimedFrame frame(own_view(), design_point(name), 3);
    const TimingTrace one = timing_trace(frame.simulation.input, 1);
    EXPECT_EQ(one.key, frame.trace.key);
    EXPECT_EQ(one.mask, frame.trace.mask);
    EXPECT_EQ(one.chunks_sent.size(), frame.trace.chunks_sent.size());
    EXPECT_EQ(timing_run(one, frame.options.config, frame.options.memory).cycles, frame.run().cycles);
  }
}

}  // namespace
}  // namespace pipegs
