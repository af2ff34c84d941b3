// SPDX-License-Identifier: Apache-2.0
// Against scenes/packed/write_spz: what is written is read again (by scenes/formats/spz, which is held against other
// people's writers) within the steps of the format.
#include <gtest/gtest.h>

#include <limits>

#include "scenes/generate/generate.hpp"
#include "scenes/packed/write_spz.hpp"
#include "verif/formats/compare.hpp"

namespace pipegs {
namespace {

Scene read_again(const Spz& spz) {
  SceneFormat format;
  const Scene scene = read_scene(InputFile("written", spz.bytes), {}, format);
  EXPECT_EQ(format.name, ".spz version 3 (gzip)");
  return scene;
}

Gaussian gaussian() {
  return {.mean = {1, -0.5f, 0.25f},
          .log_scale = {-3, -2, -1},
          .rotation = {0.5f, -0.5f, 0.5f, 0.5f},
          .opacity_logit = 0,
          .sh_dc = {0.5f, -0.5f, 1}};
}

TEST(WriteSpz, OurOwnSceneWithinTheSteps) {
  const Scene scene = generate_scene(1);
  const Spz spz = write_spz(scene);
  const Scene again = read_again(spz);
  ASSERT_EQ(again.gaussians.size(), scene.gaussians.size());
  ASSERT_EQ(again.sh_degree, scene.sh_degree);
  EXPECT_EQ(spz.position_bits, 11) << "its sky is 3163 away";
  EXPECT_EQ(spz.numbers, scene.gaussians.size() * 55) << "3 + 1 + 3 + 3 + 45; a rotation is never cut";
  const Difference most = difference(scene, again);
  EXPECT_LE(most.position, 1.001 / 4096);
  EXPECT_LE(most.scale, 1.001 / 32);
  EXPECT_LE(most.alpha, 1.001 / 510);
  EXPECT_LE(most.rotation, 0.4);
}

TEST(WriteSpz, FarthestGaussianSaysTheBits) {
  Scene scene{.gaussians = {gaussian(), gaussian()}};
  EXPECT_EQ(write_spz(scene).position_bits, 20) << "no more, however small the scene";
  scene.gaussians[1].mean.z = -70000;
  const Spz spz = write_spz(scene);
  EXPECT_EQ(spz.position_bits, 6);
  EXPECT_EQ(read_again(spz).gaussians[1].mean.z, -70000);
  EXPECT_EQ(spz.cut, 0u);
}

TEST(WriteSpz, WhatLiesBeyondTheRangeIsCutAndCounted) {
  Scene scene{.sh_degree = 1, .gaussians = {gaussian()}, .sh_rest = std::vector<float>(9, 0.5f), .antialiased = true};
  scene.sh_rest[4] = 1.5f;
  scene.gaussians[0].log_scale = {6, -11, -std::numeric_limits<float>::infinity()};
  scene.gaussians[0].opacity_logit = std::numeric_limits<float>::infinity();
  const Spz spz = write_spz(scene);
  EXPECT_EQ(spz.cut, 2u) << "the scale above and the SH; thinner than e^-10 is flat";
  const Scene again = read_again(spz);
  EXPECT_TRUE(again.antialiased);
  EXPECT_EQ(again.gaussians[0].log_scale, glm::vec3(5.9375f, -10, -10));
  EXPECT_EQ(alpha_of(again.gaussians[0]), alpha_of({.opacity_logit = 20}));
  EXPECT_EQ(again.sh_rest[4], 127 / 128.0f);
  EXPECT_EQ(again.sh_rest[3], 0.5f);
}

}  // namespace
}  // namespace pipegs
