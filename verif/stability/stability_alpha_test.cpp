// SPDX-License-Identifier: Apache-2.0
// Hard alphas: the cut at 1/255, the cap at 0.99, powers above 0, the stop at 1e-4 (T13 to T15, T21 of
// docs/numerics/stability.md).
#include <cmath>

#include "cpp_model/pu/rows/pu_alpha.hpp"
#include "cpp_model/ru/ru_blend.hpp"
#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

float logit_of(double opacity) { return static_cast<float>(std::log(opacity) - std::log1p(-opacity)); }

TEST(Stability, T13_OpacitiesAroundTheCut) {
  std::vector<Gaussian> gaussians;
  const float at_cut = logit_of(1.0 / 255);
  const std::vector<float> logits = {-INFINITY, logit_of(1.0 / 256),          std::nextafter(at_cut, -10.0f),
                                     at_cut,    std::nextafter(at_cut, 0.0f), logit_of(1.0 / 254)};
  for (size_t i = 0; i < logits.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      Gaussian g = gaussian_at({0.1f * static_cast<float>(i) - 0.25f, 0.1f * static_cast<float>(k) - 0.15f, 1},
                               0.001f * static_cast<float>(1 + 20 * k));
      g.opacity_logit = logits[i];
      gaussians.push_back(g);
    }
  }
  Simulation simulation;
  expect_stable("T13", scene_of(gaussians), test_camera(64, 64), simulation);
  EXPECT_GE(simulation.packed.counts.transparent, 8u) << "0 and 1/256 are left out and counted";
}

// The mean on a pixel's centre: the power there is -log2(opacity), exactly 0 for opacity 1.
TEST(Stability, T14_ExactBoundaries) {
  const Config config;
  const Camera camera = test_camera(65, 65, 128);  // the principal point is pixel 32
  for (const double opacity : {1.0, 0.995, 0.99, 0.5, 1.0 / 255}) {
    Gaussian g = gaussian_at({0, 0, 2}, 0.01f);
    g.opacity_logit = opacity == 1 ? INFINITY : logit_of(opacity);
    Simulation simulation;
    expect_stable("T14", scene_of({g}), camera, simulation);
    const double code = std::round((1 - simulation.golden.image.transmittance[simulation.golden.image.at(32, 32)]) *
                                   (1 << config.alpha_w));
    if (opacity >= 0.99) {
      EXPECT_EQ(code, config.alpha_max()) << opacity;
    } else if (opacity > 0.1) {
      EXPECT_NEAR(code / (1 << config.alpha_w), opacity, alpha_rounding(config) + 1e-4) << opacity;
    } else {
      EXPECT_LE(code, 1) << "at the cut itself either side is right";
    }
  }
}

// Rounding may lift the power of the peak above 0: it is clamped, not skipped, whatever the power.
TEST(Stability, T15_PowerAboveZeroKeepsThePeak) {
  const Config config;
  const PuAlpha alpha(config);
  for (const int64_t power : {int64_t{1}, int64_t{100}, (int64_t{1} << (config.power_w() - 1)) - 1})
    EXPECT_EQ(alpha(power), alpha(0)) << power;
  EXPECT_EQ(alpha(0), static_cast<uint32_t>(config.alpha_max()));
  std::vector<Gaussian> gaussians;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) {  // peaks on pixel centres, far from their region's first pixel, opacity 1
      Gaussian g = gaussian_at({static_cast<float>(10 * x - 25), static_cast<float>(10 * y - 25), 64},
                               0.4f * static_cast<float>(1 + x));
      g.opacity_logit = INFINITY;
      g.log_scale.y += static_cast<float>(y);
      g.rotation = {1, 0, 0, 0.1f * static_cast<float>(x + y)};
      gaussians.push_back(g);
    }
  }
  const Camera camera = test_camera(65, 65, 64);
  Simulation simulation;
  expect_stable("T15", scene_of(gaussians), camera, simulation);
  for (const Gaussian& g : gaussians) {
    const Image& image = simulation.golden.image;
    EXPECT_LT(image.transmittance[image.at(static_cast<int>(32 + g.mean.x), static_cast<int>(32 + g.mean.y))], 0.013);
  }
}

// (1 - 0.99)^2 = 1e-4: `<` goes on at equality, `<=` would stop. Here the compare is exact in integers.
TEST(Stability, T21_StopAtTheBoundary) {
  const Config config;
  const BlendConstants k(config);
  const uint32_t white[3] = {1u << (config.color_w - 2), 0, 0};
  int equal = 0;
  for (uint32_t code = 1; code <= static_cast<uint32_t>(config.alpha_max()); ++code) {
    for (uint32_t t = k.stop; t < 300 * k.stop && t <= k.one; ++t) {
      const auto weight =
          static_cast<uint32_t>((uint64_t{t} * code + (uint64_t{1} << (config.alpha_w - 1))) >> config.alpha_w);
      if (t - weight != k.stop && t - weight + 1 != k.stop) continue;
      PixelState pixel{.t = t};
      ru_blend(k, pixel, code, white);
      ASSERT_EQ(pixel.done, t - weight < k.stop);
      ASSERT_EQ(pixel.t, pixel.done ? t : k.stop);
      equal += !pixel.done;
    }
  }
  EXPECT_GT(equal, 100);
  // In a picture: opaque ones behind each other, then one that only a pixel that has not stopped shows.
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 4; ++i) {
    gaussians.push_back(
        gaussian_at({0, 0, 1 + 0.1f * static_cast<float>(i)}, 1.0f, 0.5, {1, i % 2 == 0 ? 1.0f : -1.0f, 0}));
    gaussians.back().opacity_logit = INFINITY;
  }
  Simulation simulation;
  expect_stable("T21", scene_of(gaussians), test_camera(32, 32), simulation);
  const double once = 1 - std::ldexp(static_cast<double>(config.alpha_max()), -config.alpha_w);
  const double left = simulation.golden.image.transmittance[simulation.golden.image.at(16, 16)];
  EXPECT_NEAR(left, once * once, 2 * weight_rounding(config))
      << "two are blended: " << once * once << " is not below " << stop_level(config);
}

}  // namespace
}  // namespace pipegs
