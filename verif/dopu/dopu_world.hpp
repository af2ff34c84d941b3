// SPDX-License-Identifier: Apache-2.0
// dopu_world.hpp: random cameras, scenes and nodes for the tests of the DOPU.
#pragma once

#include <array>
#include <cmath>
#include <random>

#include "cpp_model/frame_setup.hpp"
#include "cpp_model/pack/pack.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {

// A cloud of random Gaussians around the origin, a few of them huge, some far away.
template <class Rng>
Scene random_scene(Rng& rng, size_t count, int sh_degree = 0) {
  Scene scene;
  scene.name = "random";
  scene.sh_degree = sh_degree;
  for (size_t i = 0; i < count; ++i) {
    Gaussian g;
    const double spread = rng() % 20 == 0 ? 20 : 2, size = rng() % 30 == 0 ? 0 : -4;
    g.mean = glm::vec3(draw_normals(rng) * spread);
    g.log_scale = glm::vec3(draw_normals(rng) + size);
    g.rotation = glm::vec4(glm::dvec4{draw_normal(rng), draw_normal(rng), draw_normal(rng), draw_normal(rng)});
    g.opacity_logit = static_cast<float>(draw_normal(rng) * 3);
    g.sh_dc = glm::vec3(draw_normals(rng));
    scene.gaussians.push_back(g);
  }
  scene.sh_rest.resize(count * 3 * static_cast<size_t>(sh_rest_count(sh_degree)));
  for (float& value : scene.sh_rest) {
    const double size = std::exp(draw_normal(rng) * 3);
    value = static_cast<float>(size * draw_normal(rng));
  }
  return scene;
}

// A camera in any attitude near the scene.
template <class Rng>
Camera random_camera(Rng& rng, int width, int height) {
  const glm::dvec3 position = draw_normals(rng) * 3.0, target = draw_normals(rng);
  Camera camera = look_at("random", 0, width, height, position, target, 30 + 80 * draw_unit(rng));
  camera.cx += draw_normal(rng) * 20;
  camera.cy += draw_normal(rng) * 20;
  return camera;
}

// With two eyes: of one place, near each other, or as far apart as the scene is wide.
inline void spread_eyes(const Config& config, const PackedScene& packed, Frame& frame) {
  if (config.eyes == 1) return;
  std::mt19937_64 rng(static_cast<uint64_t>(frame.camera.position.x ^ frame.camera.position.z));
  const double apart = std::array{0.0, 0.03, 0.5, 4.0}[rng() % 4];
  frame_eyes(config, packed, {apart * draw_normal(rng), apart / 3 * draw_normal(rng)}, frame);
  frame.raster.eyes = std::array<uint64_t, 4>{3, 3, 1, 2}[rng() % 4];
}

inline double camera_bound(const Camera& camera) {
  return std::max({std::abs(camera.position.x), std::abs(camera.position.y), std::abs(camera.position.z)});
}

}  // namespace pipegs
