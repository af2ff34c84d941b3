// SPDX-License-Identifier: Apache-2.0
// pack_merge: one Gaussian that stands for several.
//
// Paper   None: level of detail.
// Idea    Moments. Each Gaussian counts with what it covers, w = opacity * area, the area being that of its ellipsoid
//         seen from all sides, grown by a pixel's low-pass filter as in every picture (0.3 pixel^2 on each axis):
//           mean = sum w m / sum w,   covariance = sum w (V + (m - mean)(m - mean)^T) / sum w,   SH = sum w sh / sum w,
//           opacity = sum w / area of the result, at most 0.99
// Rule    Gaussians that cover nothing count alike. One alone comes out as it is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scenes/scene.hpp"

namespace pipegs {

struct Merged {
  Gaussian gaussian{};
  std::vector<float> sh_rest;  // as in Scene::sh_rest
  uint32_t heaviest = 0;       // of the scene's indices the one that covers most, the lowest of equals
};

// `indices`: at least one, each of a Gaussian that activate() accepts; `pixel`: its side at their distance, scene
// units.
Merged merge_gaussians(const Scene& scene, std::span<const uint32_t> indices, double pixel);

// The same in at most `most` parts: halves along the axis on which their means spread most, and so on.
std::vector<Merged> merge_parts(const Scene& scene, std::span<const uint32_t> indices, int most, double pixel);

}  // namespace pipegs
