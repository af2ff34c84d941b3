// SPDX-License-Identifier: Apache-2.0
// voxel_order.hpp: the order in which a group of pixels takes the voxels that its rays meet, as STREAMINGGS sorts them.
//
// Paper   arXiv 2506.09070, voxel sorting unit: each pixel of the group lists the voxels with Gaussians along its ray;
//         two that follow each other make an edge; what has no edge left into it goes out, round by round.
// Rule    Edges are those of all pixels of the group. Within a round voxels go out by their number, which is their
//         place by x, then y, then z: the paper does not say.
// Why     No cycles: all rays begin at the camera, so of two voxels on both sides of a plane between voxels every ray
//         meets first the one on the camera's side. Steps from the camera's voxel, summed over the axes, rise along
//         each ray; voxels in order of their steps are in an order of each ray, without comparing depths.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/studies/rivals/count/meet.hpp"

namespace pipegs {

class VoxelOrder {
 public:
  // `members` are those of voxels_of: the place of one is the number of its voxel.
  VoxelOrder(const std::vector<std::span<const Member>>& members, const Camera& camera, double near_plane, double edge,
             unsigned threads);

  // Numbers of the voxels that this group meets, in the order in which it takes them.
  std::vector<uint32_t> of_group(const TileGrid& groups, int x, int y) const;

 private:
  struct Tile {                   // of kTileSide pixels; voxels by their rank, which rises with their steps
    std::vector<uint32_t> nodes;  // ascending
    std::vector<uint64_t> edges;  // from << 32 | to, ascending
  };
  void trace(const Camera& camera, const Meeting& meeting, const std::vector<uint32_t>& candidates, size_t tile);

  TileGrid tiles_;
  std::vector<uint32_t> numbers_;    // by rank
  std::vector<glm::dvec3> corners_;  // the lowest ones, by rank
  std::vector<Tile> traced_;
};

}  // namespace pipegs
