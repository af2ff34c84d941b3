// SPDX-License-Identifier: Apache-2.0
// walk: what the DOPU walks the scene for at a time: a window, one part of it, or either for one of two eyes.
//
// Paper   None: the paper walks windows.        RTL  rtl/dopu/dopu_windows.sv
// Idea    A window of 128 pixels that holds more than the SUs can is walked part by part, and one that holds more of
//         two eyes is walked for each eye alone (dopu_walks). Nothing but the square and the eyes for which nodes and
//         Gaussians are tested, and the parts that a Gaussian comes for, depends on the walk: the numbers of a Gaussian
//         are relative to its window either way.
// Format  {of one square, square, of one eye, eye}; the last two only with two eyes, the first two only where windows
//         have squares. 0: of all.
#pragma once

#include <cstdint>
#include <vector>

#include "cpp_model/config.hpp"
#include "cpp_model/regions.hpp"

namespace pipegs {

inline constexpr uint64_t kWholeWalk = 0;
inline constexpr int kAllEyes = -1;

// Of the whole window for one eye; of a part.
inline uint64_t walk_of_eye(const Config& c, int eye) {
  return c.eyes > 1 ? uint64_t{1} << c.eye_w() | static_cast<uint64_t>(eye) : kWholeWalk;
}
inline uint64_t walk_of(const Config& c, uint64_t part) {
  return (uint64_t{1} << c.square_w() | part_square(c, part)) << c.walk_eye_w() |
         walk_of_eye(c, part_eye(c, static_cast<int>(part)));
}

inline bool walk_by_square(const Config& c, uint64_t walk) { return walk >> (c.walk_eye_w() + c.square_w()) != 0; }
inline int walk_eye(const Config& c, uint64_t walk) {
  if (c.eyes == 1 || (walk >> c.eye_w() & 1) == 0) return kAllEyes;
  return static_cast<int>(walk & ((uint64_t{1} << c.eye_w()) - 1));
}
inline bool walk_sees(const Config& c, uint64_t walk, int eye) {
  return walk_eye(c, walk) == kAllEyes || walk_eye(c, walk) == eye;
}
// The part of one that has no more.
inline uint64_t walk_part(const Config& c, uint64_t walk) {
  const uint64_t square = walk >> c.walk_eye_w() & (static_cast<uint64_t>(c.squares()) - 1);
  return walk_eye(c, walk) <= 0 ? square : static_cast<uint64_t>(c.squares()) + square;
}
inline bool walk_has(const Config& c, uint64_t walk, uint64_t part) {
  return walk_sees(c, walk, part_eye(c, static_cast<int>(part))) &&
         (!walk_by_square(c, walk) || part_square(c, walk_part(c, walk)) == part_square(c, part));
}

// All that a window might have.
inline std::vector<uint64_t> all_walks(const Config& c) {
  std::vector<uint64_t> walks = {kWholeWalk};
  if (!c.has_walks()) return walks;
  for (int eye = 0; c.eyes > 1 && eye < c.eyes; ++eye) walks.push_back(walk_of_eye(c, eye));
  for (uint64_t part = 0; part < static_cast<uint64_t>(c.parts()); ++part) walks.push_back(walk_of(c, part));
  return walks;
}

// First column and row of pixels in the window, and its side.
struct WalkSquare {
  int64_t x, y, side;
};

inline WalkSquare walk_square(const Config& c, uint64_t walk) {
  if (!walk_by_square(c, walk)) return {0, 0, c.window};
  const auto square = static_cast<int64_t>(part_square(c, walk_part(c, walk)));
  return {square % c.parts_x() * c.part_side(), square / c.parts_x() * c.part_side(), c.part_side()};
}

}  // namespace pipegs
