// SPDX-License-Identifier: Apache-2.0
// Against margin() of sim/layers/cldr: who reaches over the planes between layers.
#include "sim/layers/cldr.hpp"

#include <gtest/gtest.h>

#include "sim/studies/train/test/small_world.hpp"

namespace pipegs {
namespace {

Scene sized(float log_scale) {
  Scene scene = small_scene(200);
  for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale = glm::vec3(log_scale);
  return scene;
}

Margin margin_of(const Scene& scene, int cells) { return margin(scene, layer_grid(scene, cells)); }

TEST(Margin, PointsStayInsideAndWhatIsLargerThanTheSceneReachesOver) {
  EXPECT_EQ(margin_of(sized(-30), 4).share, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(margin_of(sized(6), 4).share, (std::array<double, 3>{1, 1, 1}));
}

TEST(Margin, MorePlanesAreCrossedByMore) {
  Scene scene = sized(-3);
  const Margin coarse = margin_of(scene, 4), fine = margin_of(scene, 8);
  EXPECT_EQ(fine.grid, 8);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_GT(fine.share[axis], coarse.share[axis]);
  scene.antialiased = true;  // which changes opacities alone
  EXPECT_EQ(margin_of(scene, 8).share, fine.share);
}

TEST(Margin, WhatCannotBeDrawnDoesNotCount) {
  Scene scene = sized(6);
  for (std::size_t i = 0; i < 150; ++i) scene.gaussians[i].rotation = {0, 0, 0, 0};
  EXPECT_EQ(margin_of(scene, 4).share[0], 1);
  const LayerGrid grid = layer_grid(scene, 4);
  for (Gaussian& gaussian : scene.gaussians) gaussian.rotation = {0, 0, 0, 0};
  EXPECT_EQ(margin(scene, grid).share[0], 0);
}

}  // namespace
}  // namespace pipegs
