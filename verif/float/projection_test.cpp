// SPDX-License-Identifier: Apache-2.0
// Against cpp_model/float/projection: covariance, determinant, guard band, SH and footprints.
//
// Idea    Covariance is compared with the textbook product J W R S S^T R^T W^T J^T, the SH with
//         single coefficients along the axes, footprints with a scan of all pixels.
#include "cpp_model/float/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

namespace pipegs {
namespace {

Camera tilted(int width = 200, int height = 150) {
  Camera c = look_at("", 0, width, height, {1, -2, -4}, {0.2, -0.5, 0.3}, 60);
  c.fy *= 1.03;
  return c;
}

ActivatedGaussian random_gaussian(std::mt19937& random, double spread = 2) {
  const auto u = [&] { return (static_cast<double>(random()) / 4294967296.0 * 2 - 1) * spread; };
  glm::dvec4 q(u(), u(), u(), u());
  q /= glm::length(q);
  return {{u(), u(), u()}, {std::exp(u() - 2), std::exp(u() - 2), std::exp(u() - 2)}, q, 0.5 + 0.2 * u()};
}

TEST(Projection, CovarianceIsTheTextbookProduct) {
  std::mt19937 random(3);
  const Camera camera = tilted();
  for (int i = 0; i < 500; ++i) {
    const ActivatedGaussian g = random_gaussian(random, 1.2);
    const TruthProjection p = project_truth(g, glm::vec3(0), nullptr, 0, camera, {});
    const glm::dvec3 t = camera.world_to_camera * (g.mean - camera.position);
    ASSERT_GT(t.z, 0.2);
    EXPECT_EQ(p.depth, t.z);
    EXPECT_NEAR(p.mean.x, camera.fx * t.x / t.z + 99.5, 1e-9);
    const double limit_x = 1.3 * 200 / (2 * camera.fx), limit_y = 1.3 * 150 / (2 * camera.fy);
    const double x = std::clamp(t.x / t.z, -limit_x, limit_x), y = std::clamp(t.y / t.z, -limit_y, limit_y);
    const glm::dmat3 j(glm::dvec3(camera.fx / t.z, 0, 0), glm::dvec3(0, camera.fy / t.z, 0),
                       glm::dvec3(-camera.fx * x / t.z, -camera.fy * y / t.z, 0));
    const glm::dmat3 r = glm::mat3_cast(glm::dquat(g.rotation[0], g.rotation[1], g.rotation[2], g.rotation[3]));
    const glm::dmat3 s(glm::dvec3(g.scale.x, 0, 0), glm::dvec3(0, g.scale.y, 0), glm::dvec3(0, 0, g.scale.z));
    const glm::dmat3 u = j * camera.world_to_camera * r * s, cov = u * glm::transpose(u);
    EXPECT_NEAR(p.a, cov[0][0] + 0.3, 1e-9 * p.a);
    EXPECT_NEAR(p.b, cov[0][1], 1e-9 * std::sqrt(p.a * p.c));
    EXPECT_NEAR(p.c, cov[1][1] + 0.3, 1e-9 * p.c);
    EXPECT_NEAR(p.det, p.a * p.c - p.b * p.b, 1e-9 * p.a * p.c);
    EXPECT_NEAR(p.conic.x * p.a + p.conic.y * p.b, 1, 1e-6);
    EXPECT_NEAR(p.conic.x * p.b + p.conic.y * p.c, 0, 1e-6);
  }
}

TEST(Projection, ANeedleKeepsItsDeterminant) {
  Camera camera = tilted();
  camera.position = glm::dvec3(0);
  camera.world_to_camera = glm::dmat3(1);
  camera.fx = camera.fy = 1000;
  // 1e6 : 1 at 45 degrees: a*c - b*b would lose every digit of this.
  const double half = std::sqrt(0.5), angle = 0.5 * std::asin(1.0) / 2;
  ActivatedGaussian g{{0, 0, 1}, {1e4, 1e-8, 1e-8}, {std::cos(angle), 0, 0, std::sin(angle)}, 0.9};
  const TruthProjection p = project_truth(g, glm::vec3(0), nullptr, 0, camera, {});
  const double variance = std::pow(1000 * 1e4, 2);
  EXPECT_TRUE(p.visible);
  EXPECT_NEAR(p.a, half * half * variance, 1e-9 * variance);
  EXPECT_NEAR(p.det, 0.3 * variance, 1e-6 * variance);
  EXPECT_NEAR(1.0, p.det / (0.3 * (variance + 0.3)), 1e-9);
}

TEST(Projection, TheGuardBandActsInsideTheJacobianOnly) {
  Camera camera = tilted(200, 200);
  camera.position = glm::dvec3(0);
  camera.world_to_camera = glm::dmat3(1);
  camera.fy = camera.fx;
  const double edge = 1.3 * 200 / (2 * camera.fx);
  const auto variance = [&](double ratio) {
    const ActivatedGaussian g{{ratio * 2, 0, 2}, {1e-9, 1e-9, 0.1}, {1, 0, 0, 0}, 0.5};
    const TruthProjection p = project_truth(g, glm::vec3(0), nullptr, 0, camera, {});
    EXPECT_NEAR(p.mean.x, camera.fx * ratio + 99.5, 1e-9);
    return p.a;
  };
  EXPECT_LT(variance(edge * 0.99), variance(edge * 0.999));
  EXPECT_NEAR(variance(edge), variance(edge * 1.01), 1e-9);
  EXPECT_NEAR(variance(edge), variance(edge * 5), 1e-9);
}

TEST(Projection, AntialiasedOpacityShrinksWithTheSplat) {
  Camera camera = tilted();
  const auto opacity = [&](double scale, bool antialiased) {
    ProjectionOptions options;
    options.antialiased = antialiased;
    return project_truth({{0, 0, 0}, glm::dvec3(scale), {1, 0, 0, 0}, 0.8}, glm::vec3(0), nullptr, 0, camera, options)
        .opacity;
  };
  EXPECT_EQ(opacity(0.01, false), 0.8);
  EXPECT_NEAR(opacity(10, true), 0.8, 1e-4);
  EXPECT_LT(opacity(0.01, true), 0.79);
  EXPECT_NEAR(opacity(0, true), 0.8 * 0.005, 1e-12);  // the floor
}

TEST(Projection, ShHasTheSignsAndOrderOfInria) {
  // Along +y, +z, +x only the m = 0-like terms remain; each coefficient alone, channel by channel.
  const glm::dvec3 axes[] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const double first[3][3] = {{-0.4886025119029199, 0, 0}, {0, 0.4886025119029199, 0}, {0, 0, -0.4886025119029199}};
  for (int k = 0; k < 3; ++k) {
    for (int channel = 0; channel < 3; ++channel) {
      float rest[9] = {};
      rest[k * 3 + channel] = 0.25f;
      for (int a = 0; a < 3; ++a)
        EXPECT_NEAR(sh_color(glm::vec3(0), rest, 1, axes[a])[channel], 0.5 + 0.25 * first[a][k], 1e-15);
    }
  }
  EXPECT_EQ(sh_color(glm::vec3(-10), nullptr, 0, axes[0]), glm::dvec3(0));  // clamped below
  EXPECT_GT(sh_color(glm::vec3(10), nullptr, 0, axes[0]).x, 3);             // not above
}

TEST(Projection, ShBasisIsOrthonormal) {
  // Integrated over the sphere by Gauss' rule in z and evenly in azimuth: exact to degree 6.
  const double nodes[] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                          0.9739065285171717};
  const double weights[] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806,
                            0.0666713443086881};
  double gram[15][15] = {};
  constexpr int kTurns = 16;
  for (int n = 0; n < 10; ++n) {
    const double z = n % 2 == 0 ? nodes[n / 2] : -nodes[n / 2], ring = std::sqrt(1 - z * z);
    for (int t = 0; t < kTurns; ++t) {
      const double angle = 2 * M_PI * (t + 0.3) / kTurns;
      double basis[15];
      sh_basis({ring * std::cos(angle), ring * std::sin(angle), z}, basis);
      for (int i = 0; i < 15; ++i) {
        for (int j = 0; j < 15; ++j) gram[i][j] += basis[i] * basis[j] * weights[n / 2] * 2 * M_PI / kTurns;
      }
    }
  }
  for (int i = 0; i < 15; ++i) {
    for (int j = 0; j < 15; ++j) EXPECT_NEAR(gram[i][j], i == j, 1e-12) << i << " " << j;
  }
}

