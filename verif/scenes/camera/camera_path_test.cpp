// SPDX-License-Identifier: Apache-2.0
// Against scenes/cameras/path: a smooth way that passes through every key view.
#include "scenes/cameras/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

// Looks along `yaw` and `pitch`, degrees.
Camera key(const glm::dvec3& position, double yaw, double pitch = 0, double focal = 100) {
  const double y = glm::radians(yaw), p = glm::radians(pitch);
  const glm::dvec3 ahead(std::sin(y) * std::cos(p), std::sin(p), std::cos(y) * std::cos(p));
  Camera camera = look_at("key", 0, 64, 48, position, position + ahead, 60);
  camera.fx = focal, camera.fy = 1.1 * focal;
  return camera;
}

// Degrees between the rotations of two cameras.
double turn(const Camera& a, const Camera& b) {
  const glm::dmat3 between = a.world_to_camera * glm::transpose(b.world_to_camera);
  const double trace = between[0][0] + between[1][1] + between[2][2];
  return glm::degrees(std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)));
}

const std::vector<Camera> kWalk = {key({0, 0, 0}, 0), key({1, 0.2, 3}, 40, 5), key({4, 0, 4}, 100, -5, 130),
                                   key({5, 0.1, 8}, 190), key({3, 0, 9}, 275, 10, 90)};

TEST(CameraPath, AFrameOnAKeyViewIsThatView) {
  const std::vector<Camera> path = camera_path(kWalk, 41);
  ASSERT_EQ(path.size(), 41u);
  for (size_t i = 0; i < kWalk.size(); ++i) {
    const Camera &on = path[10 * i], &wanted = kWalk[i];
    EXPECT_EQ(on.position, wanted.position) << i;
    EXPECT_EQ(on.world_to_camera, wanted.world_to_camera) << i;
    EXPECT_EQ(std::tie(on.fx, on.fy, on.cx, on.cy), std::tie(wanted.fx, wanted.fy, wanted.cx, wanted.cy)) << i;
  }
  EXPECT_EQ(path[7].name, "path_7");
}

TEST(CameraPath, TwoViewsAreAStraightLineAtEvenSpeed) {
  const std::vector<Camera> path = camera_path({key({1, 2, 3}, 10, 0, 50), key({5, 2, 1}, 100, 0, 200)}, 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_LT(glm::length(path[i].position - glm::dvec3(1 + i, 2, 3 - 0.5 * i)), 1e-14) << i;
    EXPECT_NEAR(turn(path[i], path[0]), 22.5 * i, 1e-6) << i;
    EXPECT_NEAR(path[i].fx, 50 * std::pow(4, i / 4.0), 1e-11) << i;
  }
}

TEST(CameraPath, TheWayIsSmoothAndEachRotationIsOne) {
  const std::vector<Camera> path = camera_path(kWalk, 401);
  double far = 0, wide = 0;
  for (size_t i = 0; i < path.size(); ++i) {
    const glm::dmat3& r = path[i].world_to_camera;
    EXPECT_NEAR(glm::determinant(r), 1, 1e-12);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(glm::length(r[k]), 1, 1e-12);
    if (i < 2) continue;
    // Neither place nor direction changes its speed at once: a jump at a key would be a whole step.
    const glm::dvec3 step = path[i].position - path[i - 1].position, last = path[i - 1].position - path[i - 2].position;
    far = std::max(far, glm::length(step - last) / glm::length(step));
    wide = std::max(wide, std::abs(turn(path[i], path[i - 1]) - turn(path[i - 1], path[i - 2])));
  }
  EXPECT_LT(far, 0.1);
  EXPECT_LT(wide, 0.05) << "degrees; a step is about one";
}

// A quaternion and its negative are one rotation: the path takes the shorter way between any two.
TEST(CameraPath, TakesTheShorterWayRound) {
  for (double from = 0; from < 360; from += 37) {
    const std::vector<Camera> path = camera_path({key({0, 0, 0}, from), key({0, 0, 0}, from + 150)}, 11);
    for (size_t i = 1; i < path.size(); ++i) EXPECT_NEAR(turn(path[i], path[i - 1]), 15, 1e-6) << from;
  }
}

TEST(CameraPath, ViewsThatAreAlikeStandStill) {
  const std::vector<Camera> path = camera_path({kWalk[1], kWalk[1], kWalk[1]}, 8);
  for (const Camera& camera : path) {
    EXPECT_LT(glm::length(camera.position - kWalk[1].position), 1e-14);
    EXPECT_LT(turn(camera, kWalk[1]), 1e-5);
  }
}

TEST(CameraPath, MoreViewsThanFramesAreNoFault) {
  const std::vector<Camera> path = camera_path(kWalk, 2);
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0].position, kWalk.front().position);
  EXPECT_EQ(path[1].position, kWalk.back().position);
}

TEST(CameraPath, WhatMakesNoPathIsRefused) {
  Camera other = kWalk[1];
  other.width = 65;
  EXPECT_THROW(camera_path({kWalk[0]}, 5), InputError);
  EXPECT_THROW(camera_path({kWalk[0], other}, 5), InputError);
}

}  // namespace
}  // namespace pipegs
