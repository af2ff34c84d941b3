// SPDX-License-Identifier: Apache-2.0
// contribution.hpp: what a Gaussian adds to a scene's pictures, and the scene without those that add least.
//
// Idea    A Gaussian's contribution is the largest weight alpha T that it has at any pixel of any camera, as RadSplat
//         (arXiv 2403.13806) prunes by. What no camera sees has none and goes first.
// Rule    Cameras are those of the file, the view that is measured among them: elsewhere more may be missing.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

// Of each Gaussian, in float64 and depth order; `progress` is called with 0 to 1.
std::vector<float> contributions(const Scene& scene, const std::vector<Camera>& cameras, double near_plane,
                                 const std::function<void(double)>& progress);

// How many of `count` Gaussians a share is: the nearest number.
size_t left_out(size_t count, double without);
// The scene without its share `without` (0 to 1) of least contribution; equal ones by index, the first go.
Scene without_least(const Scene& scene, const std::vector<float>& contributions, double without);

}  // namespace pipegs
