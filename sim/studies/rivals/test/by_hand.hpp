// SPDX-License-Identifier: Apache-2.0
// by_hand.hpp: the counts of a view of two tiles, small enough that a frame of any model can be worked by hand.
#pragma once

#include "sim/studies/rivals/counts.hpp"

namespace pipegs {

// 32x16 pixels: two tiles of 16 px, one of 64 px, one group. 1000 Gaussians, 100 visible.
inline FrameCounts two_tiles() {
  FrameCounts counts;
  counts.width = 32, counts.height = 16;
  counts.scene = 1000, counts.listed = {100, 100, 100, 100};
  ListCounts &tiles = counts.lists[kLists16], &groups = counts.lists[kLists64];
  tiles.side = 16, tiles.columns = 2, tiles.rows = 1;
  tiles.lengths = {.square = {80, 20}, .axis = {50, 12}, .oriented = {40, 10}, .exact = {30, 8}};
  groups.side = 64, groups.columns = 1, groups.rows = 1;
  groups.lengths = {.square = {90}, .axis = {60}, .oriented = {45}, .exact = {35}};
  counts.tiles = {{.open = {60, 35, 30, 25}, .oriented_8x8 = 70, .exact_8x8 = 60, .exact_4x4 = 200},
                  {.open = {20, 12, 10, 8}, .oriented_8x8 = 16, .exact_8x8 = 12, .exact_4x4 = 40}};
  counts.neighbours = {.tiles = 50, .shared = 5};
  counts.voxels = {{.groups = {{.voxels = 4, .fetched = 400, .coarse = 90, .fine = 50}}},
                   {.groups = {{.voxels = 8, .fetched = 200, .coarse = 100, .fine = 50}}}};
  return counts;
}

}  // namespace pipegs