TEST(Projection, TheExactFootprintLosesNoPixelAndWastesNoRow) {
  std::mt19937 random(9);
  const Camera camera = tilted();
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const TruthProjection p = project_truth(random_gaussian(random), glm::vec3(0), nullptr, 0, camera, {});
    const PixelRect rect = footprint(p, camera, Semantics::kExact);
    if (!p.visible) continue;
    PixelRect tight{1 << 20, 1 << 20, 0, 0};
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const double power = std::min(0.0, power_at(p.conic, p.mean.x - x, p.mean.y - y));
        if (std::min(kMaxAlpha, p.opacity * std::exp(power)) < kMinAlpha) continue;
        tight = {std::min(tight.x0, x), std::min(tight.y0, y), std::max(tight.x1, x + 1), std::max(tight.y1, y + 1)};
      }
    }
    if (tight.empty()) continue;
    ++seen;
    EXPECT_LE(rect.x0, tight.x0);
    EXPECT_LE(rect.y0, tight.y0);
    EXPECT_GE(rect.x1, tight.x1);
    EXPECT_GE(rect.y1, tight.y1);
  }
  EXPECT_GT(seen, 100);
}

TEST(Projection, InriasTilesAreThoseOfGetRect) {
  const Camera camera = tilted(40, 40);  // three tiles, the last one cut
  TruthProjection p;
  p.visible = true;
  p.opacity = 0.5;
  p.a = p.c = 4;
  p.det = 16;
  p.mean = {20, 20};  // lambda = 4 + sqrt(0.1): radius ceil(6.23) = 7
  PixelRect rect = footprint(p, camera, Semantics::kInria);
  EXPECT_EQ(rect.x0, 0);   // (20 - 7) / 16 = 0
  EXPECT_EQ(rect.x1, 32);  // (20 + 7 + 15) / 16 = 2
  p.mean = {-8, 39};
  rect = footprint(p, camera, Semantics::kInria);
  EXPECT_TRUE(rect.empty());  // (-8 + 7 + 15) / 16 = 0
  p.mean = {-6, 39};
  rect = footprint(p, camera, Semantics::kInria);
  EXPECT_EQ(rect.x1, 16);
  EXPECT_EQ(rect.y0, 32);
  EXPECT_EQ(rect.y1, 40);
}

}  // namespace
}  // namespace pipegs
