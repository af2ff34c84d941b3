// SPDX-License-Identifier: Apache-2.0
// around: see around.hpp.
#include "scenes/cameras/around.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "scenes/generate/generate_random.hpp"

namespace pipegs {
namespace {

using generate::Random;

constexpr double kMove = 0.1, kTurn = 8;  // of the way to the nearest view; degrees

// How far away the nearest view that stands elsewhere is; 0 if none does.
double nearest(const std::vector<Camera>& views, const Camera& from) {
  double least = std::numeric_limits<double>::infinity();
  for (const Camera& view : views) {
    const double away = glm::length(view.position - from.position);
    if (away > 0) least = std::min(least, away);
  }
  return std::isfinite(least) ? least : 0;
}

glm::dvec3 in_a_cube(Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
  return {x, y, z};
}

// About a direction drawn by chance.
glm::dmat3 small_turn(Random& random) {
  const double angle = glm::radians(random.uniform(0, kTurn));
  glm::dvec3 axis = in_a_cube(random);
  while (glm::dot(axis, axis) > 1 || glm::dot(axis, axis) < 1e-4) axis = in_a_cube(random);
  return glm::mat3_cast(glm::angleAxis(angle, glm::normalize(axis)));
}

}  // namespace

std::vector<Camera> cameras_around(const std::vector<Camera>& views, int each, std::uint64_t seed) {
  Random random(seed);
  std::vector<Camera> all;
  for (const Camera& view : views) {
    const double reach = kMove * nearest(views, view);
    all.push_back(view);
    for (int i = 1; i <= each; ++i) {
      Camera& camera = all.emplace_back(view);
      camera.position += reach * in_a_cube(random);
      camera.world_to_camera = small_turn(random) * view.world_to_camera;
      camera.name = fmt::format("around_{}_{}", view.name, i);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].id = static_cast<int>(i);
  return all;
}

}  // namespace pipegs
