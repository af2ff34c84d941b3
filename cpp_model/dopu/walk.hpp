// SPDX-License-Identifier: Apache-2.0
// walk: what the DOPU walks the scene for at a time: a window, or one part of it.
//
// Paper   None: the paper walks windows.        RTL  rtl/dopu/dopu_windows.sv
// Idea    A window of 128 pixels that holds more than the SUs can is walked part by part (dopu_walks). Nothing but the
//         square for which nodes and Gaussians are tested, and the parts that a Gaussian comes for, depends on the
//         walk: the numbers of a Gaussian are relative to its window either way.
#pragma once

#include <cstdint>

#include "cpp_model/config.hpp"
#include "cpp_model/regions.hpp"

namespace pipegs {

inline constexpr uint64_t kWholeWalk = 0;

inline uint64_t walk_of(const Config& c, uint64_t square) { return uint64_t{1} << c.square_w() | square; }
inline uint64_t walk_part(const Config& c, uint64_t walk) { return walk & (static_cast<uint64_t>(c.squares()) - 1); }
inline bool walk_has(const Config& c, uint64_t walk, uint64_t part) {
  return walk == kWholeWalk || walk_part(c, walk) == part_square(c, part);
}

// First column and row of pixels in the window, and its side.
struct WalkSquare {
  int64_t x, y, side;
};

inline WalkSquare walk_square(const Config& c, uint64_t walk) {
  if (walk == kWholeWalk) return {0, 0, c.window};
  const auto part = static_cast<int64_t>(walk_part(c, walk));
  return {part % c.parts_x() * c.part_side(), part / c.parts_x() * c.part_side(), c.part_side()};
}

}  // namespace pipegs
