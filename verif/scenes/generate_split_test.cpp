// SPDX-License-Identifier: Apache-2.0
// Against scenes/generate/generate_split: the count asked for, parts that cover what their parent covers, the same
// picture, the same scene every time.
#include "scenes/generate/generate_split.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/generate/generate.hpp"

namespace pipegs {
namespace {

// Covariance of a Gaussian in double.
glm::dmat3 covariance(const Scene& scene, std::size_t i) {
  ActivatedGaussian g;
  EXPECT_EQ(activate(scene, i, g), Cull::kNone);
  const double w = g.rotation[0], x = g.rotation[1], y = g.rotation[2], z = g.rotation[3];
  const glm::dmat3 axes(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),  //
                        2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),  //
                        2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
  glm::dmat3 sum(0);
  for (int a = 0; a < 3; ++a) sum += g.scale[a] * g.scale[a] * glm::outerProduct(axes[a], axes[a]);
  return sum;
}

TEST(Split, GivesExactlyTheCountAndTheDegreeAskedFor) {
  const Scene whole = generate_scene(1, 700);
  for (const std::size_t count : {700u, 701u, 2100u, 5003u}) {
    for (const int degree : {0, 1, 3}) {
      const Scene parts = split_scene(whole, count, degree, 1);
      EXPECT_EQ(parts.gaussians.size(), count);
      EXPECT_EQ(parts.sh_degree, degree);
      EXPECT_NO_THROW(check_consistent(parts));
      for (int k = 0; k < 3 * sh_rest_count(degree); ++k)
        ASSERT_EQ(sh_rest_of(parts, count - 1)[k], sh_rest_of(whole, (count - 1) % 700)[k]);
    }
  }
  const Scene same = split_scene(whole, 700, 3, 9);
  for (std::size_t i = 0; i < 700; ++i) EXPECT_EQ(same.gaussians[i].mean, whole.gaussians[i].mean);
}

TEST(Split, TheSeedAloneSaysWhereThePartsLie) {
  const Scene whole = generate_scene(1, 50);
  const auto mean = [&](std::uint64_t seed) { return split_scene(whole, 500, 0, seed).gaussians[321].mean; };
  EXPECT_EQ(mean(1), mean(1));
  EXPECT_NE(mean(1), mean(2));
}

// Many parts of one Gaussian: their means have its covariance, their scales 1/k of its areas.
TEST(Split, PartsAreDrawnFromTheirParent) {
  constexpr std::size_t kParts = 20000;
  Scene whole;
  whole.gaussians = {{{1, 2, 3}, {0.5f, -0.5f, -3}, {0.5f, -0.7f, 0.3f, 0.2f}, 2, {0, 0, 0}}};
  const Scene parts = split_scene(whole, kParts, 0, 1);
  const glm::dmat3 wanted = covariance(whole, 0);
  glm::dmat3 found(0);
  for (const Gaussian& part : parts.gaussians) {
    const glm::dvec3 offset = glm::dvec3(part.mean) - glm::dvec3(1, 2, 3);
    found += glm::outerProduct(offset, offset) / static_cast<double>(kParts);
    EXPECT_EQ(part.opacity_logit, 2);
  }
  const glm::dmat3 part = covariance(parts, 7);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(found[i][j], wanted[i][j], 0.03 * wanted[0][0] + 0.03 * wanted[1][1]) << i << j;
      EXPECT_NEAR(part[i][j] * static_cast<double>(kParts), wanted[i][j], 1e-4);
    }
  }
}

TEST(Split, ShowsAboutTheSamePicture) {
  const Scene whole = generate_scene(1, 3000);
  Camera camera = generated_cameras()[0];
  camera.width = 128, camera.height = 96;
  camera.fx /= 8, camera.fy /= 8;
  camera.cx = 63.5, camera.cy = 47.5;
  const Image a = render_truth(whole, camera, {}), b = render_truth(split_scene(whole, 60000, 3, 1), camera, {});
  EXPECT_GT(psnr(a, b), 20);
  EXPECT_LT(psnr(a, b), 60) << "nothing was split";
}

TEST(Split, WhatIsCulledIsCopiedAndTooFewAreRefused) {
  Scene whole = generate_scene(1, 10);
  whole.gaussians[3].rotation = glm::vec4(0);
  whole.gaussians[4].mean.x = std::numeric_limits<float>::infinity();
  const Scene parts = split_scene(whole, 30, 0, 1);
  EXPECT_EQ(parts.gaussians[13].mean, whole.gaussians[3].mean);
  EXPECT_EQ(parts.gaussians[13].log_scale, whole.gaussians[3].log_scale);
  EXPECT_EQ(parts.gaussians[24].mean.x, whole.gaussians[4].mean.x);
  EXPECT_THROW(split_scene(whole, 9, 0, 1), std::invalid_argument);
  EXPECT_THROW(split_scene(Scene{}, 9, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace pipegs
