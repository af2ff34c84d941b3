// SPDX-License-Identifier: Apache-2.0
// parameters: what training changes: the fields of a scene as stored, one array each.
//
// Paper   Sec. 2.1: position, scale, rotation, SH coefficients and opacity of each Gaussian.
// Idea    A gradient has the same shape: d loss / d field. An optimiser walks arrays, so they lie apart.
// Rule    Values are those of the file: log scales, unnormalised quaternions (w, x, y, z), logits. What cannot be
//         drawn (scene.hpp, activate) is left out of a drawing and has no gradient.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace pipegs {

struct Parameters {
  int sh_degree = 0;
  std::vector<glm::vec3> mean, log_scale, sh_dc;
  std::vector<glm::vec4> rotation;
  std::vector<float> opacity_logit;
  std::vector<float> sh_rest;  // coefficient-major: [(i * K + k) * 3 + channel], K = sh_rest_count(sh_degree)
  std::size_t size() const { return mean.size(); }
  bool operator==(const Parameters&) const = default;
};
using Gradient = Parameters;

// Calls `visit` with the name of each array and the array.
template <class P, class Visit>
void each_array(P& p, Visit&& visit) {
  visit("mean", p.mean);
  visit("log_scale", p.log_scale);
  visit("sh_dc", p.sh_dc);
  visit("rotation", p.rotation);
  visit("opacity_logit", p.opacity_logit);
  visit("sh_rest", p.sh_rest);
}

// std::invalid_argument for a scene that contradicts itself or is antialiased: that opacity has no gradient here.
Parameters parameters_of(const Scene& scene);
Scene scene_of(const Parameters& parameters, const std::string& name);

// Zeros in the shape of the parameters.
Gradient zero_gradient(const Parameters& parameters);

// std::invalid_argument if the arrays have not the same length, or the other has another shape.
void check_consistent(const Parameters& parameters);
void check_same_shape(const Parameters& parameters, const Gradient& gradient);

// One Gaussian, as a scene holds it and as it is drawn.
Gaussian gaussian_of(const Parameters& parameters, std::size_t i);
const float* sh_rest_of(const Parameters& parameters, std::size_t i);  // null for degree 0
Cull activate(const Parameters& parameters, std::size_t i, ActivatedGaussian& out);

}  // namespace pipegs
