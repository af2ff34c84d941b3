// SPDX-License-Identifier: Apache-2.0
// path: see path.hpp.
#include "scenes/cameras/path.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <fmt/format.h>

#include <algorithm>
#include <glm/gtx/quaternion.hpp>
#include <glm/gtx/spline.hpp>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

// The quaternions of the keys, each turned from the one before by the shorter way.
std::vector<glm::dquat> rotations_of(const std::vector<Camera>& keys) {
  std::vector<glm::dquat> rotations;
  for (const Camera& key : keys) {
    const glm::dquat q = glm::quat_cast(key.world_to_camera);
    rotations.push_back(!rotations.empty() && glm::dot(rotations.back(), q) < 0 ? -q : q);
  }
  return rotations;
}

template <typename Value>
Value on_spline(const std::vector<Camera>& keys, std::size_t leg, double at, Value (*value)(const Camera&)) {
  const Value from = value(keys[leg]), to = value(keys[leg + 1]);
  const Value before = leg > 0 ? value(keys[leg - 1]) : from + from - to;
  const Value behind = leg + 2 < keys.size() ? value(keys[leg + 2]) : to + to - from;
  return glm::catmullRom(before, from, to, behind, at);
}

// What bends the way at a key; a key at an end bends none.
glm::dquat bend(const std::vector<glm::dquat>& rotations, std::size_t key) {
  if (key == 0 || key + 1 == rotations.size()) return rotations[key];
  return glm::intermediate(rotations[key - 1], rotations[key], rotations[key + 1]);
}

}  // namespace

std::vector<Camera> camera_path(const std::vector<Camera>& keys, int frames) {
  if (keys.size() < 2)
    throw InputError("--path", "", fmt::format("found {} view, expected two or more for a path", keys.size()));
  for (const Camera& key : keys) {
    if (key.width != keys[0].width || key.height != keys[0].height)
      throw InputError("--path", "",
                       fmt::format("found views of {}x{} and {}x{} pixels, expected one size for a path", keys[0].width,
                                   keys[0].height, key.width, key.height));
  }
  const std::vector<glm::dquat> rotations = rotations_of(keys);
  const auto legs = static_cast<int>(keys.size()) - 1, steps = std::max(frames - 1, 1);
  std::vector<Camera> path;
  for (int frame = 0; frame < frames; ++frame) {
    const int64_t place = static_cast<int64_t>(frame) * legs;  // in steps of a leg, exact
    const auto leg = static_cast<std::size_t>(place / steps);
    Camera camera = keys[leg];
    if (place % steps != 0) {
      const double at = static_cast<double>(place % steps) / steps;
      camera.position = on_spline<glm::dvec3>(keys, leg, at, [](const Camera& key) { return key.position; });
      const auto center = on_spline<glm::dvec2>(keys, leg, at, [](const Camera& c) { return glm::dvec2(c.cx, c.cy); });
      const auto focal = glm::exp(
          on_spline<glm::dvec2>(keys, leg, at, [](const Camera& key) { return glm::log(glm::dvec2(key.fx, key.fy)); }));
      camera.cx = center.x, camera.cy = center.y, camera.fx = focal.x, camera.fy = focal.y;
      camera.world_to_camera = glm::mat3_cast(glm::normalize(
          glm::squad(rotations[leg], rotations[leg + 1], bend(rotations, leg), bend(rotations, leg + 1), at)));
    }
    camera.name = fmt::format("path_{}", frame);
    camera.id = frame;
    path.push_back(camera);
  }
  return path;
}

}  // namespace pipegs
