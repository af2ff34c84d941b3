// SPDX-License-Identifier: Apache-2.0
// splats: the Gaussians that a camera sees, projected, and for each tile of 16x16 pixels the list of those that touch
// it, in the order of blending.
//
// Idea    The power of a Gaussian with cov2d (a b; b c) by completing the square:
//           u = dx - rho dy,  rho = b/c,  tau = a - b^2/c:   power = -(u^2 / tau + dy^2 / c) / 2
//         Both terms are >= 0, so a needle keeps its digits in float32, and along a row the power costs one addition,
//         one multiplication and one subtraction. Powers are in base 2, the opacity's logarithm included.
// Order   The list of a tile needs no sort: splats are sorted once for the picture and dealt to the tiles in order.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sim/studies/train/gradient/drawing.hpp"

namespace pipegs {

inline constexpr int kTile = 16;

template <class Scalar>
struct DrawnSplat {
  glm::dvec2 mean;  // pixels
  double depth;     // view z
  Scalar slope;     // rho
  Scalar steep;     // sqrt(log2(e) / (2 tau))
  Scalar tall;      // log2(e) / (2 c)
  Scalar log2_opacity;
  Scalar rgb[3];
  std::uint32_t index;  // of the Gaussian
  std::uint32_t pair;   // number of its first pair; those of a splat follow each other, tile by tile
  std::uint16_t layer;
  std::uint16_t x0, y0, x1, y1;  // tiles [x0, x1) x [y0, y1)
  std::uint32_t pairs() const { return static_cast<std::uint32_t>(x1 - x0) * static_cast<std::uint32_t>(y1 - y0); }
};

// A splat in a tile.
struct TilePair {
  std::uint32_t splat, number;
};

template <class Scalar>
struct DrawnSplats {
  int columns = 0, rows = 0;               // of tiles
  std::vector<DrawnSplat<Scalar>> splats;  // by rising index
  std::vector<std::size_t> first;          // of a tile's list; one more at the end: how many pairs there are
  std::vector<TilePair> lists;
  std::span<const TilePair> list(std::size_t tile) const {
    return std::span(lists).subspan(first[tile], first[tile + 1] - first[tile]);
  }
};

template <class Scalar>
DrawnSplats<Scalar> splats_of(const Parameters& parameters, const Camera& camera, const DrawOptions& options);

extern template DrawnSplats<float> splats_of<float>(const Parameters&, const Camera&, const DrawOptions&);
extern template DrawnSplats<double> splats_of<double>(const Parameters&, const Camera&, const DrawOptions&);

}  // namespace pipegs
