// timing_test: the cycles of the timing model against those of the RTL, on small frames; and the model against itself.
//
// The RTL of each configuration is built before the tests run (verif/frame/CMakeLists.txt).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenes/generate.hpp"
#include "sim/rung.hpp"
#include "sim/simulate.hpp"
#include "sim/timing_check.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr const char* kMemory = "lpddr5-6400x4";
constexpr double kFrame = 0.01, kWindow = 0.03;  // errors allowed

struct View {
  Scene scene;
  Camera camera;
};

// Windows of our own scene from column 6 of row 6 on: the densest part of its first view.
const View& own_view() {
  static const View view{generate_scene(1), generated_cameras()[0]};
  return view;
}

// All that one run needs: the packed scene stays where it is.
struct TimedFrame {
  TimedFrame(const View& view, SimulateOptions options, int windows = 0, std::array<int, 2> first = {6, 6}) : options(std::move(options)) {
    if (windows > 0) this->options.window = first, this->options.windows = windows;
    simulate_pack(view.scene, view.camera, this->options, simulation);
    trace = timing_trace(simulation.input);
  }
  TimingResult run(const TimingOptions& timing = {}) const { return timing_run(trace, options.config, options.memory, timing); }
  RtlTiming rtl() const { return rtl_timing(simulation.input, options.config, options.memory); }

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

SimulateOptions rung(std::string_view name) {
  SimulateOptions options;
  options.memory.dram = kMemory;
  apply_rung(find_rung(name), options.config);
  return options;
}

void expect_alike(const TimedFrame& frame) {
  SCOPED_TRACE(config_difference(frame.options.config));
  const TimingResult model = frame.run();
  const RtlTiming rtl = frame.rtl();
  const TimingErrors errors = timing_errors(model, rtl);
  EXPECT_LE(std::abs(errors.frame), kFrame) << "model " << model.cycles << " cycles, RTL " << rtl.cycles;
  EXPECT_LE(std::abs(errors.worst_window), kWindow);
  EXPECT_EQ(model.window_ends.size(), rtl.window_ends.size());
  const double lines = static_cast<double>(rtl.overflow_lines);
  EXPECT_NEAR(static_cast<double>(model.overflow_lines), lines, 0.03 * lines) << "lines that overflow";
}

TEST(Timing, EveryRungOnOurOwnScene) {
  for (const Rung& one : rungs()) {
    SCOPED_TRACE(one.name);
    expect_alike(TimedFrame(own_view(), rung(one.name), 3));
  }
}

TEST(Timing, HalfAndQuarterOfTheMachine) {
  expect_alike(TimedFrame(own_view(), machine({"units=2", "pixels_per_row=1", "grid=8"}), 2));
  expect_alike(TimedFrame(own_view(), machine({"units=1", "alpha_lines=64", "records=16"}), 1));
}

TEST(Timing, OtherMemories) {
  for (const char* name : {"late", "tspp"}) {
    SimulateOptions options = rung(name);
    options.memory.dram = "lpddr5-6400x1";
    expect_alike(TimedFrame(own_view(), options, 2));
    options.memory = {.dram = "ideal", .latency = 300, .bytes_per_cycle = 12.8, .jitter = 100};
    expect_alike(TimedFrame(own_view(), options, 2));
  }
}

TEST(Timing, FramesOfLittleWork) {
  const std::vector<View> views = {{scene_of({}), test_camera(100, 70)},
                                   {scene_of({gaussian_at({0.1f, 0.05f, 2})}), test_camera(64, 64)},
                                   {random_scene(3, 400, 1), test_camera(130, 9, 60)},
                                   {random_scene(9, 300, 0), test_camera(128, 96)}};
  for (const View& view : views) {
    for (const char* name : {"dop", "dpc", "exact"}) expect_alike(TimedFrame(view, rung(name)));
  }
}

// A watermark leaves its PU with the stage in front of the SU, though the SU may not take it for long. In these windows that
// is the place for one more: whether the DOPU waits for it decides what it opens next. Compared to the cycle: it makes less
// than kFrame.
TEST(Timing, AWatermarkThatWaitsBeforeAnSuIsNoLongerInItsPu) {
  const TimedFrame frame(own_view(), machine({"units=2", "late=1", "order=2", "records=16"}), 3, {8, 3});
  const TimingResult model = frame.run();
  const RtlTiming rtl = frame.rtl();
  EXPECT_EQ(model.cycles, rtl.cycles);
  EXPECT_EQ(model.window_ends, rtl.window_ends);
}

// A unit is stepped only in cycles for which it was woken: those left out must not matter.
TEST(Timing, SteppingEveryUnitInEveryCycleChangesNothing) {
  for (const Rung& one : rungs()) {
    SCOPED_TRACE(one.name);
    for (const bool tiny : {false, true}) {
      SimulateOptions options = rung(one.name);
      if (tiny) {
        for (const char* setting : {"alpha_lines=64", "fetch_lines=4", "nearest_nodes=16"}) config_set(options.config, setting);
        config_set(options.config, "records=16");
      }
      const TimedFrame frame(own_view(), options, 2);
      const TimingResult woken = frame.run(), always = frame.run({.every_cycle = true});
      EXPECT_EQ(woken.cycles, always.cycles) << (tiny ? "stores that overflow" : "");
      EXPECT_EQ(woken.window_ends, always.window_ends);
      EXPECT_EQ(woken.overflow_lines, always.overflow_lines);
      if (tiny) EXPECT_GT(woken.overflow_lines, 0u);
    }
  }
}

TEST(Timing, ATraceServesAllThatDifferInStoresAndUnits) {
  const TimedFrame frame(own_view(), rung("dop"), 2);
  const TimedFrame other(own_view(), machine({"units=2", "alpha_lines=128", "late=1"}), 2);
  EXPECT_EQ(timing_run(frame.trace, other.options.config, other.options.memory).cycles, other.run().cycles);
  EXPECT_THROW(timing_run(frame.trace, machine({"grid=8"}).config), std::invalid_argument);
  EXPECT_THROW(timing_run(frame.trace, machine({"order=1"}).config), std::invalid_argument);
}

TEST(Timing, ATraceDoesNotDependOnThreads) {
  for (const char* name : {"dop", "dpc", "exact"}) {
    const TimedFrame frame(own_view(), rung(name), 3);
    const TimingTrace one = timing_trace(frame.simulation.input, 1);
    EXPECT_EQ(one.key, frame.trace.key);
    EXPECT_EQ(one.mask, frame.trace.mask);
    EXPECT_EQ(one.chunks_sent.size(), frame.trace.chunks_sent.size());
    EXPECT_EQ(timing_run(one, frame.options.config, frame.options.memory).cycles, frame.run().cycles);
  }
}

}  // namespace
}  // namespace pipegs
