// SPDX-License-Identifier: Apache-2.0
// cover.hpp: which tiles and pixels one Gaussian covers, by each of the tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/studies/rivals/count/seen.hpp"

namespace pipegs {

// The tiles of one side.
struct TileGrid {
  int side, columns, rows;
  TileGrid(const Camera& camera, int tile_side)
      : side(tile_side),
        columns((camera.width + tile_side - 1) / tile_side),
        rows((camera.height + tile_side - 1) / tile_side) {}
  size_t count() const { return static_cast<size_t>(columns) * static_cast<size_t>(rows); }
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(columns) + static_cast<size_t>(x);
  }
  // Of the image, in tile (x, y).
  PixelRect pixels(int x, int y, const Camera& camera) const {
    return {x * side, y * side, std::min((x + 1) * side, camera.width), std::min((y + 1) * side, camera.height)};
  }
};

// Some tiles of a grid.
class TileSet {
 public:
  void clear(const PixelRect& tiles);  // none; only tiles of this rectangle may come
  void add(int x, int y) { in_[at(x, y)] = 1; }
  bool has(int x, int y) const {
    return x >= tiles_.x0 && x < tiles_.x1 && y >= tiles_.y0 && y < tiles_.y1 && in_[at(x, y)] != 0;
  }
  const PixelRect& tiles() const { return tiles_; }
  template <class Action>
  void for_each(Action&& action) const {
    for (int y = tiles_.y0; y < tiles_.y1; ++y) {
      for (int x = tiles_.x0; x < tiles_.x1; ++x) {
        if (in_[at(x, y)] != 0) action(x, y);
      }
    }
  }
  uint64_t count() const;

 private:
  size_t at(int x, int y) const {
    return static_cast<size_t>(y - tiles_.y0) * static_cast<size_t>(tiles_.x1 - tiles_.x0) +
           static_cast<size_t>(x - tiles_.x0);
  }
  PixelRect tiles_ = {};
  std::vector<uint8_t> in_;
};

// Pixels [x0, x1) of a row; none if x0 >= x1.
struct PixelSpan {
  int x0 = 0, x1 = 0;
  bool empty() const { return x0 >= x1; }
};

// Where alpha >= 1/255 in row y, within `limits`. Power is concave along a row, so these pixels stand together.
PixelSpan reached_span(const SeenGaussian& s, int y, const PixelSpan& limits);
// alpha at a pixel, 0 below 1/255.
double alpha_at(const SeenGaussian& s, int x, int y);
// Of each row of s.reach.
void reached_spans(const SeenGaussian& s, std::vector<PixelSpan>& spans);

// Tiles [x0, x1) x [y0, y1) of INRIA's square.
PixelRect square_tiles(const SeenGaussian& s, const TileGrid& grid);
// Whether the oriented box, edges included, touches the square area around `middle`.
bool box_touches(const SeenGaussian& s, const glm::dvec2& middle, double half);
// A tile's area is the square of its pixels' centres.
inline double half_of(int side) { return 0.5 * (side - 1); }
inline glm::dvec2 middle_of(int side, int x, int y) { return {side * x + half_of(side), side * y + half_of(side)}; }

// `spans` are those of reached_spans.
void covered(const SeenGaussian& s, const std::vector<PixelSpan>& spans, const TileGrid& grid, Cover cover,
             TileSet& set);

}  // namespace pipegs
