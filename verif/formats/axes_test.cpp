// SPDX-License-Identifier: Apache-2.0
// Against scenes/formats/axes: a turned scene looks from a turned place as it looked before.
//
// Idea    What a Gaussian shows is its covariance and its colour by direction: both are worked out here anew from the
//         Gaussian, before and after.
#include "scenes/formats/axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "scenes/sh_basis.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

Scene random_scene_of_degree(int degree, std::mt19937_64& random) {
  const auto any = [&] { return static_cast<float>(draw_normal(random)); };
  Scene scene;
  scene.sh_degree = degree;
  scene.gaussians.resize(5);
  scene.sh_rest.resize(scene.gaussians.size() * 3 * static_cast<std::size_t>(sh_rest_count(degree)));
  for (Gaussian& g : scene.gaussians) {
    for (int k = 0; k < 3; ++k) g.mean[k] = any(), g.log_scale[k] = any(), g.sh_dc[k] = any();
    for (int k = 0; k < 4; ++k) g.rotation[k] = any();
    g.opacity_logit = any();
  }
  for (float& v : scene.sh_rest) v = any();
  return scene;
}

glm::dmat3 covariance(const Gaussian& g) {
  const glm::dquat q = glm::normalize(glm::dquat(g.rotation[0], g.rotation[1], g.rotation[2], g.rotation[3]));
  glm::dmat3 axes = glm::mat3_cast(q);
  for (int k = 0; k < 3; ++k) axes[k] *= std::exp(static_cast<double>(g.log_scale[k]));
  return axes * glm::transpose(axes);
}

double red(const Scene& scene, std::size_t i, const glm::dvec3& direction) {
  const auto basis = sh_basis(direction);
  double sum = basis[0] * scene.gaussians[i].sh_dc[0];
  for (int k = 0; k < sh_rest_count(scene.sh_degree); ++k)
    sum += basis[static_cast<std::size_t>(k) + 1] * sh_rest_of(scene, i)[3 * k];
  return sum;
}

void expect_same_sight(const Scene& before, const Scene& after, const glm::dmat3& turn, double scale,
                       const glm::dvec3& shift) {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
  for (std::size_t i = 0; i < before.gaussians.size(); ++i) {
    const Gaussian &a = before.gaussians[i], &b = after.gaussians[i];
    EXPECT_LT(glm::length(scale * (turn * glm::dvec3(a.mean)) + shift - glm::dvec3(b.mean)), 1e-5);
    const glm::dmat3 wanted = scale * scale * (turn * covariance(a) * glm::transpose(turn)), found = covariance(b);
    for (int k = 0; k < 9; ++k)
      EXPECT_NEAR(wanted[k / 3][k % 3], found[k / 3][k % 3], 1e-5 * (1 + std::abs(wanted[k / 3][k % 3])));
    EXPECT_NEAR(red(before, i, direction), red(after, i, turn * direction), 1e-5);
    EXPECT_EQ(a.opacity_logit, b.opacity_logit);
  }
}

TEST(Axes, AnyTurnShowsTheSame) {
  std::mt19937_64 random(3);
  for (int degree = 0; degree <= 3; ++degree) {
    for (const double mirror : {1.0, -1.0}) {
      const glm::dquat q = glm::normalize(
          glm::dquat{draw_normal(random), draw_normal(random), draw_normal(random), draw_normal(random)});
      const glm::dmat3 turn = mirror * glm::mat3_cast(q);
      const Scene before = random_scene_of_degree(degree, random);
      Scene after = before;
      const glm::dvec3 shift(1, -2, 3);
      transform(after, turn, 2.5, shift);
      expect_same_sight(before, after, turn, 2.5, shift);
    }
  }
}

TEST(Axes, LettersAreDirections) {
  std::mt19937_64 random(4);
  for (const std::string axes : {"RUB", "LUF", "LDB", "RUF", "LFD", "BRU", "UFR"}) {
    SCOPED_TRACE(axes);
    ASSERT_TRUE(are_axes(axes));
    const Scene before = random_scene_of_degree(3, random);
    Scene after = before;
    transform(after, turn_of(axes));
    expect_same_sight(before, after, turn_of(axes), 1, glm::dvec3(0));
  }
  // By hand: x to the left, y up, z to the front is half a turn about z.
  EXPECT_EQ(turn_of("LUF") * glm::dvec3(1, 2, 3), glm::dvec3(-1, -2, 3));
  EXPECT_EQ(turn_of("FRD") * glm::dvec3(1, 2, 3), glm::dvec3(2, 3, 1));
  for (const char* wrong : {"", "R", "RD", "RDFF", "RRF", "RLF", "rdf", "XYZ"}) EXPECT_FALSE(are_axes(wrong)) << wrong;
}

// Signs stay signs, to the last bit: two half turns give the scene back.
TEST(Axes, HalfTurnsAreExact) {
  std::mt19937_64 random(5);
  const Scene before = random_scene_of_degree(3, random);
  Scene after = before;
  transform(after, turn_of("RUB"));
  EXPECT_NE(after.sh_rest, before.sh_rest);
  transform(after, turn_of("RUB"));
  EXPECT_EQ(after.sh_rest, before.sh_rest);
  EXPECT_EQ(after.gaussians[0].mean, before.gaussians[0].mean);
}

}  // namespace
}  // namespace pipegs
