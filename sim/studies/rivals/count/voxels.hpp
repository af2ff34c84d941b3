// SPDX-License-Identifier: Apache-2.0
// voxels.hpp: the voxels that groups of pixels meet, and the Gaussians that come out of them through two filters.
#pragma once

#include <vector>

#include "sim/studies/rivals/count/cover.hpp"

namespace pipegs {

// `stop_depth`: of each 16-px tile, as count_walks returns it.
VoxelCounts count_voxels(const Scene& scene, const std::vector<SeenGaussian>& seen,
                         const std::vector<double>& stop_depth, const Camera& camera, double edge,
                         const CountOptions& options);

}  // namespace pipegs
