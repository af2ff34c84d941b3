// SPDX-License-Identifier: Apache-2.0
// view.hpp: what the terms need of a view: pixels and keys of each list, for the whole frame and for each layer.
//
// Idea    A list is that of a 16-px tile or of a 64-px window, which has the pixels of its sixteen tiles.
#pragma once

#include <map>
#include <vector>

#include "sim/studies/rivals/counts.hpp"
#include "sim/studies/terms/terms.hpp"

namespace pipegs {

struct ListWork {
  std::array<double, kWorks> all = {}, open = {};  // pixels; open: before tile or part is opaque
  ByCover<double> keys = {};
  double turns = 0;  // 64-px windows only: WindowCounts
  double pixels(PixelSet work, bool stop) const { return (stop ? open : all)[static_cast<size_t>(work)]; }
  ListWork& operator+=(const ListWork& o);
};
// By what the Gaussians of a work are listed.
Cover list_cover(PixelSet work);

// The frame, or a layer of it.
struct Slice {
  double valid = 0, frustum = 0;  // Gaussians of the file; of those in the frustum
  std::vector<ListWork> tiles = {}, windows = {};
  ListWork all_tiles = {}, all_windows = {};  // their sums
  const std::vector<ListWork>& lists(int side) const { return side == kTileSide ? tiles : windows; }
  const ListWork& sum(int side) const { return side == kTileSide ? all_tiles : all_windows; }
  void add_up();
};

struct TermsView {
  double pixels = 0;  // of the image
  double file = 0;    // Gaussians
  Slice frame = {};
  std::map<int, std::vector<Slice>> grids = {};  // layers by the cells of their grid
};

// Counts must have at least one grid.
TermsView terms_view(const FrameCounts& counts);

}  // namespace pipegs
