// SPDX-License-Identifier: Apache-2.0
// corner_rtl_test: the machine of one random corner (corners.hpp), built and simulated: a small frame bit for bit,
// every event at a border of two units in its cycle.
//
// The corner is that of PIPEGS_SEED, else of seed 1; .ci/run gives another one each day. What the machine was built
// without, and the scene calls for, it has all the same: the models do not say what it does then.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "cpp_model/lib/corners.hpp"
#include "sim/timing/timing_check.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// Nobody wants it again. A long name is several folders.
void remove_machine(const Config& config) {
  std::filesystem::path folder = std::filesystem::path(build_rtl(config)).parent_path();
  while (folder.parent_path().filename() != "rtl") folder = folder.parent_path();
  std::filesystem::remove_all(folder);
}

TEST(CornerRtl, DrawsAndTakesWhatItsModelsSay) {
  const char* text = std::getenv("PIPEGS_SEED");
  const uint64_t seed = text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
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
