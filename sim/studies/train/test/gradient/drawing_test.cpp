// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/gradient/drawing: the picture is the truth's, and no bit depends on the number of threads.
#include "sim/studies/train/gradient/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "cpp_model/float/truth.hpp"
#include "scenes/generate/generate.hpp"
#include "sim/studies/train/gradient/raster/lanes.hpp"
#include "sim/studies/train/test/gradient/gaussians.hpp"

namespace pipegs {
namespace {

Camera shrunk(Camera camera, int width) {
  const double factor = static_cast<double>(width) / camera.width;
  camera.fx *= factor;
  camera.fy *= factor;
  camera.cx = (camera.cx + 0.5) * factor - 0.5;
  camera.cy = (camera.cy + 0.5) * factor - 0.5;
  camera.height = static_cast<int>(camera.height * factor);
  camera.width = width;
  return camera;
}

// How many values of two pictures differ by more than `tolerance`.
template <class Scalar>
std::size_t differing(const Image& truth, const BasicDrawing<Scalar>& drawing, const glm::dvec3& background,
                      double tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < truth.rgb.size(); ++i) {
    const glm::dvec3 wanted = truth.rgb[i] + truth.transmittance[i] * background;
    for (int c = 0; c < 3; ++c) count += !(std::abs(wanted[c] - drawing.picture()[i][c]) <= tolerance);
  }
  return count;
}

TEST(Drawing, OneBallHasThePictureAndTheGradientComputedByHand) {
  // Straight ahead at depth 2 with f = 100: cov2d = (100 s / 2)^2 + 0.3 on both axes. The loss is pixel (33, 31), two
  // columns beside the mean, of red alone.
  Parameters p;
  add_gaussian(p, {0, 0, 2}, glm::dvec3(0.1), {1, 0, 0, 0}, 1.5, {0.9, 0.4, 0.1});
  Camera camera;
  camera.width = camera.height = 63;
  camera.fx = camera.fy = 100;
  camera.cx = camera.cy = 31;
  const BasicDrawing<double> drawing(p, camera, {.background = {0.25f, 0, 1}});
  const double s = std::exp(static_cast<double>(p.log_scale[0].x)), stretched = std::pow(50 * s, 2);
  const double v = stretched + 0.3, opacity = 1 / (1 + std::exp(-1.5)), alpha = opacity * std::exp(-2 / v);
  const double red = 0.28209479177387814 * p.sh_dc[0].x + 0.5;
  const std::size_t pixel = 31 * 63 + 33;
  EXPECT_NEAR(drawing.picture()[pixel].x, alpha * red + (1 - alpha) * 0.25, 1e-12);
  EXPECT_NEAR(drawing.picture()[0].z, 1, 1e-12);  // background

  std::vector<glm::dvec3> d_picture(drawing.picture().size(), glm::dvec3(0));
  d_picture[pixel].x = 1;
  Gradient gradient = zero_gradient(p);
  Seen seen;
  drawing.backward(d_picture, gradient, &seen);
  const double by_alpha = red - 0.25;
  EXPECT_NEAR(gradient.sh_dc[0].x, 0.28209479177387814 * alpha, 1e-8);
  EXPECT_EQ(gradient.sh_dc[0].y, 0);
  EXPECT_NEAR(gradient.opacity_logit[0], by_alpha * alpha * (1 - opacity), 1e-8);
  // power = -dx^2 / (2 v) with dx = mean - pixel = -2: by the mean 2 / v, and the mean moves 50 pixels per unit.
  EXPECT_NEAR(gradient.mean[0].x, by_alpha * alpha * 2 / v * 50, 1e-6);
  EXPECT_NEAR(gradient.mean[0].y, 0, 1e-9);
  // Farther away it is smaller: v has stretched ~ 1/z^2, so d power / dz = 2 / v^2 * d v/dz = -2 / v^2 * stretched.
  EXPECT_NEAR(gradient.mean[0].z, -by_alpha * alpha * 2 / (v * v) * stretched, 1e-6);
  // d v / d log s = 2 stretched, of the axis along the row alone.
  EXPECT_NEAR(gradient.log_scale[0].x, by_alpha * alpha * 2 / (v * v) * 2 * stretched, 1e-6);
  EXPECT_NEAR(gradient.log_scale[0].y, 0, 1e-9);
  EXPECT_NEAR(glm::length(gradient.rotation[0]), 0, 1e-9);  // a ball
  EXPECT_NEAR(seen.mean_gradient[0], by_alpha * alpha * 2 / v * 63 / 2, 1e-6);
  EXPECT_EQ(seen.radius[0], std::ceil(3 * std::sqrt(v + std::sqrt(0.1))));  // INRIA's, whose root is at least of 0.1
}

TEST(Drawing, EqualsTheTruthInDoubleAndNearlyInFloat) {
  const Scene scene = generate_scene(7, 8000);
  const Parameters p = parameters_of(scene);
  const Camera camera = shrunk(generated_cameras()[0], 203);  // not a multiple of 16
  const glm::vec3 background(0.2f, 0.5f, 0.9f);
  for (const int degree : {0, 2, 3}) {
    TruthOptions options;
    options.sh_degree = degree;
    const Image truth = render_truth(scene, camera, options);
    const DrawOptions draw{.sh_degree = degree, .background = background};
    EXPECT_EQ(differing(truth, BasicDrawing<double>(p, camera, draw), background, 1e-9), 0u);
    // In float a Gaussian may fall to the other side of a cut, which is worth 1/255 at most where T is high.
    const Drawing drawing(p, camera, draw);
    EXPECT_LE(differing(truth, drawing, background, 2e-5), truth.rgb.size() / 2000);
    EXPECT_EQ(differing(truth, drawing, background, 1.0 / 255), 0u);
  }
}

TEST(Drawing, NoBitDependsOnTheNumberOfThreads) {
  const Parameters p = parameters_of(generate_scene(3, 8000));
  const Camera camera = shrunk(generated_cameras()[1], 200);
  const LayerGrid grid = layer_grid(p, 4);
  const auto run = [&](unsigned threads, Gradient& gradient, Seen& seen) {
    const Drawing drawing(p, camera, {.layers = &grid, .threads = threads});
    std::vector<glm::vec3> d_picture;
    for (const glm::vec3& pixel : drawing.picture()) d_picture.push_back(pixel - glm::vec3(0.3f, 0.4f, 0.5f));
    drawing.backward(d_picture, gradient, &seen);
    return drawing.picture();
  };
  Gradient one = zero_gradient(p), many = zero_gradient(p);
  Seen seen_one, seen_many;
  EXPECT_EQ(run(1, one, seen_one), run(5, many, seen_many));
  EXPECT_TRUE(one == many);
  EXPECT_EQ(seen_one.mean_gradient, seen_many.mean_gradient);
  EXPECT_EQ(seen_one.radius, seen_many.radius);
}

TEST(Drawing, WhatCannotBeDrawnIsLeftOutAndHasNoGradient) {
  Parameters p = random_gaussians(1, 12, 1);
  const Camera camera = askance_camera(40, 30);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  p.mean[0].y = nan;
  p.rotation[1] = glm::vec4(0);
  p.log_scale[2].z = 100;
  p.sh_rest[3 * 9 + 4] = nan;
  p.opacity_logit[4] = nan;
  p.mean[5] = glm::vec3(camera.position);
  p.opacity_logit[6] = std::numeric_limits<float>::infinity();  // opaque, which is legal
  p.log_scale[7].x = -std::numeric_limits<float>::infinity();   // flat, which is legal
  const BasicDrawing<double> drawing(p, camera, {});
  EXPECT_EQ(differing(render_truth(scene_of(p, ""), camera, {}), drawing, glm::dvec3(0), 1e-9), 0u);
  Gradient gradient = zero_gradient(p);
  Seen seen;
  drawing.backward(std::vector<glm::dvec3>(40 * 30, glm::dvec3(1)), gradient, &seen);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(seen.radius[i], 0) << i;
    EXPECT_EQ(gradient.mean[i], glm::vec3(0)) << i;
    EXPECT_EQ(gradient.opacity_logit[i], 0) << i;
  }
  for (std::size_t i = 6; i < p.size(); ++i) {
    EXPECT_TRUE(std::isfinite(glm::dot(gradient.mean[i], gradient.mean[i]))) << i;
    EXPECT_TRUE(std::isfinite(glm::dot(gradient.log_scale[i], gradient.log_scale[i]))) << i;
    EXPECT_TRUE(std::isfinite(glm::dot(gradient.rotation[i], gradient.rotation[i]))) << i;
  }
  EXPECT_GT(seen.radius[6], 0);
  EXPECT_EQ(gradient.opacity_logit[6], 0);
}

