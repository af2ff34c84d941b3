// SPDX-License-Identifier: Apache-2.0
// Against sim/compare/frame_check: a frame for which nothing was fetched, or of which all was culled, says so and why;
// one that shows something does not, nor a window, which may be empty.
#include "sim/compare/frame_check.hpp"

#include <gtest/gtest.h>

#include "scenes/check/view_check.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// What a frame says of itself while it is packed and drawn.
Findings found(const Scene& scene, const Camera& camera, SimulateOptions options) {
  Findings all;
  options.memory.dram = kDefaultDram;
  options.found = [&](const Findings& findings) { all.insert(all.end(), findings.begin(), findings.end()); };
  Simulation simulation;
  simulate_golden(scene, camera, options, simulation);
  return all;
}

TEST(FrameCheck, AnEmptyFrameSaysWhy) {
  const Scene scene = random_scene(1, 300, 1);
  const Camera camera = test_camera(70, 50);
  SimulateOptions options;
  EXPECT_TRUE(found(scene, camera, options).empty());
  options.near_plane = 1000;
  const Findings near = found(scene, camera, options);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].kind->key, "empty_frame");
  const Findings view = check_views(scene, {&camera, 1}, options.near_plane);
  ASSERT_EQ(view.size(), 1u);
  EXPECT_NE(view[0].what.find("before the near plane of 1000"), std::string::npos) << view[0].what;
  EXPECT_TRUE(view[0].kind->shows_nothing);
  options.window = {0, 0};
  EXPECT_TRUE(found(scene, camera, options).empty());
  Camera away = camera;
  away.position.z += 1000;
  EXPECT_EQ(found(scene, away, {}).size(), 1u);
}

TEST(FrameCheck, WhatIsLeftOutIsSaid) {
  Scene scene = random_scene(1, 300, 1);
  scene.gaussians[7].mean.x = 1e30f;
  const Findings findings = found(scene, test_camera(70, 50), {});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind->key, "left_out");
}

}  // namespace
}  // namespace pipegs
