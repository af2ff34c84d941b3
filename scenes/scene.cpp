// SPDX-License-Identifier: Apache-2.0
// scene: activation of stored Gaussians, in double; see scene.hpp.
//
// Idea    Every test is written so that NaN fails it: a NaN is never compared as "in range".
//         Scales are bounded by float's range and not by double's: INRIA activates in float, so a
//         log_scale above 88.7 is an infinite scale there (graphdeco-inria/gaussian-splatting#781).
#include "scenes/scene.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pipegs {

void check_consistent(const Scene& scene) {
  if (scene.sh_degree < 0 || scene.sh_degree > kMaxShDegree) {
    throw std::invalid_argument("scene: SH degree " + std::to_string(scene.sh_degree) + " is not 0..3");
  }
  const std::size_t wanted = scene.gaussians.size() * 3 * static_cast<std::size_t>(sh_rest_count(scene.sh_degree));
  if (scene.sh_rest.size() != wanted) {
    throw std::invalid_argument("scene: sh_rest holds " + std::to_string(scene.sh_rest.size()) + " floats, expected " +
                                std::to_string(wanted));
  }
}

Cull activate(const Scene& scene, std::size_t i, ActivatedGaussian& out) {
  return activate(scene.gaussians[i], sh_rest_of(scene, i), 3 * sh_rest_count(scene.sh_degree), out);
}

Cull activate(const Gaussian& g, const float* sh_rest, int rest, ActivatedGaussian& out) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(g.mean[axis]) || !std::isfinite(g.sh_dc[axis])) return Cull::kNonFinite;
    out.mean[axis] = g.mean[axis];
    out.scale[axis] = std::exp(static_cast<double>(g.log_scale[axis]));
    if (!(out.scale[axis] <= std::numeric_limits<float>::max())) return Cull::kNonFinite;
  }
  if (std::isnan(g.opacity_logit)) return Cull::kNonFinite;
  for (int k = 0; k < rest; ++k) {
    if (!std::isfinite(sh_rest[k])) return Cull::kNonFinite;
  }
  double norm2 = 0;
  for (int k = 0; k < 4; ++k) {
    out.rotation[k] = g.rotation[k];
    norm2 += out.rotation[k] * out.rotation[k];  // floats squared fit a double, 1e-45 to 1e38
  }
  if (!std::isfinite(norm2)) return Cull::kNonFinite;
  if (norm2 == 0) return Cull::kZeroQuaternion;
  out.rotation /= std::sqrt(norm2);
  out.opacity = 1 / (1 + std::exp(-static_cast<double>(g.opacity_logit)));
  return Cull::kNone;
}

}  // namespace pipegs