TEST(Drawing, RefusesWhatDoesNotFitTogether) {
  Parameters p = random_gaussians(1, 3, 1);
  const Camera camera = askance_camera(20, 20);
  const Drawing drawing(p, camera, {});
  Gradient gradient = zero_gradient(p), other = zero_gradient(random_gaussians(1, 4, 1));
  EXPECT_THROW(drawing.backward(std::vector<glm::vec3>(399), gradient, nullptr), std::invalid_argument);
  EXPECT_THROW(drawing.backward(std::vector<glm::vec3>(400), other, nullptr), std::invalid_argument);
  EXPECT_THROW(Drawing(p, Camera{}, {}), std::invalid_argument);
  p.sh_rest.pop_back();
  EXPECT_THROW(Drawing(p, camera, {}), std::invalid_argument);
  Scene scene;
  scene.antialiased = true;
  EXPECT_THROW(parameters_of(scene), std::invalid_argument);
}

TEST(Drawing, AnEmptySceneIsItsBackground) {
  const Drawing drawing(Parameters{}, askance_camera(17, 5), {.background = {0.5f, 0.25f, 0}});
  for (const glm::vec3& pixel : drawing.picture()) EXPECT_EQ(pixel, glm::vec3(0.5f, 0.25f, 0));
  Gradient gradient;
  drawing.backward(std::vector<glm::vec3>(17 * 5, glm::vec3(1)), gradient, nullptr);
}

TEST(Lanes, Exp2IsWithinThreeTenMillionths) {
  double worst = 0;
  for (int begin = -8 * 4096; begin < 0; begin += 16) {
    Lanes<float> x;
    for (int i = 0; i < 16; ++i) x[i] = static_cast<float>(begin + i) / 4096 + 1e-5f;
    const Lanes<float> asked = x;
    exp2_lanes<float>(x);
    for (int i = 0; i < 16; ++i) {
      const double wanted = std::exp2(static_cast<double>(asked[i]));
      worst = std::max(worst, std::abs(x[i] - wanted) / wanted);
    }
  }
  EXPECT_LT(worst, 3e-7);
  Lanes<float> low = Lanes<float>{} - 1e30f;
  exp2_lanes<float>(low);
  EXPECT_LT(low[3], 1e-30f);
  EXPECT_GE(low[3], 0);
}

}  // namespace
}  // namespace pipegs
