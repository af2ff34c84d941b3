// SPDX-License-Identifier: Apache-2.0
// Against cpp_model/float/truth: pictures of one to a few Gaussians computed by hand, order, window.
//
// Idea    An isotropic Gaussian straight ahead has cov2d = (f s / z)^2 + 0.3 on both axes, so every
//         expected alpha is one line of arithmetic that shares nothing with the renderer.
#include "cpp_model/float/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "cpp_model/float/metrics.hpp"
#include "scenes/generate/generate.hpp"

namespace pipegs {
namespace {

constexpr float kOpaque = std::numeric_limits<float>::infinity();  // logit of 1

Camera camera_of(int width, int height, double focal = 100) {
  Camera c;
  c.width = width;
  c.height = height;
  c.fx = c.fy = focal;
  c.cx = (width - 1) / 2.0;
  c.cy = (height - 1) / 2.0;
  return c;
}

// A ball of colour (r, g, b) in front of the camera.
void add_ball(Scene& scene, const glm::vec3& mean, double sigma, float logit, const glm::dvec3& color) {
  const auto log_sigma = static_cast<float>(std::log(sigma));
  scene.gaussians.push_back(
      {mean, glm::vec3(log_sigma), {1, 0, 0, 0}, logit, glm::vec3((color - 0.5) / 0.28209479177387814)});
}

double sigmoid(double x) { return 1 / (1 + std::exp(-x)); }

TEST(Truth, OneBallHasTheAlphaComputedByHand) {
  Scene scene;
  add_ball(scene, {0, 0, 2}, 0.1, 1.5f, {0.9, 0.4, 0.1});
  const Image image = render_truth(scene, camera_of(63, 63), {});
  const double sigma = std::exp(static_cast<double>(static_cast<float>(std::log(0.1))));
  const double variance = std::pow(100 * sigma / 2, 2) + 0.3;
  for (int y = 0; y < 63; ++y) {
    for (int x = 0; x < 63; ++x) {
      const double power = -0.5 * (std::pow(x - 31, 2) + std::pow(y - 31, 2)) / variance;
      double alpha = sigmoid(1.5) * std::exp(power);
      if (alpha < 1.0 / 255) alpha = 0;
      const std::size_t i = image.at(x, y);
      EXPECT_NEAR(image.rgb[i].x, 0.9 * alpha, 1e-7);  // the colour went through float
      EXPECT_NEAR(image.transmittance[i], 1 - alpha, 1e-12);
      EXPECT_NEAR(image.depth[i], 2 * alpha, 1e-12);
      EXPECT_EQ(image.blended[i], alpha > 0 ? 1u : 0u);
    }
  }
}

TEST(Truth, ExactReachesWhereInriasThreeSigmaStops) {
  Scene scene;
  add_ball(scene, {0, 0, 2}, 0.4, kOpaque, {1, 1, 1});
  const Camera camera = camera_of(257, 257);
  TruthOptions options;
  const Image exact = render_truth(scene, camera, options);
  options.semantics = Semantics::kInria;
  const Image inria = render_truth(scene, camera, options);
  // sigma = 20 px: alpha reaches 1/255 at 66.6 px, INRIA's square at 61 px rounded up to its tile.
  EXPECT_EQ(exact.blended[exact.at(128 + 66, 128)], 1u);
  EXPECT_EQ(exact.blended[exact.at(128 + 67, 128)], 0u);
  EXPECT_EQ(inria.blended[inria.at(128 - 66, 128)], 0u);  // tile edge at 64
  EXPECT_EQ(inria.blended[inria.at(128 - 64, 128)], 1u);
  for (std::size_t i = 0; i < exact.rgb.size(); ++i) {
    if (inria.blended[i] == 0) continue;
    EXPECT_NEAR(inria.rgb[i].x, exact.rgb[i].x, 1e-6);
  }
}

TEST(Truth, GsplatLooksHalfAPixelAwayAndKeepsTheNearPlane) {
  Scene scene;
  add_ball(scene, {0.013f, -0.02f, 2}, 0.1, 3.0f, {1, 0.5, 0.2});
  const Camera camera = camera_of(64, 48);
  TruthOptions options;
  const Image exact = render_truth(scene, camera, options);
  options.semantics = Semantics::kGsplat;
  const Image gsplat = render_truth(scene, camera, options);
  EXPECT_LT(max_abs_error(exact, gsplat), 1e-12);  // the same picture in the other convention
  Scene near;
  add_ball(near, {0, 0, 0.5f}, 0.01, 0, {1, 1, 1});
  options.near_plane = 0.5;
  EXPECT_GT(render_truth(near, camera, options).rgb[24 * 64 + 32].x, 0);
  options.semantics = Semantics::kExact;
  EXPECT_EQ(render_truth(near, camera, options).rgb[24 * 64 + 32].x, 0);
}

TEST(Truth, CapsAlphaAndStopsBeforeTheGaussianThatWouldFinish) {
  Scene scene;
  for (int i = 0; i < 5; ++i) add_ball(scene, {0, 0, 2 + 0.1f * static_cast<float>(i)}, 0.1, kOpaque, {1, 1, 1});
  for (const Semantics semantics : {Semantics::kExact, Semantics::kInria, Semantics::kGsplat}) {
    TruthOptions options;
    options.semantics = semantics;
    const auto steps = explain_truth(scene, camera_of(33, 33), options, 16, 16);
    // T: 1, 0.01, then (1 - 0.99)^2 is 1e-4 or a rounding above: the rules < and <= may differ there.
    ASSERT_GE(steps.size(), 1u);
    ASSERT_LE(steps.size(), 2u);
    EXPECT_EQ(steps[0].alpha, 0.99);
    EXPECT_EQ(steps[0].power, 0);
    const Image image = render_truth(scene, camera_of(33, 33), options);
    EXPECT_EQ(image.blended[16 * 33 + 16], steps.size());
    EXPECT_GE(image.transmittance[16 * 33 + 16], kMinTransmittance);
  }
}

TEST(Truth, BlendsByDepthThenIndexOrByRank) {
  Scene scene;
  add_ball(scene, {0, 0, 3}, 0.1, 0, {1, 0, 0});
  add_ball(scene, {0, 0, 2}, 0.1, 0, {0, 1, 0});
  add_ball(scene, {0, 0, 3}, 0.1, 0, {0, 0, 1});
  const Camera camera = camera_of(9, 9);
  const auto order = [&](const TruthOptions& options) {
    std::vector<std::uint32_t> out;
    for (const TruthStep& step : explain_truth(scene, camera, options, 4, 4)) out.push_back(step.index);
    return out;
  };
  EXPECT_EQ(order({}), (std::vector<std::uint32_t>{1, 0, 2}));
  TruthOptions ranked;
  std::vector<std::uint32_t> rank = {5, 9, 0};
  ranked.rank = &rank;
  EXPECT_EQ(order(ranked), (std::vector<std::uint32_t>{2, 0, 1}));
  rank = {1, 1, 1};
  EXPECT_EQ(order(ranked), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_NEAR(render_truth(scene, camera, ranked).rgb[40].y, 0.25, 1e-7);
  rank.pop_back();
  EXPECT_THROW(order(ranked), std::invalid_argument);
}

TEST(Truth, WindowIsTheCropOfTheWholePicture) {
  const Scene scene = generate_scene(5, 4000);
  Camera camera = generated_cameras()[0];
  camera.width = 203;
  camera.height = 155;
  camera.fx = camera.fy = 180;
  camera.cx = 101;
  camera.cy = 77;
  for (const Semantics semantics : {Semantics::kExact, Semantics::kInria, Semantics::kGsplat}) {
    TruthOptions options;
    options.semantics = semantics;
    const Image whole = render_truth(scene, camera, options);
    options.clip_window = true;
    options.x0 = 37;
    options.y0 = 50;
    options.x1 = 90;
    options.y1 = 155;
    options.threads = 1;
    const Image part = render_truth(scene, camera, options);
    ASSERT_EQ(part.width, 53);
    ASSERT_EQ(part.height, 105);
    for (int y = 0; y < part.height; ++y) {
      for (int x = 0; x < part.width; ++x) {
        const std::size_t a = part.at(x, y), b = whole.at(x + 37, y + 50);
        ASSERT_EQ(part.rgb[a], whole.rgb[b]);
        ASSERT_EQ(part.transmittance[a], whole.transmittance[b]);
        ASSERT_EQ(part.blended[a], whole.blended[b]);
      }
    }
  }
  TruthOptions outside;
  outside.clip_window = true;
  outside.x1 = 204;
  outside.y1 = 5;
  EXPECT_THROW(render_truth(scene, camera, outside), std::invalid_argument);
}

// Each Gaussian is told the largest weight that it has at a pixel; the picture is the same.
TEST(Truth, TheLargestWeightIsThatOfSomePixelAndChangesNoPicture) {
  const Scene scene = generate_scene(5, 4000);
  Camera camera = generated_cameras()[0];
  camera.width = 40, camera.height = 30;
  camera.fx = camera.fy = 35;
  camera.cx = 19.5, camera.cy = 14.5;
  const Image plain = render_truth(scene, camera, {});
  std::vector<float> largest(scene.gaussians.size()), wanted(scene.gaussians.size());
  TruthOptions options;
  options.largest_weight = &largest;
  const Image image = render_truth(scene, camera, options);
  EXPECT_EQ(image.rgb, plain.rgb);
  EXPECT_EQ(image.transmittance, plain.transmittance);
  EXPECT_EQ(image.blended, plain.blended);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      for (const TruthStep& step : explain_truth(scene, camera, {}, x, y))
        wanted[step.index] = std::max(wanted[step.index], static_cast<float>(step.weight));
    }
  }
  EXPECT_EQ(largest, wanted);
  largest[0] = 2;  // raised, never lowered
  render_truth(scene, camera, options);
  EXPECT_EQ(largest[0], 2);
  for (const std::size_t length : {scene.gaussians.size() - 1, scene.gaussians.size() + 1, std::size_t{0}}) {
    largest.resize(length);
    EXPECT_THROW(render_truth(scene, camera, options), std::invalid_argument) << length;
  }
}

TEST(Truth, ExplainAddsUpToThePixelAndThreadsDoNotMatter) {
  const Scene scene = generate_scene(6, 4000);
  Camera camera = generated_cameras()[1];
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 140;
  camera.cx = 79.5;
  camera.cy = 59.5;
  TruthOptions options;
  options.threads = 1;
  const Image one = render_truth(scene, camera, options);
  options.threads = 3;
  double last = 0;
  options.progress = [&](double share) {
    EXPECT_GT(share, last);
    last = share;
  };
  const Image three = render_truth(scene, camera, options);
  EXPECT_EQ(last, 1);
  EXPECT_EQ(one.rgb, three.rgb);
  for (int py = 3; py < 120; py += 29) {
    for (int px = 1; px < 160; px += 31) {
      double transmittance = 1, weights = 0;
      const auto steps = explain_truth(scene, camera, options, px, py);
      for (const TruthStep& step : steps) {
        EXPECT_EQ(step.transmittance_before, transmittance);
        EXPECT_LE(step.power, 0);
        weights += step.weight;
        transmittance *= 1 - step.alpha;
      }
      EXPECT_EQ(transmittance, one.transmittance[one.at(px, py)]);
      EXPECT_EQ(steps.size(), one.blended[one.at(px, py)]);
      EXPECT_NEAR(weights, 1 - transmittance, 1e-12);
    }
  }
}

TEST(Truth, RendersTheSmallestImageAndTheEmptyScene) {
  Scene scene;
  const Image empty = render_truth(scene, camera_of(1, 1), {});
  EXPECT_EQ(empty.transmittance, std::vector<double>{1});
  add_ball(scene, {0, 0, 1}, 0.5, 0, {0.8, 0.6, 0.4});
  const Image image = render_truth(scene, camera_of(1, 1), {});
  EXPECT_NEAR(image.rgb[0].x, 0.4, 1e-7);
  EXPECT_EQ(image.blended[0], 1u);
}

TEST(Truth, LeavesBadAndInvisibleGaussiansOut) {
  Scene scene;
  add_ball(scene, {0, 0, 1}, 0.5, 0, {1, 1, 1});
  const Camera camera = camera_of(20, 20);
  const Image wanted = render_truth(scene, camera, {});
  add_ball(scene, {0, 0, -1}, 0.5, 0, {1, 1, 1});      // behind
  add_ball(scene, {0, 0, 0}, 0.5, 0, {1, 1, 1});       // at the camera
  add_ball(scene, {0, 0, 0.2f}, 0.001, 0, {1, 1, 1});  // float(0.2) > 0.2, but the next is not
  scene.gaussians.back().mean.z = std::nextafter(0.2f, 0.0f);
  add_ball(scene, {0, 0, 1}, 0.5, -5.55f, {1, 1, 1});    // opacity below 1/255
  add_ball(scene, {0, 0, 1}, 0.5, -kOpaque, {1, 1, 1});  // opacity 0
  add_ball(scene, {std::nanf(""), 0, 1}, 0.5, 0, {1, 1, 1});
  add_ball(scene, {0, 0, 1}, 1e300, 0, {1, 1, 1});  // a scale beyond float
  add_ball(scene, {0, 0, 0.9f}, 0.5, 0, {1, 1, 1});
  scene.gaussians.back().rotation = glm::vec4(0);
  add_ball(scene, {3e38f, 0, 1}, 0.5, 0, {1, 1, 1});  // far off the image
  for (const Semantics semantics : {Semantics::kExact, Semantics::kInria, Semantics::kGsplat}) {
    TruthOptions options;
    options.semantics = semantics;
    const Image found = render_truth(scene, camera, options);
    EXPECT_EQ(found.blended, wanted.blended);
    EXPECT_LT(max_abs_error(found, wanted), 1e-5);
  }
}

TEST(Truth, SurvivesTheLargestSplats) {
  Scene scene;
  add_ball(scene, {0, 0, 0.21f}, 3e38, 5, {0.5, 0.5, 0.5});
  add_ball(scene, {1e38f, -1e38f, 1e38f}, 1e38, 5, {0.5, 0.5, 0.5});
  for (const double focal : {1.0, 1e6}) {
    const Image image = render_truth(scene, camera_of(40, 30, focal), {});
    for (const glm::dvec3& rgb : image.rgb) EXPECT_TRUE(std::isfinite(rgb.x));
  }
}

}  // namespace
}  // namespace pipegs
