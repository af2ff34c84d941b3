// SPDX-License-Identifier: Apache-2.0
// pack_merge_test: cpp_model/pack/pack_merge.cpp, pack_error.cpp and pack_proxies.cpp: merges by hand, in float64
// pictures, and of what is degenerate; sizes at which two sets look alike.
#include "cpp_model/pack/pack_merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "cpp_model/pack/pack_error.hpp"
#include "cpp_model/pack/pack_proxies.hpp"
#include "verif/dopu/dopu_world.hpp"

namespace pipegs {
namespace {

constexpr double kPoint = -std::numeric_limits<double>::infinity();  // of a scale of zero the logarithm

void add(Scene& scene, const glm::dvec3& mean, double scale, double opacity, float color = 0) {
  scene.gaussians.push_back({.mean = glm::vec3(mean),
                             .log_scale = glm::vec3(scale > 0 ? std::log(scale) : kPoint),
                             .rotation = {1, 0, 0, 0},
                             .opacity_logit = static_cast<float>(std::log(opacity / (1 - opacity))),
                             .sh_dc = glm::vec3(color)});
}

std::vector<uint32_t> all(const Scene& scene) {
  std::vector<uint32_t> indices(scene.gaussians.size());
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

ActivatedGaussian activated(const Gaussian& gaussian) {
  ActivatedGaussian result;
  EXPECT_EQ(activate(gaussian, nullptr, 0, result), Cull::kNone);
  return result;
}

std::vector<double> sorted_scales(const ActivatedGaussian& gaussian) {
  std::vector<double> scales = {gaussian.scale.x, gaussian.scale.y, gaussian.scale.z};
  std::sort(scales.begin(), scales.end());
  return scales;
}

// Two balls of radius 1 at +-1 on x, without a pixel's low-pass filter: variances 2, 1, 1, so scales sqrt(2), 1, 1; the
// ball covers 1, the ellipsoid (2 sqrt(2) + 1) / 3, up to the same factor.
TEST(PackMerge, TwoBallsByHand) {
  Scene scene;
  add(scene, {-1, 0, 0}, 1, 0.3, -1);
  add(scene, {1, 0, 0}, 1, 0.3, 2);
  const Merged merged = merge_gaussians(scene, all(scene), 0);
  const ActivatedGaussian found = activated(merged.gaussian);
  EXPECT_NEAR(glm::length(found.mean), 0, 1e-6);
  const std::vector<double> scales = sorted_scales(found);
  EXPECT_NEAR(scales[0], 1, 1e-6);
  EXPECT_NEAR(scales[1], 1, 1e-6);
  EXPECT_NEAR(scales[2], std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(found.opacity, 2 * 0.3 / ((2 * std::sqrt(2.0) + 1) / 3), 1e-6);
  EXPECT_NEAR(merged.gaussian.sh_dc.x, 0.5, 1e-6);
  EXPECT_EQ(merged.heaviest, 0u) << "the lower of equals";
}

// Weights 0.8 * 4 and 0.2 * 4 with a radius of 2: means, colours and coefficients by 4 to 1.
TEST(PackMerge, WhatCoversMoreCountsMore) {
  Scene scene;
  scene.sh_degree = 1;
  add(scene, {0, 0, 10}, 2, 0.2, 0);
  add(scene, {0, 5, 10}, 2, 0.8, 1);
  for (int i = 0; i < 18; ++i) scene.sh_rest.push_back(i < 9 ? 0.0f : 1.0f);
  const Merged merged = merge_gaussians(scene, all(scene), 0);
  EXPECT_NEAR(merged.gaussian.mean.y, 4, 1e-6);
  EXPECT_NEAR(merged.gaussian.sh_dc.y, 0.8, 1e-6);
  ASSERT_EQ(merged.sh_rest.size(), 9u);
  for (const float one : merged.sh_rest) EXPECT_NEAR(one, 0.8, 1e-6);
  EXPECT_EQ(merged.heaviest, 1u);
  const std::vector<double> scales = sorted_scales(activated(merged.gaussian));
  EXPECT_NEAR(scales[2], std::sqrt(4 + 0.8 * 0.2 * 25), 1e-5);  // of two points 5 apart, weights 0.8 and 0.2
}

// Points cover nothing without a filter; with one they cover what it makes of them.
TEST(PackMerge, ThePixelCountsForWhatIsSmall) {
  Scene scene;
  add(scene, {0, 0, 0}, 0, 0.4);
  add(scene, {0, 0, 0}, 1, 0.4);
  EXPECT_NEAR(activated(merge_gaussians(scene, all(scene), 0).gaussian).opacity, 0.4, 1e-6);
  const double pixel = 1000;  // both are as large as its filter
  EXPECT_NEAR(activated(merge_gaussians(scene, all(scene), pixel).gaussian).opacity, 0.8, 1e-3);
}

TEST(PackMerge, OneAloneStaysAsItIs) {
  std::mt19937_64 rng(1);
  const Scene scene = random_scene(rng, 3, 3);
  const Merged merged = merge_gaussians(scene, std::vector<uint32_t>{1}, 0.1);
  EXPECT_EQ(merged.gaussian.mean, scene.gaussians[1].mean);
  EXPECT_EQ(merged.gaussian.rotation, scene.gaussians[1].rotation);
  EXPECT_TRUE(std::equal(merged.sh_rest.begin(), merged.sh_rest.end(), sh_rest_of(scene, 1)));
  EXPECT_EQ(merged.heaviest, 1u);
}

// Whatever is merged can be drawn: opaque Gaussians, needles, planes, a thousand at one point, points alone.
TEST(PackMerge, WhatIsDegenerateStaysFinite) {
  std::mt19937_64 rng(2);
  for (int kind = 0; kind < 5; ++kind) {
    Scene scene;
    for (int i = 0; i < 1000; ++i) {
      add(scene, kind == 3 ? glm::dvec3(1, 2, 3) : draw_normals(rng), kind == 4 ? 0 : 0.01, 0.999999);
      glm::vec3& scale = scene.gaussians.back().log_scale;
      if (kind == 1) scale = {-20, -20, 2};
      if (kind == 2) scale = {-static_cast<float>(HUGE_VAL), 0, 0};
      scene.gaussians.back().rotation = glm::normalize(glm::vec4(draw_normals(rng), draw_normal(rng)));
    }
    for (const double pixel : {0.0, 0.1}) {
      for (const Merged& merged : merge_parts(scene, all(scene), 2, pixel)) {
        const ActivatedGaussian found = activated(merged.gaussian);
        EXPECT_TRUE(found.opacity > 0 && found.opacity <= 0.9901) << kind << ": " << found.opacity;
        EXPECT_NEAR(glm::length(found.rotation), 1, 1e-6) << kind;
        EXPECT_LT(glm::length(found.mean), 5) << kind;
      }
    }
  }
}

// Two of many in one place, a small part of their size apart, seen from anywhere: their picture is that of the merged.
TEST(PackMerge, ThePictureOfTwoIsThatOfTheirMerge) {
  std::mt19937_64 rng(3);
  for (int i = 0; i < 20; ++i) {
    Scene two, one;
    const glm::dvec3 middle = draw_normals(rng) * 0.2, away = glm::normalize(draw_normals(rng)) * 0.02;
    for (const double sign : {-1.0, 1.0})
      add(two, middle + away * sign, 0.15, 0.05, static_cast<float>(draw_normal(rng)));
    two.gaussians[0].log_scale.x = two.gaussians[1].log_scale.x = -1;
    two.gaussians[0].rotation = two.gaussians[1].rotation = glm::normalize(glm::vec4(draw_normals(rng), 1));
    one.gaussians.push_back(merge_gaussians(two, all(two), 0.01).gaussian);
    const glm::dvec3 from = glm::normalize(draw_normals(rng)) * 4.0;
    const Camera camera = look_at("pair", 0, 96, 96, from, glm::dvec3(0), 40);
    EXPECT_GT(psnr(render_truth(two, camera, {}), render_truth(one, camera, {})), 50) << i;
  }
}

TEST(PackError, SetsAreAlikeFromAPixelOnThatGrowsWithTheirDistance) {
  std::vector<ActivatedGaussian> sets[3];
  std::vector<glm::vec3> dc(1, glm::vec3(1));
  for (int i = 0; i < 3; ++i) {
    Scene scene;
    add(scene, {i * 0.3, 0, 0}, 0.5, 0.8);
    sets[i] = {activated(scene.gaussians[0])};
  }
  const auto alike = [&](int i, double most) { return alike_pixel(sets[0], dc, sets[i], dc, most); };
  EXPECT_NE(alike(0, 0), kNeverAlike) << "nothing differs";
  EXPECT_LT(alike(0, 0), alike(1, 0.01));
  EXPECT_LT(alike(1, 0.01), alike(2, 0.01));
  EXPECT_LT(alike(2, 0.1), alike(2, 0.01));
  EXPECT_EQ(alike(2, 0), kNeverAlike);
}

TEST(PackError, ColourCountsAndWhatIsHiddenDoesNot) {
  // A dark speck in the middle of a light ball, behind its front half in every view, and one beside it.
  Scene scene;
  for (const double x : {0.0, 0.01, 8.0}) add(scene, {x, x, x}, x == 0 ? 1 : 0.3, x == 0 ? 0.999 : 0.9, 1);
  std::vector<ActivatedGaussian> all;
  for (const Gaussian& gaussian : scene.gaussians) all.push_back(activated(gaussian));
  const std::vector<ActivatedGaussian> one(all.begin(), all.begin() + 1), hidden(all.begin(), all.begin() + 2),
      beside = {all[0], all[2]};
  const glm::vec3 light(1), dark(-1);
  EXPECT_EQ(alike_pixel(one, std::vector{light}, one, std::vector{dark}, 0.05), kNeverAlike);
  EXPECT_NE(alike_pixel(one, std::vector{light}, one, std::vector{light}, 0.05), kNeverAlike);
  const double unseen = alike_pixel(one, std::vector{light}, hidden, std::vector{light, dark}, 0.05),
               seen = alike_pixel(one, std::vector{light}, beside, std::vector{light, dark}, 0.05);
  EXPECT_NE(unseen, kNeverAlike);
  EXPECT_TRUE(seen == kNeverAlike || seen > 2 * unseen) << seen << " " << unseen;
}

// A group has at most two proxies of each chunk, in the order of the chunks; a larger loss in the same place asks for
// larger pixels.
TEST(PackProxies, AGroupsErrorIsOfItsSize) {
  Config config;
  config_set(config, "lod=1");
  std::mt19937_64 rng(4);
  Scene scene;
  for (int i = 0; i < 40; ++i) add(scene, draw_normals(rng) * 0.01, 0.05, 0.1, static_cast<float>(draw_normal(rng)));
  const std::vector<uint32_t> indices = all(scene);
  std::vector<std::vector<uint32_t>> chunks;
  for (size_t at = 0; at < indices.size(); at += 16)
    chunks.emplace_back(indices.begin() + static_cast<std::ptrdiff_t>(at),
                        indices.begin() + static_cast<std::ptrdiff_t>(std::min(at + 16, indices.size())));
  Proxies proxies;
  proxies.resize(scene, 6);
  const uint64_t error = make_proxies(config, scene, chunks, -20, 0, proxies);
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(proxies.heaviest[i] / 16, i / 2) << i;
  EXPECT_EQ(make_proxies(config, scene, chunks, -21, 0, proxies), error + 4) << "world units half as large: an octave";
  EXPECT_EQ(make_proxies(config, scene, std::vector<std::vector<uint32_t>>{{0}}, -20, 0, proxies), 255u);
}

}  // namespace
}  // namespace pipegs
