// SPDX-License-Identifier: Apache-2.0
// back_project: what the pixels say of one splat, taken back to the fields of its Gaussian, in double.
//
// Paper   Eq. 1: cov2d = J W R S S^T R^T W^T J^T + 0.3 I.
// Idea    With U = J W R S (two rows of three) the loss depends on rho = b/c, tau = a - b^2/c and c (splats.hpp). Their
//         derivatives by a column (U0, U1) of U contain only w = U0 - rho U1 and U1. So the scale of a needle's long
//         axis, of which w is small, keeps its digits, where differences of a, b and c would lose them.
// Rule    x/z in J stands still beyond the guard band; a colour that is clamped at 0 stands still.
#pragma once

#include <glm/glm.hpp>

#include "scenes/camera.hpp"
#include "sim/layers/parameters.hpp"

namespace pipegs {

// The sums over all pixels of a splat, as PairSums has them by tile.
struct SplatSums {
  double power[6] = {};
  glm::dvec3 color{0};
};

// What a splat says of its picture.
struct SplatView {
  glm::bvec3 lit;  // channels of its colour that are above 0
  int sh_degree;   // that was evaluated
};

struct SeenSplat {
  double mean_gradient = 0, radius = 0;  // see Seen
};

// Adds to `gradient` at i.
SeenSplat back_project(const Parameters& parameters, std::size_t i, const Camera& camera, const SplatView& view,
                       const SplatSums& sums, Gradient& gradient);

}  // namespace pipegs
