// SPDX-License-Identifier: Apache-2.0
// parameters: see parameters.hpp.
#include "sim/layers/parameters.hpp"

#include <stdexcept>

namespace pipegs {

Parameters parameters_of(const Scene& scene) {
  check_consistent(scene);
  if (scene.antialiased) throw std::invalid_argument("parameters: the scene is antialiased, which is not trained here");
  Parameters parameters;
  parameters.sh_degree = scene.sh_degree;
  for (const Gaussian& gaussian : scene.gaussians) {
    parameters.mean.push_back(gaussian.mean);
    parameters.log_scale.push_back(gaussian.log_scale);
    parameters.sh_dc.push_back(gaussian.sh_dc);
    parameters.rotation.push_back(gaussian.rotation);
    parameters.opacity_logit.push_back(gaussian.opacity_logit);
  }
  parameters.sh_rest = scene.sh_rest;
  return parameters;
}

Scene scene_of(const Parameters& parameters, const std::string& name) {
  check_consistent(parameters);
  Scene scene;
  scene.name = name;
  scene.sh_degree = parameters.sh_degree;
  scene.gaussians.reserve(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) scene.gaussians.push_back(gaussian_of(parameters, i));
  scene.sh_rest = parameters.sh_rest;
  return scene;
}

Gradient zero_gradient(const Parameters& parameters) {
  Gradient gradient;
  gradient.sh_degree = parameters.sh_degree;
  gradient.mean.resize(parameters.size(), glm::vec3(0));
  gradient.log_scale.resize(parameters.size(), glm::vec3(0));
  gradient.sh_dc.resize(parameters.size(), glm::vec3(0));
  gradient.rotation.resize(parameters.size(), glm::vec4(0));
  gradient.opacity_logit.resize(parameters.size());
  gradient.sh_rest.resize(parameters.sh_rest.size());
  return gradient;
}

void check_consistent(const Parameters& parameters) {
  const std::size_t count = parameters.size();
  if (parameters.sh_degree < 0 || parameters.sh_degree > kMaxShDegree) {
    throw std::invalid_argument("parameters: SH degree " + std::to_string(parameters.sh_degree) + " is not 0..3");
  }
  const auto rest = 3 * static_cast<std::size_t>(sh_rest_count(parameters.sh_degree));
  if (parameters.log_scale.size() != count || parameters.sh_dc.size() != count || parameters.rotation.size() != count ||
      parameters.opacity_logit.size() != count || parameters.sh_rest.size() != count * rest) {
    throw std::invalid_argument("parameters: the arrays are not those of " + std::to_string(count) + " Gaussians");
  }
}

void check_same_shape(const Parameters& parameters, const Gradient& gradient) {
  check_consistent(parameters);
  check_consistent(gradient);
  if (parameters.size() != gradient.size() || parameters.sh_degree != gradient.sh_degree) {
    throw std::invalid_argument("gradient: " + std::to_string(gradient.size()) + " Gaussians of SH degree " +
                                std::to_string(gradient.sh_degree) + ", expected " + std::to_string(parameters.size()) +
                                " of degree " + std::to_string(parameters.sh_degree));
  }
}

Gaussian gaussian_of(const Parameters& parameters, std::size_t i) {
  return {parameters.mean[i], parameters.log_scale[i], parameters.rotation[i], parameters.opacity_logit[i],
          parameters.sh_dc[i]};
}

const float* sh_rest_of(const Parameters& parameters, std::size_t i) {
  const auto rest = 3 * static_cast<std::size_t>(sh_rest_count(parameters.sh_degree));
  return rest == 0 ? nullptr : parameters.sh_rest.data() + i * rest;
}

Cull activate(const Parameters& parameters, std::size_t i, ActivatedGaussian& out) {
  return activate(gaussian_of(parameters, i), sh_rest_of(parameters, i), 3 * sh_rest_count(parameters.sh_degree), out);
}

}  // namespace pipegs
