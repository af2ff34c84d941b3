// SPDX-License-Identifier: Apache-2.0
// brute.hpp: the counts of sim/studies/rivals once more, by looking at every pixel, tile and ray for every Gaussian.
//
// Idea    Shares the projection of cpp_model/float and the structures of counts.hpp, and nothing else: boxes are
//         polygons that are clipped, eigenvectors come from an angle, rays are held against the faces of a voxel.
#pragma once

#include "sim/studies/rivals/counts.hpp"

namespace pipegs {

FrameCounts brute_counts(const Scene& scene, const Camera& camera, const CountOptions& options);

}  // namespace pipegs
