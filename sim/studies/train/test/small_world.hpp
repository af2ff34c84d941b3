// SPDX-License-Identifier: Apache-2.0
// small_world: 200 Gaussians in a ball and cameras round them, all that a test of training needs.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "scenes/generate/generate_random.hpp"
#include "scenes/scene.hpp"
#include "sim/studies/train/photos/view.hpp"
#include "sim/studies/train/run/trainer.hpp"
#include "sim/studies/train/start/start.hpp"

namespace pipegs {

inline Scene small_scene(std::size_t count = 200) {
  generate::Random random(11);
  Scene scene;
  scene.name = "small";
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 place;
    do {
      place.x = random.uniform(-1, 1), place.y = random.uniform(-1, 1), place.z = random.uniform(-1, 1);
    } while (glm::length(place) > 1);
    Gaussian gaussian{};
    gaussian.mean = place;
    gaussian.rotation = glm::dvec4(random.normal(), random.normals());
    const glm::dvec3 stretch = random.normals();
    gaussian.log_scale = std::log(0.09) + 0.3 * stretch;
    gaussian.opacity_logit = static_cast<float>(random.uniform(-0.5, 2.5));
    gaussian.sh_dc = 0.8 * random.normals();
    scene.gaussians.push_back(gaussian);
  }
  return scene;
}

// The same with every field of every Gaussian changed by chance.
inline Scene knocked(Scene scene, double by) {
  generate::Random random(3);
  for (Gaussian& gaussian : scene.gaussians) {
    gaussian.mean += glm::vec3(0.1 * by * random.normals());
    gaussian.log_scale += glm::vec3(by * random.normals());
    gaussian.sh_dc += glm::vec3(by * random.normals());
    gaussian.opacity_logit += static_cast<float>(by * random.normal());
    gaussian.rotation += glm::vec4(0, by * random.normals());
  }
  return scene;
}

// Two rings of cameras that look at the middle; their names are in their order.
inline std::vector<Camera> small_cameras(int count, int width = 64, int height = 48) {
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    const double turn = 0.6 + 6.28318530717958648 * i / count * 2;
    const double above = i % 2 == 0 ? -1.2 : 0.9;
    cameras.push_back(look_at("view" + std::to_string(100 + i), i, width, height,
                              {3.2 * std::sin(turn), above, -3.2 * std::cos(turn)}, {0, 0, 0}, 45));
  }
  return cameras;
}

// Points near its Gaussians, of their colour: what a reconstruction would know of it.
inline std::vector<ScenePoint> small_points(const Scene& scene) {
  generate::Random random(12);
  std::vector<ScenePoint> points;
  for (const Gaussian& gaussian : scene.gaussians) {
    const glm::dvec3 color = glm::clamp(0.5 + 0.28209479 * glm::dvec3(gaussian.sh_dc), 0.0, 1.0);
    points.push_back({glm::dvec3(gaussian.mean) + 0.01 * random.normals(), glm::u8vec3(color * 255.0)});
  }
  return points;
}

}  // namespace pipegs
