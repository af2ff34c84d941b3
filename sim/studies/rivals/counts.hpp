// SPDX-License-Identifier: Apache-2.0
// counts.hpp: what a view asks of any renderer by tiles: how many Gaussians, pairs, keys, pixels, rows, voxels.
//
// Idea    A model of a machine that is not ours is a formula over such counts. They are counted here, on the view, by
//         the float64 projection, depth order and blending of cpp_model/float; nothing is estimated or sampled.
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
#include <iterator>
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
inline constexpr int kCovers = static_cast<int>(std::size(kAllCovers));

template <class T>
struct ByCover {
  T square{}, axis{}, oriented{}, exact{};
  T& operator[](Cover cover) {
    T* const all[] = {&square, &axis, &oriented, &exact};
    return *all[static_cast<int>(cover)];
  }
  const T& operator[](Cover cover) const { return (*const_cast<ByCover*>(this))[cover]; }
};

inline constexpr int kTileSide = 16;                                 // of the tiles that are walked, pixels
inline constexpr std::array<int, 4> kListSides = {16, 32, 64, 128};  // of the tiles that have lists, pixels
inline constexpr int kLists16 = 0, kLists64 = 2;                     // places of these sides in kListSides

struct CountOptions {
  double near_plane = 0.2;
  double voxel = 2;                       // edge of a voxel, scene units
  std::vector<double> other_voxels = {};  // edges of voxels that are counted as well
  int group = 16;                         // side of a group of pixels that streams voxels, a multiple of kTileSide
  unsigned threads = 0;                   // 0: as many as the machine has
  std::function<void(double)> progress = {};
};

struct GaussianCounts {
  uint64_t scene = 0;             // in the file
  uint64_t valid = 0;             // finite and with a rotation
  uint64_t in_front = 0;          // of those, in front of the near plane
  ByCover<uint64_t> listed = {};  // of those, in a 16-px tile of the image; square: in the frustum, exact: visible
  uint64_t blended = 0;           // adds to a pixel
  uint64_t in_two = 0;            // exact in two 16-px tiles or more
  uint64_t rows = 0;              // rows of pixels of the image that visible ones reach, each Gaussian for itself
};

// Tiles of one side. A list's length is the number of (Gaussian, tile) pairs of this tile, opaque or not.
struct ListCounts {
  int side = 0, columns = 0, rows = 0;
  ByCover<std::vector<uint32_t>> lengths = {};  // row by row
};

// Sums over lists, as sorters need them.
struct ListSums {
  uint64_t pairs = 0;                       // sum of n
  uint64_t nonempty = 0;                    // lists with n > 0
  uint64_t longest = 0;                     // largest n
  uint64_t long_lists = 0, long_pairs = 0;  // lists with n > chunk, and sum of n over them
  uint64_t chunks = 0;                      // sum of ceil(n / chunk)
  uint64_t steps = 0;                       // sum of n ceil(log_ways(n / chunk)), nothing for n <= chunk
  std::vector<uint64_t> histogram = {};     // [k]: lists with 2^k <= n < 2^(k+1)
};
ListSums list_sums(const std::vector<uint32_t>& lengths, uint64_t chunk = 16, uint64_t ways = 8);

// Of one list of a 16-px tile, walked in depth order.
struct WalkCounts {
  uint64_t open =
      0;  // pairs that come before all pixels of the tile have stopped, the one that stops the last included
  uint64_t alive = 0;  // pixels of the tile that have not stopped, summed over those pairs
  WalkCounts& operator+=(const WalkCounts& o);
};

// (Gaussian, part of a 16-px tile) pairs; parts without a pixel in the image do not count.
struct PartCounts {
  uint64_t all = 0;
  uint64_t tile_open = 0;  // that come before the tile is opaque
  uint64_t open = 0;       // that come before the part is opaque
  uint64_t live = 0;       // that have alpha >= 1/255 at a pixel of the part that has not stopped
  PartCounts& operator+=(const PartCounts& o);
};

struct TileCounts {
  ByCover<WalkCounts> walk = {};
  PartCounts oriented_8x8 = {};  // parts that the oriented box touches, of tiles that it touches
  PartCounts exact_8x8 = {}, exact_4x4 = {}, exact_16x1 = {}, exact_8x1 = {};  // alpha >= 1/255 at a pixel of the part
  uint64_t reached = 0;  // (Gaussian, pixel) with alpha >= 1/255, stopped or not
  uint64_t blends = 0;   // of those, that add to the pixel
  uint64_t stops = 0;    // of those, that stop the pixel: pixels that stop
  TileCounts& operator+=(const TileCounts& o);
};

// Lists of 64-px groups with a mask of 16-px tiles: exact (Gaussian, 16-px tile) pairs inside the pairs of the groups.
struct MaskCounts {
  uint64_t axis = 0, oriented = 0;
};

// Gaussians with an oriented box in a tile, in depth order, each against the one before.
struct NeighbourCounts {
  uint64_t pairs = 0;   // of Gaussians: one less than the Gaussians
  uint64_t tiles = 0;   // 16-px tiles of the later one, summed
  uint64_t shared = 0;  // of those, that the earlier one has too
};

struct FilterCounts {
  uint64_t fetched = 0;  // Gaussians whose mean lies in a voxel that is met
  uint64_t coarse = 0;   // of those, in front and with a sphere of 3 times the largest scale that touches the group
  uint64_t fine = 0;     // of those, with alpha >= 1/255 at a pixel of the group
};

// A voxel is met by a group when the ray through the centre of one of its pixels passes through it beyond the near
// plane. `pairs`, `all`, `open`: over (group, voxel). Open: the voxel's nearest corner lies before the depth at which
// the last pixel of the group stops, so that no order of voxels fetches less.
struct GroupCounts {
  uint64_t voxels = 0;         // open ones that it meets
  FilterCounts filtered = {};  // of these
};

struct VoxelCounts {
  double edge = 0;                       // scene units
  uint64_t occupied = 0, largest = 0;    // voxels with a Gaussian's mean in them; most Gaussians in one
  uint64_t met = 0;                      // of those, met by a group
  uint64_t pairs = 0, open_pairs = 0;    // (group, occupied voxel) that meet
  FilterCounts all = {}, open = {};      // (Gaussian, group)
  FilterCounts distinct = {};            // Gaussians, each once
  std::vector<GroupCounts> groups = {};  // row by row; their sums are open_pairs and open
};

struct FrameCounts {
  int width = 0, height = 0;
  GaussianCounts gaussians = {};
  std::array<ListCounts, kListSides.size()> lists = {};
  std::vector<TileCounts> tiles = {};  // of 16 px, row by row, as lists[kLists16] has them
  TileCounts total = {};               // their sum
  MaskCounts masks = {};
  NeighbourCounts neighbours = {};
  VoxelCounts voxels = {};
  std::vector<VoxelCounts> other_voxels = {};  // of the edges of CountOptions::other_voxels
};

// Throws std::invalid_argument for a voxel that is not above 0 or a group that is no multiple of kTileSide above 0,
// std::runtime_error when interrupted.
FrameCounts count_frame(const Scene& scene, const Camera& camera, const CountOptions& options);

}  // namespace pipegs
