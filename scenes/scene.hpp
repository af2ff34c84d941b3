// SPDX-License-Identifier: Apache-2.0
// scene: a trained set of 3D Gaussians as stored, and the activation that gives them meaning.
//
// Idea    A file stores what the optimiser trained; the renderer needs
//           scale = exp(log_scale)   opacity = 1 / (1 + exp(-logit))   rotation = q / |q|
//         all computed here in double, once, so that the golden model and the packer agree.
// Rule    A bad Gaussian never stops a frame: activate() says why it is culled, callers count.
//         Legal extremes: log_scale = -Inf (a flat splat), opacity_logit = +-Inf (1 and 0).
// Layout  sh_rest is coefficient-major, sh_rest[(i * K + k) * 3 + channel]; the INRIA file is
//         channel-major, ply.cpp transposes.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

namespace pipegs {

inline constexpr int kMaxShDegree = 3;

struct Gaussian {
  glm::vec3 mean;
  glm::vec3 log_scale;
  glm::vec4 rotation;  // w,x,y,z as in the file, not normalised
  float opacity_logit;
  glm::vec3 sh_dc;
};

struct Scene {
  std::string name;
  int sh_degree = 0;  // 0..3
  std::vector<Gaussian> gaussians;
  std::vector<float> sh_rest;  // per Gaussian 3*K floats, K = sh_rest_count(sh_degree)
  bool antialiased = false;    // trained with the opacity compensation of the mip variant
};

struct ActivatedGaussian {
  glm::dvec3 mean, scale;
  glm::dvec4 rotation;  // unit, w,x,y,z
  double opacity;
};

enum class Cull {
  kNone,            // the Gaussian takes part
  kNonFinite,       // NaN anywhere, an infinite mean or SH, a scale beyond float's range
  kZeroQuaternion,  // the rotation has no direction
};

// SH coefficients per channel beyond the constant one: 0, 3, 8, 15.
constexpr int sh_rest_count(int sh_degree) { return (sh_degree + 1) * (sh_degree + 1) - 1; }

// The coefficients of Gaussian i beyond the constant one (null for degree 0).
inline const float* sh_rest_of(const Scene& scene, std::size_t i) {
  return scene.sh_degree == 0 ? nullptr
                              : scene.sh_rest.data() + i * 3 * static_cast<std::size_t>(sh_rest_count(scene.sh_degree));
}

// A double of a file as a float: beyond float's range it becomes an infinity (and the Gaussian is culled later); the
// conversion itself would be undefined behaviour.
inline float narrow(double value) {
  if (std::abs(value) > std::numeric_limits<float>::max() && std::isfinite(value)) {
    return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(std::copysign(1.0, value)));
  }
  return static_cast<float>(value);
}

// Throws std::invalid_argument if the degree and the lengths of the arrays contradict each other.
void check_consistent(const Scene& scene);

Cull activate(const Scene& scene, std::size_t i, ActivatedGaussian& out);
// The same of one Gaussian alone; sh_rest holds `rest` floats.
Cull activate(const Gaussian& gaussian, const float* sh_rest, int rest, ActivatedGaussian& out);

}  // namespace pipegs
