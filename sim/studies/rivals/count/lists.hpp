// SPDX-License-Identifier: Apache-2.0
// lists.hpp: the steps of count_frame: every Gaussian of a view into the lists of the tiles that it covers, by each
// test and side; the lists of 16-px tiles walked in depth order, with the pixels that each Gaussian finds alive; the
// voxels that groups of pixels meet, and the Gaussians that come out of them through two filters.
#pragma once

#include <vector>

#include "sim/studies/rivals/count/cover.hpp"

namespace pipegs {

// A Gaussian in the list of a 16-px tile: its place in depth order, and a bit for each test by which it is there.
struct Entry {
  uint32_t place = 0, covers = 0;
  bool by(Cover cover) const { return (covers >> static_cast<int>(cover) & 1) != 0; }
};
using TileLists = std::vector<std::vector<Entry>>;  // of each 16-px tile, in depth order

// Counts lists, listed Gaussians and neighbours; returns the lists to walk.
TileLists count_lists(const std::vector<SeenGaussian>& seen, const Camera& camera, const CountOptions& options,
                      FrameCounts& counts);

// Counts tiles. Returns of each the depth at which its last pixel stops, infinity when one never does.
std::vector<double> count_walks(const std::vector<SeenGaussian>& seen, const TileLists& lists, const Camera& camera,
                                const CountOptions& options, FrameCounts& counts);

// `stop_depth`: of each 16-px tile, as count_walks returns it.
VoxelCounts count_voxels(const Scene& scene, const std::vector<SeenGaussian>& seen,
                         const std::vector<double>& stop_depth, const Camera& camera, double edge,
                         const CountOptions& options);

}  // namespace pipegs
