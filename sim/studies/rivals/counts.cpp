// SPDX-License-Identifier: Apache-2.0
// counts.cpp: see counts.hpp.
//
// Idea    Project all -> into lists -> walk the tiles -> voxels; a file of count/ for each.
#include "sim/studies/rivals/counts.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "sim/studies/rivals/count/voxels.hpp"
#include "sim/studies/rivals/count/walk.hpp"

namespace pipegs {

WalkCounts& WalkCounts::operator+=(const WalkCounts& o) {
  open += o.open, alive += o.alive;
  return *this;
}

PartCounts& PartCounts::operator+=(const PartCounts& o) {
  all += o.all, tile_open += o.tile_open, open += o.open, live += o.live;
  return *this;
}

TileCounts& TileCounts::operator+=(const TileCounts& o) {
  walk.square += o.walk.square, walk.axis += o.walk.axis;
  walk.oriented += o.walk.oriented, walk.exact += o.walk.exact;
  oriented_8x8 += o.oriented_8x8, exact_8x8 += o.exact_8x8, exact_4x4 += o.exact_4x4;
  exact_16x1 += o.exact_16x1, exact_8x1 += o.exact_8x1;
  reached += o.reached, blends += o.blends, stops += o.stops;
  return *this;
}

ListSums list_sums(const std::vector<uint32_t>& lengths, uint64_t chunk, uint64_t ways) {
  ListSums sums;
  for (const uint64_t n : lengths) {
    if (n == 0) continue;
    sums.pairs += n;
    ++sums.nonempty;
    sums.longest = std::max(sums.longest, n);
    sums.chunks += (n + chunk - 1) / chunk;
    const auto class_of_n = static_cast<size_t>(std::bit_width(n) - 1);
    sums.histogram.resize(std::max(sums.histogram.size(), class_of_n + 1));
    ++sums.histogram[class_of_n];
    if (n <= chunk) continue;
    ++sums.long_lists;
    sums.long_pairs += n;
    for (uint64_t reach = chunk; reach < n; reach *= ways) sums.steps += n;
  }
  return sums;
}

FrameCounts count_frame(const Scene& scene, const Camera& camera, const CountOptions& options) {
  std::vector<double> edges = options.other_voxels;
  edges.push_back(options.voxel);
  if (!std::all_of(edges.begin(), edges.end(), [](double edge) { return edge > 0; }))
    throw std::invalid_argument("counts: a voxel's edge is above 0");
  if (options.group <= 0 || options.group % kTileSide != 0)
    throw std::invalid_argument("counts: a group's side is a multiple of 16");
  check_consistent(scene);
  FrameCounts counts;
  counts.width = camera.width, counts.height = camera.height;
  const SeenScene seen = see(scene, camera, options);
  counts.gaussians.scene = scene.gaussians.size();
  counts.gaussians.valid = seen.valid, counts.gaussians.in_front = seen.in_front;
  const TileLists lists = count_lists(seen, camera, options, counts);
  const std::vector<double> stop_depth = count_walks(seen, lists, camera, options, counts);
  counts.voxels = count_voxels(scene, seen, stop_depth, camera, options);
  for (const double edge : options.other_voxels) {
    CountOptions other = options;
    other.voxel = edge;
    counts.other_voxels.push_back(count_voxels(scene, seen, stop_depth, camera, other));
  }
  return counts;
}

}  // namespace pipegs
