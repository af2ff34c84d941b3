// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/tradeoff/resample: a picture with fewer pixels covers the same rectangle, and comes back
// without a shift.
#include "sim/studies/tradeoff/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

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

TEST(Resample, ASmallerCameraSeesTheSameRectangle) {
  Camera camera = test_camera(123, 77, 90);
  camera.cx += 3.25, camera.cy -= 1.5, camera.fy = 95;
  for (const double scale : {1.0, 0.75, 0.5, 0.001}) {
    SCOPED_TRACE(scale);
    const Camera small = scaled_camera(camera, scale);
    EXPECT_EQ(small.width, std::max(1L, std::lround(scale * 123)));
    EXPECT_EQ(small.height, std::max(1L, std::lround(scale * 77)));
    for (const double edge : {0.0, 1.0}) {  // the left and right, the upper and lower one
      EXPECT_NEAR((edge * small.width - 0.5 - small.cx) / small.fx, (edge * 123 - 0.5 - camera.cx) / camera.fx, 1e-12);
      EXPECT_NEAR((edge * small.height - 0.5 - small.cy) / small.fy, (edge * 77 - 0.5 - camera.cy) / camera.fy, 1e-12);
    }
    EXPECT_EQ(small.position, camera.position);
  }
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
