// SPDX-License-Identifier: Apache-2.0
// view.hpp: a view that can be worked by hand: two tiles in one window, three layers, the last of them out of sight.
#pragma once

#include "sim/studies/terms/model.hpp"

namespace pipegs {

// Pixels by PixelSet; with early stop three quarters of those of the parts and pixels.
inline ListWork list_work(double keys, double tile_pixels, double parts, double exact, double reached) {
  ListWork work{.all = {tile_pixels, tile_pixels, parts, exact, reached},
                .open = {tile_pixels, tile_pixels, 0.75 * parts, 0.75 * exact, 0.75 * reached}};
  for (const Cover cover : kAllCovers) work.keys[cover] = keys;
  return work;
}

inline Slice slice_of_lists(double valid, double frustum, const ListWork& a, const ListWork& b, double window_keys,
                            double turns) {
  Slice slice{.valid = valid, .frustum = frustum, .tiles = {a, b}, .windows = {a}};
  slice.windows[0] += b;
  for (const Cover cover : kAllCovers) slice.windows[0].keys[cover] = window_keys;
  slice.windows[0].turns = turns;
  slice.add_up();
  return slice;
}

// Tile A has 20 Gaussians and 2560 pixels of parts, B two and 256; half of A's are in the first layer. Both of B's are
// in A, too. In the second grid all lie in one layer.
inline TermsView hand_view() {
  const ListWork a = list_work(20, 5120, 2560, 1280, 800), b = list_work(2, 512, 256, 128, 64),
                 half = list_work(10, 2560, 1280, 640, 400), none = list_work(0, 0, 0, 0, 0);
  TermsView view{.pixels = 512, .file = 40, .frame = slice_of_lists(40, 24, a, b, 20, 400)};
  view.grids[4] = {slice_of_lists(16, 10, half, none, 10, 200), slice_of_lists(16, 14, half, b, 10, 200),
                   slice_of_lists(8, 0, none, none, 0, 0)};
  view.grids[8] = {view.frame};
  return view;
}

// A pixel, a comparison and a pixel of alpha a cycle, everything on chip.
inline Terms hand_terms() {
  return {.stop = false, .lane = LanePace::kPixel, .sort = SortPace::kCompare, .rows = RowPace::kOne, .pre = 4};
}

}  // namespace pipegs
