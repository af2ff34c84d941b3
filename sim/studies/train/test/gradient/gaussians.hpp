// SPDX-License-Identifier: Apache-2.0
// gaussians: small scenes and cameras for the tests of drawing and its losses.
//
// Idea    All stored numbers are multiples of kStep: then one is moved by kStep and by twice as much to both sides
//         without rounding, and a central difference of fourth order is that of exactly the points that were asked.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "scenes/camera.hpp"
#include "sim/layers/parameters.hpp"

namespace pipegs {

inline constexpr float kStep = 1.0f / 16384;

// d / d value of what `at(n)` says with the value moved by n steps, n = -2, -1, 1, 2.
template <class Function>
double central_difference(float& value, Function&& at) {
  const float kept = value;
  const auto moved = [&](int steps) {
    value = kept + static_cast<float>(steps) * kStep;
    return at(steps);
  };
  const double near = moved(1) - moved(-1), far = moved(2) - moved(-2);
  value = kept;
  return (8 * near - far) / (12.0 * kStep);
}

inline float on_grid(double value) { return static_cast<float>(std::round(value / kStep)) * kStep; }
inline glm::vec3 on_grid(const glm::dvec3& v) { return {on_grid(v.x), on_grid(v.y), on_grid(v.z)}; }

inline Camera small_camera(int width, int height, double focal) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.fx = focal;
  camera.fy = 1.1 * focal;
  camera.cx = (width - 1) / 2.0 + 0.3;
  camera.cy = (height - 1) / 2.0 - 0.2;
  return camera;
}

// One that looks askance, so that no axis is special.
inline Camera askance_camera(int width, int height) {
  return look_at("askance", 0, width, height, {2.1, -1.3, -3.2}, {0.1, 0.2, 0.3}, 50);
}

inline void add_gaussian(Parameters& p, const glm::dvec3& mean, const glm::dvec3& scale, const glm::dvec4& rotation,
                         double logit, const glm::dvec3& color) {
  p.mean.push_back(on_grid(mean));
  p.log_scale.push_back(on_grid(glm::log(scale)));
  p.rotation.push_back({on_grid(rotation[0]), on_grid(rotation[1]), on_grid(rotation[2]), on_grid(rotation[3])});
  p.opacity_logit.push_back(on_grid(logit));
  p.sh_dc.push_back(on_grid((color - 0.5) / 0.28209479177387814));
  p.sh_rest.resize(p.size() * 3 * static_cast<std::size_t>(sh_rest_count(p.sh_degree)), 0);
}

// `count` Gaussians of every shape round the origin.
inline Parameters random_gaussians(unsigned seed, std::size_t count, int sh_degree) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const auto point = [&](double low, double high) {
    return glm::dvec3(uniform(low, high), uniform(low, high), uniform(low, high));
  };
  Parameters p;
  p.sh_degree = sh_degree;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec4 rotation(uniform(0.2, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    add_gaussian(p, point(-1, 1), glm::exp(point(-3.5, -1)), rotation, uniform(-3, 2.5), point(0.2, 0.9));
    const std::size_t rest = 3 * static_cast<std::size_t>(sh_rest_count(sh_degree));
    for (std::size_t k = 0; k < rest; ++k) p.sh_rest[i * rest + k] = on_grid(uniform(-0.15, 0.15));
  }
  return p;
}

}  // namespace pipegs
