// SPDX-License-Identifier: Apache-2.0
// corner_rtl_test: the machine of one random corner (corners.hpp), another one each day, built and simulated: a small
// frame bit for bit, every event at a border of two units in its cycle.
//
// The seed is the day (since 1970), or PIPEGS_SEED; it is printed, with the line that replays it. What the machine was
// built without, and the scene calls for, it has all the same: the models do not say what it does then.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "cpp_model/lib/corners.hpp"
#include "sim/timing/timing_check.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

uint64_t seed_of_today() {
  const char* text = std::getenv("PIPEGS_SEED");
  if (text != nullptr) return std::strtoull(text, nullptr, 0);
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  return static_cast<uint64_t>(today.time_since_epoch().count());
}

// Nobody wants it again. A long name is several folders.
void remove_machine(const Config& config) {
  std::filesystem::path folder = std::filesystem::path(build_rtl(config)).parent_path();
  while (folder.parent_path().filename() != "rtl") folder = folder.parent_path();
  std::filesystem::remove_all(folder);
}

TEST(CornerRtl, DrawsAndTakesWhatItsModelsSay) {
  const uint64_t seed = seed_of_today();
  SimulateOptions options;
  options.memory.dram = kDefaultDram;
  Config& config = options.config = config_corner(seed);
  config.overflow = config.large_groups = config.index_ties = config.taps = 1;
  const std::string which =
      fmt::format("PIPEGS_SEED={} build/verif/design/corner_rtl_test: {}", seed, config_arguments(config));
  SCOPED_TRACE(which);
  fmt::print("{}\n", which);
  Simulation frame;
  simulate_golden(random_scene(seed, 300, static_cast<int>(seed % 4)), test_camera(70, 40), options, frame);
  EXPECT_GT(frame.golden.work.blended, 100u);
  simulate_rtl(options, frame);
  EXPECT_EQ(frame.mismatches, 0u) << frame.first_mismatch->line();
  const TimingTrace trace = timing_trace(frame.input);
  Lockstep lockstep(trace, config, options.memory);
  const RtlTiming rtl = rtl_timing(frame.input, config, options.memory, 1, &lockstep);
  EXPECT_EQ(timing_differences(timing_run(trace, config, options.memory), rtl), std::vector<std::string>{});
  EXPECT_FALSE(lockstep.first()) << lockstep.first()->text();
  if (!HasFailure()) remove_machine(config);
}

}  // namespace
}  // namespace pipegs
