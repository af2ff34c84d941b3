// SPDX-License-Identifier: Apache-2.0
// dopu_world.hpp: random cameras, scenes and nodes for the tests of the DOPU.
#pragma once

#include <cmath>
#include <random>

#include "cpp_model/frame_setup.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

// A cloud of random Gaussians around the origin, a few of them huge, some far away.
template <class Rng>
Scene random_scene(Rng& rng, size_t count, int sh_degree = 0) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Scene scene;
  scene.name = "random";
  scene.sh_degree = sh_degree;
  for (size_t i = 0; i < count; ++i) {
    Gaussian g;
    const double spread = rng() % 20 == 0 ? 20 : 2, size = rng() % 30 == 0 ? 0 : -4;
    g.mean = glm::vec3(normal(rng), normal(rng), normal(rng)) * static_cast<float>(spread);
    g.log_scale = glm::vec3(normal(rng), normal(rng), normal(rng)) + static_cast<float>(size);
    g.rotation = glm::vec4(normal(rng), normal(rng), normal(rng), normal(rng));
    g.opacity_logit = static_cast<float>(normal(rng) * 3);
    g.sh_dc = glm::vec3(normal(rng), normal(rng), normal(rng));
    scene.gaussians.push_back(g);
  }
  scene.sh_rest.resize(count * 3 * static_cast<size_t>(sh_rest_count(sh_degree)));
  for (float& value : scene.sh_rest) value = static_cast<float>(normal(rng) * std::exp(normal(rng) * 3));
  return scene;
}

// A camera in any attitude near the scene.
template <class Rng>
Camera random_camera(Rng& rng, int width, int height) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const glm::dvec3 position(normal(rng) * 3, normal(rng) * 3, normal(rng) * 3),
      target(normal(rng), normal(rng), normal(rng));
  Camera camera = look_at("random", 0, width, height, position, target, 30 + 80 * uniform(rng));
  camera.cx += normal(rng) * 20;
  camera.cy += normal(rng) * 20;
  return camera;
}

inline double camera_bound(const Camera& camera) {
  return std::max({std::abs(camera.position.x), std::abs(camera.position.y), std::abs(camera.position.z)});
}

}  // namespace pipegs
