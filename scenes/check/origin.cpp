// SPDX-License-Identifier: Apache-2.0
// origin: see origin.hpp.
#include "scenes/check/origin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/percentile.hpp"

namespace pipegs {
namespace {

constexpr double kStep = 1e-3, kFarthest = 1e12;  // beyond that it is no place

}  // namespace

double float_step(double at) { return at > 0 && std::isfinite(at) ? std::ldexp(1.0, std::ilogb(at) - 23) : 0; }

void set_positions(const std::vector<glm::dvec3>& positions, Scene& scene, SceneFormat& format) {
  std::vector<double> axes[3], scales;
  double farthest = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3& p = positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
    for (int k = 0; k < 3; ++k) axes[k].push_back(p[k]), farthest = std::max(farthest, std::abs(p[k]));
    const glm::vec3& s = scene.gaussians[i].log_scale;
    const double largest = std::exp(double{std::max({s.x, s.y, s.z})});
    if (std::isfinite(largest)) scales.push_back(largest);
  }
  glm::dvec3 middle(0);
  for (int k = 0; k < 3; ++k) middle[k] = axes[k].empty() ? 0 : std::round(percentile(std::move(axes[k]), 0.5));
  const double away = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
  const bool far = !scales.empty() && away < kFarthest && float_step(away) > kStep * percentile(std::move(scales), 0.5);
  if (far) {
    format.findings.emplace_back(
        "origin", fmt::format("positions lie up to {:.4g} from the origin, where steps of float32 are {:.2g}: {:.12g}, "
                              "{:.12g}, {:.12g} is subtracted from them and from the cameras",
                              farthest, float_step(away), middle.x, middle.y, middle.z));
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 p = far ? positions[i] - middle : positions[i];
    scene.gaussians[i].mean = {narrow(p.x), narrow(p.y), narrow(p.z)};
  }
  if (far) format.origin += middle;
}

}  // namespace pipegs
