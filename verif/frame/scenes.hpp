// SPDX-License-Identifier: Apache-2.0
// scenes.hpp: small scenes for whole-frame tests, made of random numbers or by hand.
#pragma once

#include <cmath>
#include <random>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

// A camera at the origin that looks along +z.
inline Camera test_camera(int width, int height, double focal = 100) {
  Camera camera;
  camera.name = "test";
  camera.id = 0;
  camera.width = width, camera.height = height;
  camera.position = glm::dvec3(0);
  camera.world_to_camera = glm::dmat3(1);
  camera.fx = camera.fy = focal;
  camera.cx = (width - 1) / 2.0, camera.cy = (height - 1) / 2.0;
  return camera;
}

inline float logit(double opacity) { return static_cast<float>(std::log(opacity / (1 - opacity))); }

inline Gaussian gaussian_at(glm::vec3 mean, float scale = 0.05f, double opacity = 0.8,
                            glm::vec3 color = {0.5f, 0.2f, -0.3f}) {
  return {.mean = mean,
          .log_scale = glm::vec3(std::log(scale)),
          .rotation = {1, 0, 0, 0},
          .opacity_logit = logit(opacity),
          .sh_dc = color};
}

inline Scene scene_of(std::vector<Gaussian> gaussians) {
  Scene scene;
  scene.name = "test";
  scene.sh_degree = 0;
  scene.gaussians = std::move(gaussians);
  return scene;
}

// A cloud in front of the camera: log-normal scales, needles, any rotation, many faint Gaussians, SH of the given
// degree.
inline Scene random_scene(uint64_t seed, size_t count, int sh_degree) {
  std::mt19937_64 rng(seed);
  const auto uniform = [&](double low, double high) {
    return static_cast<float>(low + (high - low) * static_cast<double>(rng() >> 11) * 0x1p-53);
  };
  Scene scene = scene_of({});
  scene.sh_degree = sh_degree;
  const int coefficients = (sh_degree + 1) * (sh_degree + 1) - 1;
  for (size_t i = 0; i < count; ++i) {
    const float z = std::exp(uniform(-1.0, 3.0));
    Gaussian gaussian;
    gaussian.mean = {z * uniform(-1.1, 1.1), z * uniform(-1.1, 1.1), uniform(0, 1) < 0.05f ? -z : z};
    const float size = std::log(z) + uniform(-6.5, -2);
    gaussian.log_scale = {size + uniform(-3, 0), size + uniform(-1, 0), size};
    gaussian.rotation = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    gaussian.opacity_logit = uniform(-5, 4);
    gaussian.sh_dc = {uniform(-1.5, 2), uniform(-1.5, 2), uniform(-1.5, 2)};
    scene.gaussians.push_back(gaussian);
    for (int k = 0; k < 3 * coefficients; ++k) scene.sh_rest.push_back(uniform(-0.3, 0.3));
  }
  return scene;
}

}  // namespace pipegs
