// SPDX-License-Identifier: Apache-2.0
// Hard views: near plane, guard band, tiny scenes and images, a camera inside (T10 to T12, T25, T27 of
// docs/numerics/stability.md).
#include <cmath>

#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

TEST(Stability, T10_NearPlane) {
  std::vector<Gaussian> gaussians;
  for (const float z :
       {0.01f, 0.19999f, std::nextafter(0.2f, 0.0f), 0.2f, std::nextafter(0.2f, 1.0f), 0.2001f, 0.21f, 0.25f}) {
    for (const float x : {-0.1f, 0.0f, 0.15f}) gaussians.push_back(gaussian_at({x, 0.5f * x, z}, 0.02f, 0.2));
  }
  Simulation simulation;
  expect_stable("T10", scene_of(gaussians), test_camera(96, 80), simulation);
  // float(0.2) lies above 0.2: of the three around it only the lower is behind for certain.
  EXPECT_GE(simulation.golden.work.visible, 9u);
  for (size_t i = 0; i < gaussians.size(); ++i) gaussians[i].mean.z = 0.01f;
  expect_stable("T10 behind", scene_of(gaussians), test_camera(96, 80), simulation);
  EXPECT_EQ(simulation.golden.work.records, 0u);
}

// At the edge of the guard band the Jacobian's tangent is clamped, x / z itself is not.
TEST(Stability, T11_GuardBand) {
  const Camera camera = test_camera(128, 96);
  const double tx = 128 / 200.0, ty = 96 / 200.0;
  std::vector<Gaussian> gaussians;
  for (const double by : {1.0, 1.29, 1.2999999, 1.3, 1.3000001, 1.31, 2.0, 5.0}) {
    for (const int side : {-1, 1}) {
      const float z = 1.5f;
      Gaussian g = gaussian_at({static_cast<float>(side * by * tx) * z, 0, z}, 0.25f * static_cast<float>(by), 0.4);
      gaussians.push_back(g);
      g.mean = {0, static_cast<float>(side * by * ty) * z, z};
      g.log_scale.x -= 2;
      gaussians.push_back(g);
      g.mean = {static_cast<float>(side * by * tx) * z, static_cast<float>(by * ty) * z, z};
      g.log_scale = {-1, -6, 0};
      gaussians.push_back(g);
    }
  }
  Simulation simulation;
  expect_stable("T11", scene_of(gaussians), camera, simulation);
  EXPECT_GT(simulation.golden.work.records, 16u);
}

// A scene 2^-12 as large, with its near plane: the same bits, because every unit is a power of two of the scene's size.
TEST(Stability, T12_TinyScenes) {
  const Scene scene = random_scene(112, 200, 0);
  const Camera camera = test_camera(96, 64);
  Simulation whole, tiny;
  expect_stable("T12", scene, camera, whole);
  Scene small = scene;
  for (Gaussian& g : small.gaussians) {
    g.mean *= 0x1p-12f;
    g.log_scale += static_cast<float>(-12 * std::log(2.0));
  }
  expect_stable("T12 tiny", small, camera, tiny, {.near_plane = std::ldexp(0.2, -12)});
  // exp(log s - 12 ln 2) is rounded in float, so scales may differ in the last bit of the record.
  for (size_t i = 0; i < whole.golden.image.rgb.size(); ++i)
    ASSERT_NEAR(whole.golden.image.rgb[i].r, tiny.golden.image.rgb[i].r, 0.02) << i;
  Simulation gone;
  simulate_golden(small, camera, stable_machine(), gone);
  EXPECT_EQ(gone.golden.work.records, 0u)
      << "with the near plane of a room nothing of it is left: the plane is a parameter";
}

TEST(Stability, T25_ImagesOfAnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {7, 9}, {15, 16}, {16, 17}, {63, 65}, {129, 3}}) {
    expect_stable(fmt::format("T25 {}x{}", width, height), random_scene(125, 60, 0), test_camera(width, height, 30));
  }
}

// The camera in the middle of Gaussians, and one whose centre is the camera: it is culled before its direction is 0 /
// 0.
TEST(Stability, T27_CameraInside) {
  std::vector<Gaussian> gaussians;
  for (const glm::vec3 mean : {glm::vec3(0), glm::vec3(0, 0, 1e-30f), glm::vec3(0, 0, -1), glm::vec3(0.1f, 0, 0.3f),
                               glm::vec3(-2, 1, 0.5f), glm::vec3(0, 0, 0.21f)}) {
    for (const float scale : {0.3f, 3.0f, 30.0f}) gaussians.push_back(gaussian_at(mean, scale, 0.15));
  }
  Scene scene = scene_of(gaussians);
  scene.sh_degree = 1;
  scene.sh_rest.assign(9 * gaussians.size(), 0.2f);
  Simulation simulation;
  expect_stable("T27", scene, test_camera(96, 64), simulation);
  EXPECT_LE(simulation.golden.work.visible, 2u * 9) << "three of six centres lie before the near plane; two windows";
  EXPECT_GT(simulation.golden.work.blended, 0u);
}

}  // namespace
}  // namespace pipegs
