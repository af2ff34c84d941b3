// SPDX-License-Identifier: Apache-2.0
// seen.hpp: the Gaussians that may be in a tile of the view, projected by cpp_model/float, in depth order.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "cpp_model/float/projection.hpp"
#include "sim/studies/rivals/counts.hpp"

namespace pipegs {

struct SeenGaussian {
  glm::dvec2 mean{0};
  glm::dvec3 conic{0};
  double variance_x = 0, variance_y = 0;
  double opacity = 0, depth = 0;
  double least_power = 0;                // below it alpha < 1/255 for certain
  double radius = 0;                     // of INRIA's square, pixels
  glm::dvec2 axis{1, 0};                 // along the longer eigenvector, unit
  double half_long = 0, half_short = 0;  // of the oriented box, 3 sigma
  PixelRect reach = {};                  // pixels of the image beyond which alpha < 1/255 for certain
  uint32_t index = 0;                    // in the scene
};

// 3 standard deviations along the longer eigenvector of a covariance, pixels.
double three_sigma(double a, double b, double c);

// In depth order; what is said of a Gaussian elsewhere is by its place here.
std::vector<SeenGaussian> see(const Scene& scene, const Camera& camera, const CountOptions& options);

}  // namespace pipegs
