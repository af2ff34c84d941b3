// SPDX-License-Identifier: Apache-2.0
// sequence_scenes_test: real frames one after the other, each queued behind the one before, on a bus that does all that
// AXI4 allows, and given up in the middle again and again; every stream and pixel compared.
//
// Idea    Our own scene, terrace, our own scene from elsewhere. Memory applies writes hundreds of cycles late, answers
//         in another order than it was asked, and lets its readies fall at random. An abort, a failing read and a
//         failing write come in turn, at any cycle of whatever frame is inside then.
// Needs   scenes/terrace of the shared folder and xz, else our own scene alone: it says so.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <random>

#include "scenes/generate/generate.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/sequence.hpp"
#include "verif/support/shared.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

// Nothing where it is not.
Scene terrace() {
  const fs::path packed = shared_folder() / "scenes/terrace/terrace.ply.xz",
                 ply = fs::temp_directory_path() / fmt::format("pipegs_terrace_{}.ply", getpid());
  Scene scene;
  if (fs::exists(packed) && std::system(fmt::format("xz -dc '{}' > '{}'", packed.string(), ply.string()).c_str()) == 0)
    scene = read_ply(ply);
  fs::remove(ply);
  return scene;
}

class SequenceScenes : public testing::TestWithParam<const char*> {};

TEST_P(SequenceScenes, SurviveWhateverABusDoes) {
  constexpr uint64_t kDisturbances = 6, kCycles = 400000;  // how late the latest comes in its frame
  const Scene own = generate_scene(1), other = terrace();
  const std::vector<Camera> views = generated_cameras();
  SimulateOptions options;
  options.config = find_design_point(GetParam()).config;
  options.memory.harsh = true;
  options.memory.seed = options.rtl.seed = 5;
  std::mt19937_64 rng(1);
  for (uint64_t i = 0; i < kDisturbances; ++i)
    options.rtl.disturbances.push_back({i, rng() % kCycles, static_cast<RtlDisturbance::Kind>(i % 3)});
  Sequence sequence(options);
  sequence.add(own, views[0]);
  if (other.gaussians.empty()) {
    fmt::print("skipped: no terrace in {} (set PIPEGS_SHARED), or no xz; our own scene alone\n",
               shared_folder().string());
  } else {
    sequence.add(other, read_cameras(shared_folder() / "scenes/terrace/cameras.json").at(0));
  }
  sequence.add(own, views[2]);
  sequence.expect_equal(true);
}

INSTANTIATE_TEST_SUITE_P(DesignPoints, SequenceScenes,
                         testing::Values("dop", "late", "tspp", "dpc", "baseline", "gscore", "exact", "fast"),
                         [](const auto& point) { return std::string(point.param); });

}  // namespace
}  // namespace pipegs
