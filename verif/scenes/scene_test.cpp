// SPDX-License-Identifier: Apache-2.0
// Against scenes/scene and scenes/info: activation, what is culled, and what the inspector finds.
//
// Idea    One good Gaussian, then one value at a time is broken: exactly that makes it culled.
#include "scenes/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/check/scene_check.hpp"
#include "scenes/info.hpp"

namespace pipegs {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

Scene one(int degree = 1) {
  Scene scene;
  scene.sh_degree = degree;
  scene.gaussians = {{{1, 2, 3}, {0, std::log(2.0f), -1}, {0, 0, 2, 0}, 0, {0.1f, 0.2f, 0.3f}}};
  scene.sh_rest.assign(static_cast<std::size_t>(3 * sh_rest_count(degree)), 0.5f);
  return scene;
}

TEST(Scene, ActivatesInDouble) {
  ActivatedGaussian g;
  ASSERT_EQ(activate(one(), 0, g), Cull::kNone);
  EXPECT_EQ(g.mean, glm::dvec3(1, 2, 3));
  EXPECT_EQ(g.scale.x, 1);
  EXPECT_NEAR(g.scale.y, 2, 1e-6);
  EXPECT_EQ(g.rotation, glm::dvec4(0, 0, 1, 0));
  EXPECT_EQ(g.opacity, 0.5);
}

TEST(Scene, AcceptsTheLegalExtremes) {
  Scene scene = one();
  ActivatedGaussian g;
  scene.gaussians[0].log_scale = {-kInf, -200, 88.7f};
  scene.gaussians[0].opacity_logit = kInf;
  scene.gaussians[0].rotation = {1e-20f, 0, 0, 1e-20f};
  ASSERT_EQ(activate(scene, 0, g), Cull::kNone);
  EXPECT_EQ(g.scale.x, 0);
  EXPECT_EQ(g.opacity, 1);
  EXPECT_NEAR(g.rotation[0], std::sqrt(0.5), 1e-15);
  scene.gaussians[0].rotation = {3e38f, 3e38f, 3e38f, 3e38f};
  scene.gaussians[0].opacity_logit = -kInf;
  ASSERT_EQ(activate(scene, 0, g), Cull::kNone);
  EXPECT_NEAR(g.rotation[3], 0.5, 1e-15);
  EXPECT_EQ(g.opacity, 0);
}

TEST(Scene, CullsEachBadValue) {
  const auto cull = [](auto&& damage) {
    Scene scene = one();
    damage(scene);
    ActivatedGaussian g;
    return activate(scene, 0, g);
  };
  for (const float bad : {kNan, kInf, -kInf}) {
    EXPECT_EQ(cull([&](Scene& s) { s.gaussians[0].mean.y = bad; }), Cull::kNonFinite);
    EXPECT_EQ(cull([&](Scene& s) { s.gaussians[0].sh_dc.z = bad; }), Cull::kNonFinite);
    EXPECT_EQ(cull([&](Scene& s) { s.gaussians[0].rotation[2] = bad; }), Cull::kNonFinite);
    EXPECT_EQ(cull([&](Scene& s) { s.sh_rest[8] = bad; }), Cull::kNonFinite);
  }
  for (const float bad : {kNan, kInf, 88.8f, 800.0f})
    EXPECT_EQ(cull([&](Scene& s) { s.gaussians[0].log_scale.x = bad; }), Cull::kNonFinite);
  EXPECT_EQ(cull([&](Scene& s) { s.gaussians[0].opacity_logit = kNan; }), Cull::kNonFinite);
  EXPECT_EQ(cull([](Scene& s) { s.gaussians[0].rotation = {0, 0, 0, -0.0f}; }), Cull::kZeroQuaternion);
}

TEST(Info, FindsEveryKindOfTroubleWithItsFirstIndex) {
  Scene scene = one(0);
  scene.gaussians[0].rotation = {1, 0, 0, 0};
  scene.gaussians[0].sh_dc.x = -0.1f;
  scene.gaussians.resize(20, scene.gaussians[0]);
  for (std::size_t i = 0; i < 20; ++i) scene.gaussians[i].mean.x = static_cast<float>(i);
  scene.gaussians[3].mean.x = kNan;
  scene.gaussians[5].rotation = {0, 0, 0, 0};
  scene.gaussians[7].rotation = {2, 0, 0, 0};
  scene.gaussians[8].opacity_logit = -9;
  scene.gaussians[9].opacity_logit = -9;
  scene.gaussians[11].log_scale = {0, 0, -12};
  scene.gaussians[13].log_scale = {6, 6, 6};
  const SceneInfo info = inspect(scene, check_scene(scene));
  EXPECT_EQ(info.gaussians, 20u);
  EXPECT_EQ(info.usable, 18u);
  EXPECT_EQ(info.highest.x, 19);
  const std::vector<std::pair<std::size_t, std::size_t>> wanted = {{1, 3}, {1, 5}, {1, 7}, {2, 8}, {1, 11}, {1, 13}};
  ASSERT_EQ(info.findings.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(info.findings[i].count, wanted[i].first) << info.findings[i].what;
    EXPECT_EQ(info.findings[i].first, wanted[i].second) << info.findings[i].what;
  }
  EXPECT_NE(to_text(info).find("first at index 13"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(to_json(info))["findings"].size(), wanted.size());
}

TEST(Info, SuspectsScalesThatAreNoLogarithms) {
  Scene scene = one(0);
  scene.gaussians.resize(50, scene.gaussians[0]);
  for (std::size_t i = 0; i < 50; ++i) {
    scene.gaussians[i].mean.x = 0.1f * static_cast<float>(i);
    scene.gaussians[i].log_scale = {5, 5, 5};
  }
  EXPECT_NE(to_text(inspect(scene, check_scene(scene))).find("scales look linear"), std::string::npos);
}

TEST(Info, InspectsAnEmptyAndAFlatScene) {
  EXPECT_EQ(inspect(Scene{}).usable, 0u);
  Scene scene = one(0);
  scene.gaussians[0].log_scale.x = -kInf;
  EXPECT_TRUE(nlohmann::json::accept(to_json(inspect(scene))));
}

TEST(Info, ANameThatIsNoUtf8IsWritten) {
  Scene scene;
  scene.name = "caf\xe9";
  EXPECT_EQ(nlohmann::json::parse(to_json(inspect(scene)))["name"], "caf\xef\xbf\xbd");
}

}  // namespace
}  // namespace pipegs
