// SPDX-License-Identifier: Apache-2.0
// streaming.hpp: the picture of STREAMINGGS: each group of pixels takes voxel by voxel, and sorts within a voxel only.
//
// Paper   arXiv 2506.09070: voxels in topological order (voxel_order.hpp); of each one the Gaussians whose mean lies in
//         it, through a coarse and a fine filter, sorted by depth and blended before those of the next.
// Rule    Coarse: the circle of 3 times the largest scale touches the group. Fine: alpha >= 1/255 at a pixel of it.
//         Voxels are fetched whole, until the group's last pixel has stopped: 16 bytes for each of their Gaussians, and
//         an index for each that passes the coarse filter, whose bytes the paper does not say.
// Error   Of two kinds. `order`: a Gaussian that reaches into another voxel is blended with its own. `lost`: one that
//         reaches into a group which does not meet its voxel, or only beyond 3 sigma, is not blended there.
#pragma once

#include <vector>

#include "sim/studies/rivals/pixels/view.hpp"
#include "sim/studies/rivals/pixels/voxel_order.hpp"

namespace pipegs {

// A scene in voxels of one edge, and the order in which a view takes them.
struct VoxelScene {
  double edge = 0;
  std::vector<Member> members = {};
  std::vector<std::span<const Member>> voxels = {};  // by number
  std::vector<uint32_t> voxel_of = {};               // of each valid Gaussian of the scene: the number of its voxel
  VoxelOrder order;
};
VoxelScene voxel_scene(const Scene& scene, const PixelView& view, double edge, double near_plane, unsigned threads);

// Of all Gaussians of the scene.
std::vector<Circle> coarse_circles(const Scene& scene, const Camera& camera, double near_plane, unsigned threads);

struct StreamPicture {
  Sequences sequences;  // in the order of the voxels
  OrderedPicture blend;
  StreamCounts counts;
};
// `exact`: of exact_sequences, for the groups' side.
StreamPicture stream(const PixelView& view, const VoxelScene& voxels, const std::vector<Circle>& circles,
                     const Sequences& exact, unsigned threads);

// The same Gaussians of each group in depth order.
Sequences by_depth(Sequences sequences);

}  // namespace pipegs
