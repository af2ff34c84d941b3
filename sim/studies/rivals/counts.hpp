// SPDX-License-Identifier: Apache-2.0
// counts.hpp: what a view asks of any renderer by tiles: how many Gaussians, pairs, keys, parts of tiles, voxels.
//
// Idea    A model of a machine that is not ours is a formula over such counts. They are counted here, on the view, by
//         the float64 projection, depth order and blending of cpp_model/float; nothing is estimated or sampled. Only
//         what a model or a check of one asks for is counted.
// Rule    Pictures are those of kExact: a Gaussian is in a pixel where alpha >= 1/255, and a pixel stops at the one
//         that would bring T below 1e-4. That picture decides when a tile is opaque, whichever list is counted: what a
//         list of 3 sigma leaves out hardly moves it.
//         Depth order is by view z, ties by index. Counts depend neither on the threads nor, without ties, on the order
//         of the Gaussians in the file.
// Tiles   Tile (x, y) of side n has pixels [n x, n x + n). Boxes are held against the square of its pixels' centres,
//         from n x to n x + n - 1: what touches no centre changes no pixel, so no test that is lossless for its box has
//         fewer pairs. Tiles at the right and lower edge are whole; pixels outside of the image are never alive.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

// By what a Gaussian is put into a tile's list.
enum class Cover {
  kSquare,    // INRIA: the square of ceil(3 sigma) of the longer axis around the mean, in whole tiles as its getRect
  kAxis,      // of those tiles, the ones that the box of 3 sigma in x and y touches
  kOriented,  // GSCore: of those of the square, the ones that the box of 3 sigma along both eigenvectors touches
  kExact,     // alpha >= 1/255 at a pixel of the tile; up to 3.33 sigma, so not always among those of the square
};
inline constexpr Cover kAllCovers[] = {Cover::kSquare, Cover::kAxis, Cover::kOriented, Cover::kExact};

template <class T>
struct ByCover {
  T square{}, axis{}, oriented{}, exact{};
  T& operator[](Cover cover) {
    T* const all[] = {&square, &axis, &oriented, &exact};
    return *all[static_cast<int>(cover)];
  }
  const T& operator[](Cover cover) const { return (*const_cast<ByCover*>(this))[cover]; }
  bool operator==(const ByCover&) const = default;
};

inline constexpr int kTileSide = 16;                               // of the tiles that are walked, pixels
inline constexpr std::array<int, 2> kListSides = {kTileSide, 64};  // of the tiles that have lists, pixels
inline constexpr int kLists16 = 0, kLists64 = 1;                   // places of these sides in kListSides
inline constexpr int kGroupSide = 64;                              // of a group of pixels that streams voxels

struct CountOptions {
  double near_plane = 0.2;
  std::vector<double> voxels = {2};  // edges of voxels, scene units
  unsigned threads = 0;              // 0: as many as the machine has
  std::function<void(double)> progress = {};
};

// Tiles of one side. A list's length is the number of (Gaussian, tile) pairs of this tile, opaque or not.
struct ListCounts {
  int side = 0, columns = 0, rows = 0;
  ByCover<std::vector<uint32_t>> lengths = {};  // row by row
  bool operator==(const ListCounts&) const = default;
};

// Of a 16-px tile, what comes before it, or its part, is opaque: before all of its pixels have stopped, the Gaussian
// that stops the last one included.
struct TileCounts {
  ByCover<uint64_t> open = {};  // Gaussians of the tile's list
  uint64_t oriented_8x8 = 0;    // (Gaussian, part): parts that the oriented box touches, of tiles that it touches
  uint64_t exact_8x8 = 0, exact_4x4 = 0;  // (Gaussian, part): parts with alpha >= 1/255 at a pixel
  bool operator==(const TileCounts&) const = default;
};

// Gaussians with an oriented box in a 16-px tile, in depth order, each against the one before.
struct NeighbourCounts {
  uint64_t tiles = 0;   // tiles of the later one, summed
  uint64_t shared = 0;  // of those, that the earlier one has too
  bool operator==(const NeighbourCounts&) const = default;
};

// Gaussians that a group of pixels streams.
struct FilterCounts {
  uint64_t voxels = 0;   // open ones that the group meets
  uint64_t fetched = 0;  // Gaussians whose mean lies in these
  uint64_t coarse = 0;   // of those, in front and with a sphere of 3 times the largest scale that touches the group
  uint64_t fine = 0;     // of those, with alpha >= 1/255 at a pixel of the group
  bool operator==(const FilterCounts&) const = default;
};

// A voxel is met by a group when the ray through the centre of one of its pixels passes through it beyond the near
// plane. It is open when its nearest corner lies before the depth at which the last pixel of the group stops, so that
// no order of voxels fetches less.
struct VoxelCounts {
  std::vector<FilterCounts> groups = {};  // row by row
  FilterCounts sum() const;
};

struct FrameCounts {
  int width = 0, height = 0;
  uint64_t scene = 0;             // Gaussians in the file
  ByCover<uint64_t> listed = {};  // of those, in a 16-px tile of the image; square: in the frustum, exact: visible
  std::array<ListCounts, kListSides.size()> lists = {};
  std::vector<TileCounts> tiles = {};  // of 16 px, row by row, as lists[kLists16] has them
  NeighbourCounts neighbours = {};
  std::vector<VoxelCounts> voxels = {};  // of each edge of CountOptions::voxels
};

// Throws std::invalid_argument for a voxel that is not above 0, std::runtime_error when interrupted.
FrameCounts count_frame(const Scene& scene, const Camera& camera, const CountOptions& options);

}  // namespace pipegs
