// SPDX-License-Identifier: Apache-2.0
// by_hand.hpp: the counts of a view of two tiles, small enough that a frame of any model can be worked by hand.
#pragma once

#include "sim/studies/rivals/counts.hpp"

namespace pipegs {

// 32x16 pixels: two tiles of 16 px, one of 64 px, one group. 1000 Gaussians, 100 visible.
inline FrameCounts two_tiles() {
  FrameCounts counts;
  counts.width = 32, counts.height = 16;
  counts.gaussians = {.scene = 1000, .valid = 1000, .in_front = 1000, .listed = {100, 100, 100, 100}};
  ListCounts &tiles = counts.lists[kLists16], &groups = counts.lists[kLists64];
  tiles.side = 16, tiles.columns = 2, tiles.rows = 1;
  tiles.lengths = {.square = {80, 20}, .axis = {50, 12}, .oriented = {40, 10}, .exact = {30, 8}};
  groups.side = 64, groups.columns = 1, groups.rows = 1;
  groups.lengths = {.square = {90}, .axis = {60}, .oriented = {45}, .exact = {35}};
  TileCounts first, second;
  first.walk = {.square = {60, 0}, .axis = {35, 0}, .oriented = {30, 0}, .exact = {25, 0}};
  first.oriented_8x8.open = 70, first.exact_8x8.open = 60, first.exact_4x4.open = 200;
  second.walk = {.square = {20, 0}, .axis = {12, 0}, .oriented = {10, 0}, .exact = {8, 0}};
  second.oriented_8x8.open = 16, second.exact_8x8.open = 12, second.exact_4x4.open = 40;
  counts.tiles = {first, second};
  for (const TileCounts& tile : counts.tiles) counts.total += tile;
  counts.neighbours = {.pairs = 99, .tiles = 50, .shared = 5};
  const FilterCounts filtered{.fetched = 400, .coarse = 90, .fine = 50};
  counts.voxels = {.edge = 2, .open_pairs = 4, .open = filtered, .groups = {{4, filtered}}};
  const FilterCounts finer{.fetched = 200, .coarse = 100, .fine = 50};
  counts.other_voxels = {{.edge = 1, .open_pairs = 8, .open = finer, .groups = {{8, finer}}}};
  return counts;
}

}  // namespace pipegs
