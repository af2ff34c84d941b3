// SPDX-License-Identifier: Apache-2.0
// Beyond the list: needles of any ratio at any angle, sizes, places, loads, and values at the ends of the formats.
//
// The largest values are derived from the Config, so that a changed width moves the test with it.
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

glm::vec4 turn(double degrees, double tilt) {
  const glm::dquat q = glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 0, 1)) *
                       glm::angleAxis(glm::radians(tilt), glm::dvec3(0, 1, 0));
  return {static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
}

// Ratio 1e2 to 1e8, in the image plane in steps of 7.5 degrees, and tilted out of it up to end on.
TEST(StabilityBeyond, NeedlesAtEveryAngle) {
  for (const double ratio : {1e2, 1e4, 1e6, 1e8}) {
    std::vector<Gaussian> gaussians;
    for (const double tilt : {0.0, 30.0, 60.0, 89.0, 90.0}) {
      for (int step = 0; step < 24; ++step) {
        const float z = 2 + 0.01f * static_cast<float>(gaussians.size());
        Gaussian g = gaussian_at(
            {0.02f * static_cast<float>(step % 5 - 2) * z, 0.02f * static_cast<float>(step % 7 - 3) * z, z}, 1, 0.12);
        const double length = 0.25;  // 12 pixels and a half at z = 2
        g.log_scale = {static_cast<float>(std::log(length)), static_cast<float>(std::log(length / ratio)),
                       static_cast<float>(std::log(length / ratio / 2))};
        g.rotation = turn(7.5 * step, tilt);
        gaussians.push_back(g);
      }
    }
    expect_stable(fmt::format("needles {:g}", ratio), scene_of(gaussians), test_camera(96, 80));
  }
}

TEST(StabilityBeyond, FromSpecksToScreens) {
  std::vector<Gaussian> gaussians;
  for (int e = -40; e <= 16; e += 4)
    gaussians.push_back(
        gaussian_at({0.01f * static_cast<float>(e), -0.008f * static_cast<float>(e), 2 + 0.01f * static_cast<float>(e)},
                    std::ldexp(1.0f, e), 0.15));
  expect_stable("specks to screens", scene_of(gaussians), test_camera(96, 64));
}

// Means thousands of pixels from the image, wide enough to reach it.
TEST(StabilityBeyond, AnchorsFarFromTheImage) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 16; ++i) {
    const double angle = i * 3.14159265 / 8, far = 20 * std::pow(2.0, i % 5);  // x / z up to 320: 32000 pixels
    Gaussian g = gaussian_at({static_cast<float>(far * std::cos(angle)), static_cast<float>(far * std::sin(angle)), 1},
                             static_cast<float>(far * 0.4), 0.3);
    g.rotation = turn(20.0 * i, 10.0 * i);
    gaussians.push_back(g);
  }
  Simulation simulation;
  expect_stable("far anchors", scene_of(gaussians), test_camera(96, 64), simulation, {.vacuous_allowed = true});
  EXPECT_GT(simulation.golden.work.records, 0u);
}

// T falls below 1e-4 at the 1st to the 12th Gaussian, in every row of a region and in each quarter of a region's
// pixels.
TEST(StabilityBeyond, StopsInEveryPhase) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 12; ++i) {
    // A front that leaves one row or column of regions' pixels open for the next one.
    Gaussian g = gaussian_at({0, 0.01f * static_cast<float>(i - 6), 1 + 0.02f * static_cast<float>(i)},
                             0.02f + 0.01f * static_cast<float>(i), 0.9, {1, static_cast<float>(i % 3) - 1, 0});
    g.opacity_logit = i % 2 == 0 ? INFINITY : 2.0f;
    g.log_scale.x = i % 3 == 0 ? 2 : g.log_scale.x;
    gaussians.push_back(g);
  }
  for (int i = 0; i < 12; ++i)
    gaussians.push_back(gaussian_at({0, 0, 3 + 0.1f * static_cast<float>(i)}, 2.0f, 0.3 + 0.06 * i, {-1, 1, 1}));
  Simulation simulation;
  expect_stable("stops", scene_of(gaussians), test_camera(72, 72), simulation);
  size_t last[25] = {};
  for (const uint32_t n : simulation.golden.image.blended) ++last[std::min<uint32_t>(n, 24)];
  EXPECT_GT(std::count_if(std::begin(last), std::end(last), [](size_t n) { return n > 0; }), 8);
}

