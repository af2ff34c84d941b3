// SPDX-License-Identifier: Apache-2.0
// Against cpp_model/config and cpp_model/corners: what the check lets through, models and packers can do; what the
// machine cannot be built for is refused in one line.
//
// The corners are those of the seeds 1 to kSeeds; PIPEGS_SEED=n tries those from n on. That Verilator and Yosys read
// the machine of a corner is what `synth/lint.sh --corners` shows.
#include "cpp_model/lib/corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>

#include "cpp_model/control/registers.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/bounds/frame.hpp"
#include "sim/design/design_point.hpp"
#include "sim/timing/timing_model.hpp"
#include "sim/timing/trace/trace.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/stability/support/pu_walk.hpp"
#include "verif/support/records_fit.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kSeeds = 60;

uint64_t first_seed() {
  const char* text = std::getenv("PIPEGS_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

Config with(const std::vector<std::string>& settings) {
  Config config;
  for (const std::string& setting : settings) config_set(config, setting);
  return config;
}

std::string refused(const Config& config) {
  try {
    config_check(config);
  } catch (const ConfigError& error) { return error.what(); }
  return "accepted";
}

TEST(Corners, ANodeHas256Bits) {
  EXPECT_EQ(refused(with({"world_w=44", "scale_m_w=14"})), "accepted");
  EXPECT_EQ(record_width<Node>(with({"world_w=44", "scale_m_w=14"})), 256);
  EXPECT_EQ(refused(with({"world_w=44", "scale_m_w=15"})),
            "configuration: a node has 257 bits, expected at most 256: world_w or scale_m_w must be smaller");
  const std::vector<std::string> boxes = {"late=1", "order=2", "tight_boxes=1", "world_w=40"};
  EXPECT_EQ(refused(with(boxes)), "accepted");
  Config config = with(boxes);
  config.scale_m_w = 13;
  EXPECT_EQ(record_width<Node>(config), 257);
  EXPECT_NE(refused(config).find("a node has 257 bits, expected at most 256"), std::string::npos);
}

// With fewer places the cells of a window on trial fill the queue, and no group can be counted: the DOPU hangs.
TEST(Corners, EachUnitHasARegionOfAWindow) {
  EXPECT_EQ(refused(with({"window=16", "units=4"})), "accepted");
  EXPECT_EQ(refused(with({"window=16", "units=8"})),
            "configuration: units = 8, expected with window = 16 at most its regions = 4");
}

TEST(Corners, TheQueueHoldsAWindowOnTrial) {
  const std::vector<std::string> walks = {"late=1", "order=2", "quads=1", "window=128"};
  Config config = with(walks);
  config.nearest_nodes = 128;
  EXPECT_EQ(refused(config), "accepted");
  config.nearest_nodes = 64;
  EXPECT_EQ(refused(config), "configuration: nearest_nodes = 64, expected with window = 128 at least 2 grid^3 = 128");
  config.window = 64;
  EXPECT_EQ(refused(config), "accepted");
}

TEST(Corners, AreLegalAndTheSameForASeed) {
  for (uint64_t seed = first_seed(); seed < first_seed() + 10; ++seed) {
    const Config config = config_corner(seed);
    EXPECT_EQ(refused(config), "accepted") << "seed " << seed;
    EXPECT_EQ(config, config_corner(seed));
    EXPECT_NE(config, config_corner(seed + 1));
    std::istringstream text(config_arguments(config));
    EXPECT_EQ(with({std::istream_iterator<std::string>(text), {}}), config) << "seed " << seed;
  }
  EXPECT_EQ(config_arguments(Config{}), "");
}

// Each end of each entry's range is in some corner.
TEST(Corners, ReachBothEndsOfEveryEntry) {
  constexpr int kMany = 1000;
  std::vector<Config> corners;
  for (int seed = 1; seed <= kMany; ++seed) corners.push_back(config_corner(static_cast<uint64_t>(seed)));
  for (const ConfigEntry& entry : config_entries(Config{})) {
    if (entry.member == nullptr) continue;
    for (const int end : {entry.low, entry.high}) {
      EXPECT_GE(std::ranges::count_if(corners, [&](const Config& c) { return c.*entry.member == end; }), kMany / 100)
          << entry.name << " = " << end;
    }
  }
}

// Half a line holds a node, a line one or two Gaussians or four codes, a splat that a Sorting Unit spills or a list
// keeps, the SH of degree 3; the part of a key in a list has 64 bits, and so has a slot of the registers.
void expect_room(const Config& config, const std::string& which) {
  EXPECT_LE(record_width<Node>(config), config.memory_w() / 2) << which;
  const int geometry = config.coded() ? record_width<GaussianCode>(config) : record_width<GaussianRecord>(config);
  EXPECT_LE(geometry, config.memory_w() / config.gaussians_per_line()) << which;
  EXPECT_LE(record_width<Splat>(config), config.memory_w()) << which;
  EXPECT_LE(45 * config.sh_m_w + config.sh_e_w, config.memory_w()) << which;
  EXPECT_LE(config.key_w(), 64) << which;
  EXPECT_NO_THROW(register_map(config)) << which;
}

TEST(Corners, EveryRecordHasItsPlaceInMemory) {
  for (uint64_t seed = first_seed(); seed < first_seed() + 40 * kSeeds; ++seed) {
    const Config config = config_corner(seed);
    expect_room(config, "seed " + std::to_string(seed) + ": " + config_arguments(config));
  }
}

struct Frames {
  SimulateOptions options;
  Scene scene;
  Camera camera = test_camera(70, 40);
  std::string which;
};

Frames small_frame(uint64_t seed) {
  Frames frame;
  frame.options.config = config_corner(seed);
  frame.scene = random_scene(seed, 300, static_cast<int>(seed % 4));
  frame.which = "PIPEGS_SEED=" + std::to_string(seed) + ": " + config_arguments(frame.options.config);
  return frame;
}

// Whole small frames: every record that a model passes on fits its fields, and something is drawn.
TEST(Corners, TheModelsCanDoThem) {
  for (uint64_t seed = first_seed(); seed < first_seed() + kSeeds; ++seed) {
    const Frames frame = small_frame(seed);
    Simulation simulation;
    ASSERT_NO_THROW(simulate_golden(frame.scene, frame.camera, frame.options, simulation)) << frame.which;
    EXPECT_GT(simulation.golden.work.blended, 100u) << frame.which;
    std::string first;
    const auto fits = [&](const auto& record) {
      if (first.empty()) first = misfit(frame.options.config, record);
    };
    pu_walk(simulation.packed, simulation.input.frame, fits, [](int64_t, int64_t) {});
    for (const std::vector<Node>* nodes : {&simulation.packed.cells, &simulation.packed.groups}) {
      for (const Node& node : *nodes) fits(node);
    }
    EXPECT_EQ(first, "") << frame.which;
  }
}

// The control of a corner comes to an end, too: no unit waits for ever.
TEST(Corners, TheTimingModelEndsTheFrame) {
  for (uint64_t seed = first_seed(); seed < first_seed() + kSeeds; ++seed) {
    Frames frame = small_frame(seed);
    Config& config = frame.options.config;
    config.overflow = config.large_groups = config.index_ties = 1;  // what these leave out, a scene must not call for
    Simulation simulation;
    simulate_pack(frame.scene, frame.camera, frame.options, simulation);
    const TimingTrace trace = timing_trace(simulation.input);
    TimingResult result;
    ASSERT_NO_THROW(result = timing_run(trace, config, frame.options.memory)) << frame.which;
    EXPECT_GT(result.cycles, 100u) << frame.which;
  }
}

// With every effect that the scene may call for, each pixel is as near to the truth as the formats promise.
TEST(Corners, ThePictureKeepsItsBounds) {
  for (uint64_t seed = first_seed(); seed < first_seed() + kSeeds; ++seed) {
    Frames frame = small_frame(seed);
    Config& config = frame.options.config;
    config.near_test = config.guard_band = config.saturation = config.early_stop = 1;
    config.layered = config.index_ties = 1;
    ASSERT_EQ(refused(config), "accepted") << frame.which;
    Simulation simulation;
    simulate_golden(frame.scene, frame.camera, frame.options, simulation);
    const BudgetReport report = budget_frame(frame.scene, frame.camera, frame.options, simulation);
    EXPECT_TRUE(report.holds()) << *report.first << "; " << frame.which;
    EXPECT_GT(report.pairs, 100u) << frame.which;
  }
}

// Else it would be built once more when it first runs.
TEST(Machines, TheDefaultIsLookedForWhereCMakeBuildsIt) {
  const Config config = find_design_point(kDefaultDesignPoint).config;
  const auto folder = std::filesystem::path(build_rtl(config)).parent_path();
  EXPECT_EQ(folder.parent_path().filename(), "rtl");
  EXPECT_EQ(folder.filename(), config_difference(config));
}

}  // namespace
}  // namespace pipegs
