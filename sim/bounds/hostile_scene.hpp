// SPDX-License-Identifier: Apache-2.0
// hostile_scene.hpp: random hostile scenes and cameras: every family of trouble that docs/numerics/stability.md
// lists, mixed.
//
// Idea    A seed gives a camera (odd sizes, fx != fy, principal point anywhere, any rotation) and Gaussians drawn
//         family by family in the camera's own space, then moved to the world: log-uniform scale, ratio, depth and
//         opacity, needles at multiples of 7.5 degrees, equal depths, centres on the near plane and at the guard band's
//         edge, sizes from 2^-30 to 2^30 of their depth, colours far outside [0, 1], broken values.
// Rule    The same seed gives the same view on every machine: integers from one generator, no std distributions.
#pragma once

#include <cstdint>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct StressShape {
  int gaussians = 0;          // 0: 10 to 300
  int width = 0, height = 0;  // 0: 1 to 160, 1 to 120
};

struct StressView {
  Scene scene;
  Camera camera;
  double near_plane = 0.2;
};

StressView stress_view(uint64_t seed, const StressShape& shape = {});

}  // namespace pipegs
