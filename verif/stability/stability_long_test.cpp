// SPDX-License-Identifier: Apache-2.0
// Hard loads that take a while: a hundred thousand equal depths, and one tile that holds a quarter of a million
// Gaussians.
#include <cmath>

#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

TEST(StabilityLong, HundredThousandEqualDepths) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 100000; ++i) {
    gaussians.push_back(
        gaussian_at({0.002f * static_cast<float>(i % 320 - 160), 0.0015f * static_cast<float>(i / 320 - 156), 2},
                    0.004f, 0.3, {static_cast<float>(i % 7) / 3 - 1, static_cast<float>(i % 5) / 2 - 1, 0}));
  }
  const Scene scene = scene_of(gaussians);
  for (const SimulateOptions& options : stable_machines()) {
    Simulation simulation;
    simulate_golden(scene, test_camera(64, 64), options, simulation);
    for (uint32_t i = 1; i < gaussians.size(); ++i)
      ASSERT_LT(simulation.golden.rank[i - 1], simulation.golden.rank[i]) << "ties go by index";
    expect_rtl_equal("equal depths", options, simulation);
    expect_bounded("equal depths", scene, test_camera(64, 64), options, simulation);
  }
}

// The number that a public report names as its worst tile (T17).
TEST(StabilityLong, T17_QuarterOfAMillionInOneTile) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 245535; ++i) {
    gaussians.push_back(gaussian_at({0.001f * static_cast<float>(i % 101 - 50),
                                     0.001f * static_cast<float>(i % 97 - 48), 2 + 1e-5f * static_cast<float>(i)},
                                    0.002f, 0.01, {1, 0, -1}));
  }
  expect_stable("one tile", scene_of(gaussians), test_camera(16, 16));
}

}  // namespace
}  // namespace pipegs
