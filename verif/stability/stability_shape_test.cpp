// SPDX-License-Identifier: Apache-2.0
// Hard shapes: flat, needle, degenerate, tiny and huge Gaussians (T4 to T8, T26 of docs/numerics/stability.md).
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "cpp_model/pu/conic/pu_conic.hpp"
#include "verif/pu/pu_chain.hpp"
#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

// A Gaussian turned by `degrees` in the image plane and then by `tilt` out of it.
Gaussian turned(Gaussian g, double degrees, double tilt = 0) {
  const glm::dquat q = glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 0, 1)) *
                       glm::angleAxis(glm::radians(tilt), glm::dvec3(0, 1, 0));
  g.rotation = {static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  return g;
}

// One dimension of size zero in each axis, at every angle: the dilation of 0.3 gives it a width.
TEST(Stability, T04_FlatSplats) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 48; ++i) {
    Gaussian g = gaussian_at(
        {0.1f * static_cast<float>(i % 8 - 4), 0.12f * static_cast<float>(i / 8 - 3), 2 + 0.1f * static_cast<float>(i)},
        0.05f);
    g.log_scale[i % 3] = -INFINITY;
    if (i % 4 == 0) g.log_scale[(i + 1) % 3] = -INFINITY;
    gaussians.push_back(turned(g, 7.5 * i, 15.0 * i));
  }
  Simulation simulation;
  expect_stable("T04", scene_of(gaussians), test_camera(128, 96), simulation);
  EXPECT_GT(simulation.golden.work.blended, 1000u);
}

// a c - b b cancels in float; here the determinant is a sum of positive terms.
TEST(Stability, T05_NeedleDeterminant) {
  int cancelled = 0, drawn = 0;
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 36; ++i) {
    const double ratio = std::pow(10.0, 4 + 2 * (i % 9) / 8.0), length = 0.02 * std::pow(10.0, i % 5 / 2.0);
    Gaussian g = gaussian_at({0, 0, 2.0f + 0.05f * static_cast<float>(i)}, 1, 0.5);
    g.log_scale = {static_cast<float>(std::log(length)), static_cast<float>(std::log(length / ratio)),
                   static_cast<float>(std::log(length / ratio))};
    gaussians.push_back(turned(g, 45 + 5.0 * (i / 9)));
  }
  const Scene scene = scene_of(gaussians);
  const Camera camera = test_camera(128, 128, 400);
  expect_stable("T05", scene, camera);
  for (size_t i = 0; i < gaussians.size(); ++i) {
    ActivatedGaussian g;
    ASSERT_EQ(activate(scene, i, g), Cull::kNone);
    const TruthProjection p = project_truth(g, {}, nullptr, 0, camera, {});
    const auto a = static_cast<float>(p.a), b = static_cast<float>(p.b), c = static_cast<float>(p.c);
    cancelled += std::abs(static_cast<double>(a * c - b * b) / p.det - 1) > 0.001;
    drawn += p.visible;
  }
  EXPECT_EQ(drawn, 36) << "with det from positive terms both policies, det <= 0 and det == 0, drop none";
  std::printf("T05: the usual a c - b b in float is off by more than 0.1 %% for %d of 36\n", cancelled);
  EXPECT_GT(cancelled, 0) << "the case is not hard";
}

// Whatever the hostile record, the model's determinant is positive and its box is that of its own
// variance.
TEST(Stability, T06_DegenerateCovarianceGivesASaneBox) {
  const Config config;
  std::mt19937_64 rng(6);
  PuRandom random{config, rng};
  for (int i = 0; i < 50000; ++i) {
    const Frame frame = random.frame();
    const Covariance s = pu_covariance(config, frame, random_squares(random, frame), random.center());
    ASSERT_GT(s.det_m, 0u) << i;
    const Conic k = pu_conic(config, frame, s);
    for (const auto& [extent, m, e] : {std::tuple{k.extent_x, s.a_m, s.a_e}, {k.extent_y, s.c_m, s.c_e}}) {
      const double sigma = std::sqrt(std::ldexp(static_cast<double>(m), static_cast<int>(e)));
      const double other = std::sqrt(std::max(std::ldexp(static_cast<double>(s.a_m), static_cast<int>(s.a_e)),
                                              std::ldexp(static_cast<double>(s.c_m), static_cast<int>(s.c_e))));
      ASSERT_LE(std::ldexp(static_cast<double>(extent), -4), std::min(3.4 * sigma + 0.5 + other * 0x1p-20, 0x1p18))
          << i;
    }
  }
  std::vector<Gaussian> points;
  for (int i = 0; i < 20; ++i) {
    points.push_back(gaussian_at({0.05f * static_cast<float>(i - 10), 0, 2}, 0.05f));
    points.back().log_scale = glm::vec3(-INFINITY);
  }
  Simulation simulation;
  expect_stable("T06", scene_of(points), test_camera(96, 64), simulation);
  EXPECT_LE(simulation.golden.work.regions, 20u * 4) << "a point is no full-screen flash";
}

TEST(Stability, T07_AxisAligned) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 24; ++i) {
    Gaussian g =
        gaussian_at({0, 0, 2 + 0.1f * static_cast<float>(i)}, 0.1f, 0.4);  // on the axis of the camera: b is exactly 0
    if (i % 3 != 0) g.log_scale[i % 3 - 1] = -6;
    gaussians.push_back(turned(g, 90.0 * (i % 4)));
  }
  expect_stable("T07", scene_of(gaussians), test_camera(65, 65));
}

// Standard deviations below the smallest half: every one is drawn, as the dilated point it is.
TEST(Stability, T08_TinyScalesKeepTheirAxis) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 30; ++i) {
    Gaussian g =
        gaussian_at({0.06f * static_cast<float>(i % 6 - 3), 0.06f * static_cast<float>(i / 6 - 2), 2}, 0.05f, 0.7);
    g.log_scale = glm::vec3(std::log(2.4e-4f) - 0.4f * static_cast<float>(i));
    if (i % 2 == 0) g.log_scale.x = std::log(0.1f);
    gaussians.push_back(turned(g, 12.0 * i));
  }
  Simulation simulation;
  expect_stable("T08", scene_of(gaussians), test_camera(64, 64), simulation);
  EXPECT_EQ(simulation.golden.work.visible, 30u);
  EXPECT_EQ(simulation.golden.work.records, 30u);
}

// A splat of any radius covers all that it should: no hidden cap.
TEST(Stability, T26_NoCapOfTheRadius) {
  for (const float sigma : {100.0f, 1000.0f, 10000.0f, 100000.0f}) {  // pixels
    Simulation simulation;
    expect_stable("T26", scene_of({gaussian_at({0, 0, 1}, sigma / 100, 0.6)}), test_camera(320, 40), simulation);
    for (const double t : simulation.golden.image.transmittance)
      ASSERT_NEAR(t, 1 - 0.6 * (sigma > 100 ? 1 : 0.6), sigma > 100 ? 0.01 : 0.25) << sigma;
  }
}

}  // namespace
}  // namespace pipegs
