// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/explore/less: what nobody sees contributes nothing, what is seen its largest weight, and who goes
// takes its SH coefficients along; a picture with fewer pixels covers the same rectangle, and comes back without a
// shift.
#include "sim/studies/explore/less.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr double kNear = 0.2;

TEST(Contribution, BehindAWallOrBesideThePictureThereIsNone) {
  const auto wall = [](float z) { return gaussian_at({0, 0, z}, 3, 1 - 1e-9); };
  const Scene scene =
      scene_of({gaussian_at({0, 0, 5}, 0.1f, 0.9), wall(2), wall(2.1f), wall(2.2f), gaussian_at({9, 0, 5}, 0.1f, 0.9),
                gaussian_at({0, 0, -5}, 0.1f, 0.9), gaussian_at({0, 0, 1}, 0.01f, 0.5)});
  const std::vector<float> weights = contributions(scene, {test_camera(32, 24)}, kNear, {});
  ASSERT_EQ(weights.size(), 7u);
  EXPECT_EQ(weights[0], 0) << "behind walls";
  EXPECT_FLOAT_EQ(weights[1], 0.99f) << "where the ball before it does not count";
  EXPECT_LE(weights[3], 1e-4) << "behind two walls";
  EXPECT_EQ(weights[4], 0) << "beside the picture";
  EXPECT_EQ(weights[5], 0) << "behind the camera";
  EXPECT_GT(weights[6], 0.3) << "before all others";
}

TEST(Contribution, IsTheLargestWeightOfAnyPixelOfAnyCamera) {
  const Scene scene = random_scene(4, 150, 1);
  Camera other = test_camera(20, 28, 40);
  other.position = {0.5, -0.3, 0.1};
  const std::vector<Camera> cameras = {test_camera(33, 21, 30), other};
  std::vector<float> wanted(scene.gaussians.size());
  for (const Camera& camera : cameras) {
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        for (const TruthStep& step : explain_truth(scene, camera, {.near_plane = kNear}, x, y))
          wanted[step.index] = std::max(wanted[step.index], static_cast<float>(step.weight));
      }
    }
  }
  EXPECT_GT(std::count(wanted.begin(), wanted.end(), 0), 5);
  EXPECT_LT(std::count(wanted.begin(), wanted.end(), 0), 140);
  double last = 0;
  const std::vector<float> found = contributions(scene, cameras, kNear, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(last, 1);
}

TEST(Contribution, WhoAddsLeastGoesAndTakesItsCoefficientsAlong) {
  Scene scene = random_scene(2, 6, 2);
  for (std::size_t i = 0; i < scene.sh_rest.size(); ++i) scene.sh_rest[i] = static_cast<float>(i);
  const std::vector<float> weights = {0.5f, 0.1f, 0.9f, 0.1f, 0, 0.1f};
  const Scene less = without_least(scene, weights, 0.5);  // 4, then of the equal ones 1 and 3
  check_consistent(less);
  ASSERT_EQ(less.gaussians.size(), 3u);
  const std::size_t stay[] = {0, 2, 5}, each = 3 * static_cast<std::size_t>(sh_rest_count(2));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(less.gaussians[i].mean, scene.gaussians[stay[i]].mean) << i;
    for (std::size_t k = 0; k < each; ++k)
      EXPECT_EQ(less.sh_rest[i * each + k], static_cast<float>(stay[i] * each + k)) << i << " " << k;
  }
  EXPECT_EQ(less.name, scene.name);
}

TEST(Contribution, AShareIsTheNearestNumberFromNoneToAll) {
  const Scene scene = random_scene(3, 10, 0);
  const std::vector<float> weights(10, 1);
  for (const auto& [without, left] : {std::pair{0.0, 10u}, {0.04, 10u}, {0.06, 9u}, {0.6, 4u}, {1.0, 0u}}) {
    EXPECT_EQ(without_least(scene, weights, without).gaussians.size(), left) << without;
    EXPECT_EQ(10 - left_out(10, without), left) << without;
  }
}

// Pixel (x, y) of a plane that rises by one across the picture, at the pixel's centre.
glm::dvec3 plane(const Image& image, int x, int y) {
  const double u = (x + 0.5) / image.width, v = (y + 0.5) / image.height;
  return {u, v, 0.5 * (u + v)};
}

Image plane_of(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.rgb[image.at(x, y)] = plane(image, x, y);
  }
  return image;
}

TEST(Resample, APlaneComesBackAndOnlyTheRimIsRounded) {
  for (const auto& [width, height] : {std::pair{60, 40}, std::pair{90, 60}, std::pair{61, 47}}) {
    SCOPED_TRACE(width);
    const Image small = plane_of(width, height), back = resampled(small, 120, 80);
    ASSERT_EQ(back.width, 120);
    ASSERT_EQ(back.height, 80);
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 120; ++x) {
        const bool rim = x < 5 || x >= 115 || y < 5 || y >= 75;  // two pixels of the small picture, which end in clamps
        const glm::dvec3 error = glm::abs(back.rgb[back.at(x, y)] - plane(back, x, y));
        // Outside the picture is its last pixel: on the rim less than a step of the small one is lost.
        EXPECT_LT(std::max({error.x, error.y, error.z}), rim ? 1.0 / height : 1e-5) << x << " " << y;
      }
    }
  }
}

TEST(Resample, AtItsOwnSizeAPictureIsWhatItWas) {
  Image image(7, 5);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const float value = std::sin(static_cast<float>(i));
    image.rgb[i] = {value, -value, 0.25f};
  }
  const Image same = resampled(image, 7, 5);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) EXPECT_EQ(same.rgb[i], image.rgb[i]) << i;
}

// A ball of 16 pixels: half a pixel of shift would be an error of 0.015.
TEST(Resample, WhatASmallerCameraShowsLiesWhereItWas) {
  const Scene scene = scene_of({gaussian_at({0.1f, -0.05f, 2}, 0.32f, 0.8, {1, 0.5f, 0})});
  const Camera camera = test_camera(160, 120);
  const Image whole = render_truth(scene, camera, {});
  for (const double scale : {0.75, 0.5}) {
    const Image small = render_truth(scene, scaled_camera(camera, scale), {});
    EXPECT_LT(max_abs_error(resampled(small, 160, 120), whole), 0.005) << scale;
  }
}

}  // namespace
}  // namespace pipegs