TEST(StabilityBeyond, ColoursFarOutside) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 40; ++i) {
    const float far = std::ldexp(1.0f, i / 4 - 3);
    gaussians.push_back(gaussian_at({0.04f * static_cast<float>(i % 8 - 4), 0.05f * static_cast<float>(i / 8 - 2),
                                     1 + 0.02f * static_cast<float>(i)},
                                    0.05f, 0.7, {far, -far, i % 2 == 0 ? far : -far}));
  }
  Simulation simulation;
  expect_stable("colours", scene_of(gaussians), test_camera(96, 80), simulation);
  EXPECT_GT(simulation.packed.counts.saturated_base, 0u) << "counted where the record clips";
  Scene sh = scene_of(gaussians);  // SH at the end of its format, which ends at 16
  sh.sh_degree = 3;
  for (size_t i = 0; i < gaussians.size() * 45; ++i)
    sh.sh_rest.push_back((i % 2 == 0 ? 1.0f : -1.0f) * std::ldexp(1.0f, static_cast<int>(i / 45) % 12 - 6));
  expect_stable("colours with SH", sh, test_camera(96, 80), simulation);
  EXPECT_GT(simulation.packed.counts.saturated_sh, 0u);
  EXPECT_GT(simulation.golden.saturations.color, 0u) << "counted where the colour clips";
}

// Ten thousand Gaussians of the smallest alpha over one pixel: T and the weights stay one, to the rounding of each.
TEST(StabilityBeyond, TenThousandFaintOnesOverOnePixel) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 10000; ++i)
    gaussians.push_back(gaussian_at({0, 0, 2 + 1e-4f * static_cast<float>(i)}, 0.5f, 1.02 / 255,
                                    glm::vec3(0.5f / 0.28209479177387814f)));
  Simulation simulation;
  expect_stable("faint", scene_of(gaussians), test_camera(9, 9), simulation);
  const Image& image = simulation.golden.image;
  const double weights = image.rgb[image.at(4, 4)].r, left = image.transmittance[image.at(4, 4)];
  EXPECT_NEAR(weights, 1 - left, 10000 * blend_rounding(Config{}));
  std::printf("faint: T %.6f, weights %.6f\n", left, weights);
}

// World coordinates, offsets and scales at the ends of their fields: a scene 2^20 across beside a camera, and the
// widest scales.
TEST(StabilityBeyond, EndsOfTheFormats) {
  const Config config;
  std::vector<Gaussian> gaussians;
  const auto far = static_cast<float>(std::ldexp(1.0, config.pos_w));
  for (int i = 0; i < 8; ++i)
    gaussians.push_back(gaussian_at({i & 1 ? far : -far, i & 2 ? far : -far, i & 4 ? far : -far}, far / 8, 0.4));
  for (int i = 0; i < 8; ++i)
    gaussians.push_back(gaussian_at({0.1f * static_cast<float>(i - 4), 0, 1 + static_cast<float>(i)}, 0.1f, 0.4));
  Simulation simulation;
  expect_stable("ends of positions", scene_of(gaussians), test_camera(64, 64), simulation, {.vacuous_allowed = true});
  // The largest scale field: 2^(2^ScaleEW - 9) world units; beyond it the record clips and counts.
  const double top = std::ldexp(1.0, (1 << config.scale_e_w) - 8 + simulation.packed.scene_exponent);
  for (const double by : {0.5, 0.999, 1.001, 4.0}) {
    std::vector<Gaussian> wide = gaussians;
    const double scale = std::min(top * by, 3e38);
    wide.push_back(gaussian_at({0, 0, 1}, static_cast<float>(scale), 0.2));
    expect_stable("ends of scales", scene_of(wide), test_camera(64, 64), simulation, {.vacuous_allowed = true});
    EXPECT_EQ(simulation.packed.counts.saturated_scale, by > 1 ? 3u : 0u) << by;
  }
}

}  // namespace
}  // namespace pipegs
