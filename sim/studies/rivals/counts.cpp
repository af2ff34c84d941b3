// SPDX-License-Identifier: Apache-2.0
// counts.cpp: see counts.hpp.
//
// Idea    Project all -> into lists -> walk the tiles -> voxels; a file of count/ for each.
#include "sim/studies/rivals/counts.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/studies/rivals/count/lists.hpp"

namespace pipegs {

FilterCounts VoxelCounts::sum() const {
  FilterCounts sum;
  for (const FilterCounts& one : groups) {
    sum.voxels += one.voxels, sum.fetched += one.fetched;
    sum.coarse += one.coarse, sum.fine += one.fine;
  }
  return sum;
}

FrameCounts count_frame(const Scene& scene, const Camera& camera, const CountOptions& options) {
  if (!std::ranges::all_of(options.voxels, [](double edge) { return edge > 0; }))
    throw std::invalid_argument("counts: a voxel's edge is above 0");
  check_consistent(scene);
  FrameCounts counts{.width = camera.width, .height = camera.height, .scene = scene.gaussians.size()};
  const std::vector<SeenGaussian> seen = see(scene, camera, options);
  const TileLists lists = count_lists(seen, camera, options, counts);
  const std::vector<double> stop_depth = count_walks(seen, lists, camera, options, counts);
  for (const double edge : options.voxels)
    counts.voxels.push_back(count_voxels(scene, seen, stop_depth, camera, edge, options));
  return counts;
}

}  // namespace pipegs
