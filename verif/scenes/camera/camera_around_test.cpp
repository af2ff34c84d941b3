// SPDX-License-Identifier: Apache-2.0
// Against scenes/cameras/around: views near those of a file, each a camera like theirs.
#include "scenes/cameras/around.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pipegs {
namespace {

const std::vector<Camera> kViews = {look_at("near", 3, 64, 48, {0, 0, 0}, {1, 0, 4}, 60),
                                    look_at("far", 5, 32, 24, {0, 0, -20}, {0, 0, 0}, 40)};

TEST(CamerasAround, StayNearTheirView) {
  const std::vector<Camera> all = cameras_around(kViews, 50, 1);
  ASSERT_EQ(all.size(), 102u);
  double moved = 0, turned = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Camera &camera = all[i], &view = kViews[i / 51];
    EXPECT_EQ(camera.id, static_cast<int>(i));
    EXPECT_EQ(camera.width, view.width);
    EXPECT_EQ(camera.fx, view.fx);
    const glm::dmat3 turn = camera.world_to_camera * glm::transpose(view.world_to_camera);
    EXPECT_NEAR(glm::determinant(turn), 1, 1e-12);
    const double cosine = (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2,
                 angle = glm::degrees(std::acos(std::min(cosine, 1.0)));
    const glm::dvec3 way = glm::abs(camera.position - view.position);
    EXPECT_LE(std::max({way.x, way.y, way.z}), 2.0) << "a tenth of the 20 to the other view";
    EXPECT_LE(angle, 8 + 1e-6);
    moved = std::max(moved, way.x), turned = std::max(turned, angle);
    if (i % 51 != 0) continue;
    EXPECT_EQ(camera.name, view.name);
    EXPECT_EQ(camera.position, view.position);
    EXPECT_EQ(camera.world_to_camera, view.world_to_camera);
  }
  EXPECT_GT(moved, 1.5);
  EXPECT_GT(turned, 6);
  EXPECT_EQ(all[52].name, "around_far_1");
}

TEST(CamerasAround, FollowTheSeedAndASingleViewOnlyTurns) {
  const auto place = [](std::uint64_t seed) { return cameras_around(kViews, 2, seed)[1].position; };
  EXPECT_EQ(place(7), place(7));
  EXPECT_NE(place(7), place(8));
  const std::vector<Camera> one = cameras_around({kViews[0]}, 3, 1);
  EXPECT_EQ(one[2].position, kViews[0].position);
  EXPECT_NE(one[2].world_to_camera, kViews[0].world_to_camera);
}

}  // namespace
}  // namespace pipegs
