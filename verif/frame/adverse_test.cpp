// SPDX-License-Identifier: Apache-2.0
// adverse_test: windows that an adversary would choose, on `fast`, on one whose pools spill and whose queue of nodes is
// the shortest, and on one that leaves out nothing of what is hidden: all at one depth, a wall of specks, the last
// Gaussian the first to be seen, regions that never close, and such that close while something is asked for them.
//
// Rule    Every stream and pixel as the golden model says, every machine and every way to walk the windows the same
//         picture, and as many cycles as in the timing model.
// Random  Scenes, cameras, ways and memories are drawn (PIPEGS_SEED), and a scene that fails is shrunk.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

#include "sim/compare/simulate.hpp"
#include "sim/rtl/rtl_fault.hpp"
#include "sim/timing/timing_check.hpp"
#include "sim/timing/trace/trace.hpp"
#include "verif/frame/machines.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/support/draws.hpp"
#include "verif/support/shrink.hpp"

namespace pipegs {
namespace {

std::vector<size_t> machines_today() { return todays({kFast, kCrowded, kHidden}); }

// What is wrong with a frame, nothing if it is right.
std::string wrong(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result) {
  try {
    simulate_golden(scene, camera, options, result);
    simulate_rtl(options, result);
  } catch (const RtlFault& fault) { return fault.what(); }
  if (result.mismatches != 0) {
    return fmt::format("window {},{}: {}", result.first_mismatch->window_x, result.first_mismatch->window_y,
                       result.first_mismatch->what);
  }
  const TimingTrace trace = timing_trace(result.input);
  const TimingResult model = timing_run(trace, options.config, options.memory);
  if (model.cycles == result.rtl.cycles) return "";
  Lockstep lockstep(trace, options.config, options.memory);
  rtl_timing(result.input, options.config, options.memory, options.rtl.seed, &lockstep);
  return fmt::format("{} cycles, in the timing model {}: {}", result.rtl.cycles, model.cycles,
                     lockstep.first() ? lockstep.first()->text() : "no event differs");
}

// --- by hand ---------------------------------------------------------------------------------------------------------
const Camera kCamera = test_camera(200, 150);  // four windows of 128 pixels, three of them cut

// So many, spread over the picture in turn.
template <class Depth>
std::vector<Gaussian> spread(int count, Depth&& depth, float pixels, double opacity) {
  std::vector<Gaussian> all;
  std::mt19937_64 rng(3);
  for (int i = 0; i < count; ++i) {
    const auto z = static_cast<float>(depth(i));
    const auto x = static_cast<float>(draw_uniform(rng, -1, 1)), y = static_cast<float>(draw_uniform(rng, -0.75, 0.75));
    const auto shade = static_cast<float>(draw_uniform(rng, -1, 1));
    all.push_back(gaussian_at({z * x, z * y, z}, z * pixels / 100, opacity, {shade, -shade, 0.5f * shade}));
  }
  return all;
}

Scene all_at_one_depth() {
  return scene_of(spread(
      1500, [](int) { return 2; }, 0.8f, 0.4));
}

// In one window, by its first part: the others are empty.
Scene wall_of_specks() {
  std::vector<Gaussian> all = spread(
      1500, [](int i) { return 2 + 0.0001 * (i * 7 % 1000); }, 0.5f, 0.05);
  for (Gaussian& one : all) one.mean.x = one.mean.x * 0.3f - 1.2f, one.mean.y = one.mean.y * 0.4f - 0.7f;
  return scene_of(all);
}

Scene last_is_first_to_be_seen() {
  std::vector<Gaussian> all = spread(
      1000, [](int i) { return 6 - 0.003 * i; }, 2, 0.5);
  for (int i = 0; i < 12; ++i) all.push_back(gaussian_at({0, 0, 0.6f - 0.01f * static_cast<float>(i)}, 4, 0.999));
  return scene_of(all);
}

Scene never_closed() {
  return scene_of(spread(
      400, [](int i) { return 1 + 0.01 * (i % 300); }, 6, 0.5));
}

// Opaque walls of less than a region, the nearest one first, and much behind them.
Scene closing() {
  std::vector<Gaussian> all = spread(
      700, [](int i) { return 3 + 0.003 * i; }, 2, 0.3);
  for (int i = 0; i < 900; ++i) {
    const float z = 1 + 0.001f * static_cast<float>(i), x = static_cast<float>(i % 30) / 14.5f - 1;
    for (int layer = 0; layer < 2; ++layer)
      all.push_back(gaussian_at({z * x, z * (static_cast<float>(i / 30) / 20 - 0.75f), z}, 0.06f, 0.999));
  }
  return scene_of(all);
}

using Window = std::pair<const char*, Scene (*)()>;
struct Adverse : testing::TestWithParam<Window> {};

TEST_P(Adverse, EveryMachineAndEveryWalkGivesTheSamePicture) {
  const Scene scene = GetParam().second();
  std::vector<uint64_t> first;
  for (const size_t number : machines_today()) {
    const std::vector<uint64_t> ways = number == kFast ? std::vector<uint64_t>{1, 600} : std::vector<uint64_t>{0, 1};
    for (const uint64_t most : ways) {
      SimulateOptions options = machine(number);
      SCOPED_TRACE(fmt::format("{}, at most {}", config_difference(options.config), most));
      options.walk_most = most;
      Simulation result;
      ASSERT_EQ(wrong(scene, kCamera, options, result), "");
      if (first.empty()) first = result.golden.pixels;
      EXPECT_EQ(result.golden.pixels, first);
      if (number == kCrowded && (GetParam().second == all_at_one_depth || GetParam().second == wall_of_specks)) {
        EXPECT_GT(result.rtl.overflow_lines, 0u) << "the Sorting Units were meant to spill";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Windows, Adverse,
                         testing::Values(Window{"AllAtOneDepth", all_at_one_depth},
                                         Window{"WallOfSpecks", wall_of_specks},
                                         Window{"LastIsFirstToBeSeen", last_is_first_to_be_seen},
                                         Window{"NeverClosed", never_closed}, Window{"Closing", closing}),
                         [](const auto& instance) { return instance.param.first; });

// Behind any memory: what closes meets what is asked for in other cycles each time.
TEST(AdverseMemory, WhateverItDoes) {
  const Scene scene = closing();
  for (const size_t number : machines_today()) {
    if (number == kHidden) continue;
    uint64_t seed = 1;
    for (const auto& [latency, bandwidth, jitter, queue] :
         {std::tuple{1, 64.0, 0, 256}, {300, 25.6, 300, 4}, {30, 6.4, 100, 1}}) {
      SimulateOptions options = machine(number);
      SCOPED_TRACE(fmt::format("{}, latency {}", config_difference(options.config), latency));
      options.walk_most = seed % 2 == 0 ? 0 : 600;
      options.memory = {
          .latency = latency, .bytes_per_cycle = bandwidth, .jitter = jitter, .queue = queue, .seed = seed};
      options.rtl.seed = seed++;
      Simulation result;
      ASSERT_EQ(wrong(scene, kCamera, options, result), "");
    }
  }
}

// --- at random -------------------------------------------------------------------------------------------------------
uint64_t first_seed() {
  const char* text = std::getenv("PIPEGS_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

struct Draw {
  Scene scene;
  Camera camera;
  SimulateOptions options;
};

// Depths, sizes, opacities and places of one kind each: the extremes come together more often than by chance alone.
Draw draw(uint64_t seed, const std::vector<size_t>& machines) {
  std::mt19937_64 rng(seed);
  const auto one_of = [&](auto... values) {
    const std::common_type_t<decltype(values)...> all[] = {values...};
    return all[rng() % sizeof...(values)];
  };
  Draw d;
  d.options = machine(machines[rng() % machines.size()]);
  d.options.walk_most = one_of(0, 1, 100, 600);
  d.options.memory.latency = one_of(1, 60, 300);
  d.options.memory.jitter = one_of(0, 20, 300);
  d.options.memory.queue = one_of(1, 8, 64);
  d.options.memory.seed = d.options.rtl.seed = seed;
  const auto width = static_cast<int>(draw_integer(rng, 1, 280)), height = static_cast<int>(draw_integer(rng, 1, 200));
  d.camera = test_camera(width, height, one_of(40.0, 100.0, 300.0));
  const int count = static_cast<int>(draw_integer(rng, 1, 900)), depths = one_of(0, 1, 2, 3);
  const double opacity = one_of(0.02, 0.5, 0.9, 0.999), size = one_of(0.4, 3.0, 12.0), wide = one_of(0.2, 1.0, 1.3),
               aside = one_of(-0.5, 0.0, 0.4);
  std::vector<Gaussian> all;
  for (int i = 0; i < count; ++i) {
    const double spread = draw_uniform(rng, 0.8, 9);
    const double z = depths == 0 ? 2 : depths == 1 ? 2 + i % 3 : depths == 2 ? 9 - 8.0 * i / count : spread;
    const double x = z * (aside + wide * draw_uniform(rng, -0.5, 0.5)) * width / d.camera.fx,
                 y = z * (aside + wide * draw_uniform(rng, -0.5, 0.5)) * height / d.camera.fy,
                 pixels = size * draw_uniform(rng, 0.5, 1.5);
    all.push_back(gaussian_at({x, y, z}, static_cast<float>(z * pixels / d.camera.fx), opacity,
                              {static_cast<float>(x), static_cast<float>(y), 0.1f}));
  }
  d.scene = scene_of(std::move(all));
  return d;
}

TEST(AdverseRandom, AnySmallSceneIsRightOrIsShrunk) {
  const std::vector<size_t> machines = machines_today();
  for (uint64_t seed = first_seed(); seed < first_seed() + 12; ++seed) {
    const Draw d = draw(seed, machines);
    const auto fails = [&](const std::vector<Gaussian>& gaussians, std::string& what) {
      Simulation result;
      what = wrong(scene_of(gaussians), d.camera, d.options, result);
      return !what.empty();
    };
    std::string what, text;
    if (!fails(d.scene.gaussians, what)) continue;
    const std::vector<Gaussian> least =
        shrink(d.scene.gaussians, [&](const auto& gaussians) { return fails(gaussians, text); });
    fails(least, what);
    text.clear();
    for (size_t i = 0; i < std::min<size_t>(least.size(), 20); ++i) {
      text += fmt::format("  at {} {} {}, scale {}, opacity logit {}\n", least[i].mean.x, least[i].mean.y,
                          least[i].mean.z, std::exp(least[i].log_scale.x), least[i].opacity_logit);
    }
    ADD_FAILURE() << "PIPEGS_SEED=" << seed << ", " << config_difference(d.options.config) << ", walk_most "
                  << d.options.walk_most << ", " << d.camera.width << "x" << d.camera.height << ", " << least.size()
                  << " Gaussians of " << d.scene.gaussians.size() << ": " << what << "\n"
                  << text;
    return;
  }
}

TEST(AdverseRandom, ShrinkingLeavesOnlyWhatIsToBlame) {
  std::vector<int> list(300);
  std::iota(list.begin(), list.end(), 0);
  int runs = 0;
  const auto fails = [&](const std::vector<int>& some) {
    ++runs;
    return std::count(some.begin(), some.end(), 17) != 0 && std::count(some.begin(), some.end(), 230) != 0;
  };
  EXPECT_EQ(shrink(list, fails), (std::vector<int>{17, 230}));
  EXPECT_LT(runs, 100);
  EXPECT_LT(shrink(list, fails, 5).size(), list.size());
}

}  // namespace
}  // namespace pipegs
