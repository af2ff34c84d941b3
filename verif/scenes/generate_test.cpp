// SPDX-License-Identifier: Apache-2.0
// Against scenes/generate/generate: the same bits every time, the statistics of a trained scene, any count;
// and parts of a scene, which cover what their parent covers.
//
// Idea    kHash pins seed 1 bit by bit. When the scene is changed on purpose, the failing test
//         prints the new value to paste here; when nothing was changed, something is not portable.
#include "scenes/generate/generate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/info.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kHash = 0x18e826bf9f405068;

std::uint64_t hash(const Scene& scene) {
  std::uint64_t h = 0xcbf29ce484222325u;  // FNV-1a
  const auto eat = [&](const void* data, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) h = (h ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
  };
  eat(scene.gaussians.data(), scene.gaussians.size() * sizeof(Gaussian));
  eat(scene.sh_rest.data(), scene.sh_rest.size() * sizeof(float));
  return h;
}

TEST(Generate, IsTheSameSceneEveryTime) {
  const std::uint64_t found = hash(generate_scene(1, 6000));
  EXPECT_EQ(found, hash(generate_scene(1, 6000)));
  EXPECT_NE(found, hash(generate_scene(2, 6000)));
  EXPECT_EQ(found, kHash) << std::hex << "hash of seed 1 is 0x" << found;
}

TEST(Generate, GivesExactlyTheCountAskedFor) {
  for (const std::size_t count : {0u, 1u, 2u, 10u, 77u, 500u, 3001u}) {
    const Scene scene = generate_scene(3, count);
    EXPECT_EQ(scene.gaussians.size(), count);
    EXPECT_EQ(scene.sh_rest.size(), count * 45);
    EXPECT_EQ(inspect(scene).usable, count);
  }
}

TEST(Generate, HasTheStatisticsOfATrainedScene) {
  const Scene scene = generate_scene(1);
  const SceneInfo info = inspect(scene);
  EXPECT_EQ(info.usable, kGeneratedCount);
  EXPECT_EQ(info.sh_degree, 3);
  EXPECT_LT(info.lowest.x, -1500);  // unbounded
  EXPECT_GT(info.highest.x, 1500);
  EXPECT_GT(info.scale[6] / info.scale[0], 1e4);  // near and far
  EXPECT_LT(info.opacity[1], 0.05);               // faint ones
  EXPECT_GT(info.opacity[4], 0.9);                // solid ones
  EXPECT_GT(info.anisotropy[5], 20);              // needles
  EXPECT_LT(info.anisotropy[6], 200);
  EXPECT_LT(info.faint_share, 0.01);
}

TEST(Generate, FillsEveryViewWithLight) {
  const Scene scene = generate_scene(1);
  for (Camera camera : generated_cameras()) {
    EXPECT_EQ(camera.width, 1024);
    EXPECT_EQ(camera.height, 768);
    camera.width /= 4;  // a quarter of the resolution is enough to see a hole
    camera.height /= 4;
    camera.fx /= 4;
    camera.fy /= 4;
    camera.cx = (camera.width - 1) / 2.0;
    camera.cy = (camera.height - 1) / 2.0;
    const Image image = render_truth(scene, camera, {});
    double through = 0, worst = 0, light = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      through += image.transmittance[i];
      worst = std::max(worst, image.transmittance[i]);
      light += image.rgb[i].y;
    }
    const auto pixels = static_cast<double>(image.rgb.size());
    EXPECT_LT(through / pixels, 0.02) << camera.name;
    EXPECT_LT(worst, 0.5) << camera.name;
    EXPECT_GT(light / pixels, 0.25) << camera.name;
    EXPECT_LT(light / pixels, 0.75) << camera.name;
  }
}

// Covariance of a Gaussian in double.
glm::dmat3 covariance(const Scene& scene, std::size_t i) {
  ActivatedGaussian g;
  EXPECT_EQ(activate(scene, i, g), Cull::kNone);
  const glm::dmat3 axes = glm::mat3_cast(glm::dquat(g.rotation[0], g.rotation[1], g.rotation[2], g.rotation[3]));
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
