// SPDX-License-Identifier: Apache-2.0
// tile: the pixels of one tile of 16x16, forward and backward through its list.
//
// Paper   Eq. 2.
// Idea    A row of pixels is 16 lanes. For each splat, first what all rows have in common (TileRows): where the power
//         is largest in each row, and whether it reaches 1/255 there; rows in which it does not are passed over.
//         Backward walks the same list from the end. With T the transmittance before a splat, w = alpha T its weight,
//         c its colour, g = d loss / d pixel and b = g . (what lies behind it, of weight 1):
//           d loss / d alpha = T (g.c - b)      b <- b + alpha (g.c - b)      T <- T / (1 - alpha) beforehand
//         so no colour behind is kept, only one number for each pixel.
// Sums    Of d loss / d power = w (g.c - b): with 1, u, dy, u^2, u dy, dy^2 (u in units of 1 / steep); of w g: three.
//         All that a Gaussian's gradient needs of a tile.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sim/studies/train/gradient/raster/lanes.hpp"
#include "sim/studies/train/gradient/raster/splats.hpp"

namespace pipegs {

// What blending leaves for the way back. Row y of the tile, lane x.
template <class Scalar>
struct TileState {
  Lanes<Scalar> transmittance[kTile];
  Masks<Scalar> last[kTile];  // how many of the list up to the last that was blended
};

template <class Scalar>
struct TileColors {
  Lanes<Scalar> rgb[3][kTile];
};

// What the pixels of a tile add to one splat.
template <class Scalar>
struct PairSums {
  Scalar power[6];  // 1, u, dy, u^2, u dy, dy^2
  Scalar color[3];
};

// A tile in the picture: its first pixel, and how many of its columns and rows lie inside.
struct TileArea {
  int x, y, columns, rows;
};

// `colors` without background.
template <class Scalar>
void blend_tile(const TileArea& area, std::span<const DrawnSplat<Scalar>> splats, std::span<const TilePair> list,
                TileState<Scalar>& state, TileColors<Scalar>& colors);

// Writes the sums of all pairs of the list.
template <class Scalar>
void unblend_tile(const TileArea& area, std::span<const DrawnSplat<Scalar>> splats, std::span<const TilePair> list,
                  const TileState<Scalar>& state, const TileColors<Scalar>& gradient, const glm::vec3& background,
                  PairSums<Scalar>* sums);

}  // namespace pipegs
