// SPDX-License-Identifier: Apache-2.0
// view.cpp: see view.hpp.
#include "sim/studies/terms/view.hpp"

#include <stdexcept>

namespace pipegs {
namespace {

constexpr double kTilePixels = 256, kPartPixels = 64;
constexpr int kTilesOfWindow = 4;  // along a side

double& at(std::array<double, kWorks>& works, PixelSet work) { return works[static_cast<size_t>(work)]; }

ListWork tile_work(const TileCounts& tile, const ListCounts& lists, size_t t) {
  ListWork work;
  at(work.all, PixelSet::kSquareTiles) = kTilePixels * lists.lengths.square[t];
  at(work.open, PixelSet::kSquareTiles) = kTilePixels * static_cast<double>(tile.walk.square.open);
  at(work.all, PixelSet::kOrientedTiles) = kTilePixels * lists.lengths.oriented[t];
  at(work.open, PixelSet::kOrientedTiles) = kTilePixels * static_cast<double>(tile.walk.oriented.open);
  at(work.all, PixelSet::kOrientedParts) = kPartPixels * static_cast<double>(tile.oriented_8x8.all);
  at(work.open, PixelSet::kOrientedParts) = kPartPixels * static_cast<double>(tile.oriented_8x8.open);
  at(work.all, PixelSet::kExactParts) = kPartPixels * static_cast<double>(tile.exact_8x8.all);
  at(work.open, PixelSet::kExactParts) = kPartPixels * static_cast<double>(tile.exact_8x8.open);
  at(work.all, PixelSet::kReached) = static_cast<double>(tile.reached);
  at(work.open, PixelSet::kReached) = static_cast<double>(tile.blends + tile.stops);
  return work;
}

void set_keys(ListWork& work, const ListCounts& lists, size_t list) {
  for (const Cover cover : kAllCovers) work.keys[cover] = lists.lengths[cover][list];
}

Slice slice_of(const std::vector<TileCounts>& tiles, const ListCounts& of_tiles, const ListCounts& of_windows) {
  Slice slice;
  slice.windows.resize(of_windows.lengths.exact.size());
  for (size_t t = 0; t < tiles.size(); ++t) {
    const ListWork work = tile_work(tiles[t], of_tiles, t);
    const size_t x = t % static_cast<size_t>(of_tiles.columns), y = t / static_cast<size_t>(of_tiles.columns);
    ListWork& window = slice.windows[y / kTilesOfWindow * static_cast<size_t>(of_windows.columns) + x / kTilesOfWindow];
    for (size_t w = 0; w < kWorks; ++w) window.all[w] += work.all[w], window.open[w] += work.open[w];
    slice.tiles.push_back(work);
    set_keys(slice.tiles.back(), of_tiles, t);
  }
  for (size_t w = 0; w < slice.windows.size(); ++w) set_keys(slice.windows[w], of_windows, w);
  return slice;
}

}  // namespace

ListWork& ListWork::operator+=(const ListWork& o) {
  for (size_t w = 0; w < kWorks; ++w) all[w] += o.all[w], open[w] += o.open[w];
  for (const Cover cover : kAllCovers) keys[cover] += o.keys[cover];
  turns += o.turns;
  return *this;
}

void Slice::add_up() {
  all_tiles = all_windows = {};
  for (const ListWork& tile : tiles) all_tiles += tile;
  for (const ListWork& window : windows) all_windows += window;
}

Cover list_cover(PixelSet work) {
  return work == PixelSet::kSquareTiles  ? Cover::kSquare
         : work == PixelSet::kExactParts ? Cover::kExact
                                         : Cover::kOriented;
}

TermsView terms_view(const FrameCounts& counts) {
  if (counts.grids.empty()) throw std::invalid_argument("terms: no layers are counted");
  TermsView view;
  view.pixels = static_cast<double>(counts.width) * counts.height;
  view.file = static_cast<double>(counts.gaussians.scene);
  view.frame = slice_of(counts.tiles, counts.lists[kLists16], counts.lists[kLists64]);
  view.frame.valid = static_cast<double>(counts.gaussians.valid);
  view.frame.frustum = static_cast<double>(counts.gaussians.listed.square);
  for (const GridCounts& grid : counts.grids) {
    for (const LayerCounts& layer : grid.layers) {
      Slice slice = slice_of(layer.tiles, layer.lists[0], layer.lists[1]);
      slice.valid = static_cast<double>(layer.valid);
      slice.frustum = static_cast<double>(layer.listed.square);
      for (size_t w = 0; w < layer.windows.size(); ++w)
        slice.windows[w].turns = static_cast<double>(layer.windows[w].turns);
      slice.add_up();
      view.grids[grid.cells].push_back(slice);
    }
  }
  // A Gaussian is in one layer, so those of any grid add up to the frame's.
  for (const Slice& layer : view.grids.begin()->second) {
    for (size_t w = 0; w < layer.windows.size(); ++w) view.frame.windows[w].turns += layer.windows[w].turns;
  }
  view.frame.add_up();
  return view;
}

}  // namespace pipegs
