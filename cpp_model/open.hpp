// SPDX-License-Identifier: Apache-2.0
// open: the rectangle around the regions of a window that are still open, and what of a walk lies beside it.
//
// Paper   Sec. 4.2.3 stops work in regions that are opaque; here it is not begun either.        RTL  rtl/pipegs_open.sv
// Idea    Chunks come nearest first, so what is not blended yet lies behind all that closed a region. What touches no
//         open region changes no pixel, and what does not touch a rectangle around them touches none. The rectangle is
//         told by how many columns and rows of regions of a walk, from each side, hold none; 0 from all sides while
//         nothing is known: of another window, and where no region is open at all.
#pragma once

#include <algorithm>

#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/regions.hpp"

namespace pipegs {

// Of a walk, with these regions of its window closed.
inline Closed closed_of(const Config& c, const RegionSet& closed, uint64_t walk) {
  const WalkSquare square = walk_square(c, walk);
  const int x0 = static_cast<int>(square.x / 8), y0 = static_cast<int>(square.y / 8),
            side = static_cast<int>(square.side / 8);
  int left = side, right = side, top = side, bottom = side;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      bool all = true;  // eyes
      for (int eye = 0; eye < c.eyes; ++eye)
        all = all && (!walk_sees(c, walk, eye) || closed.has(c, region_at(c, x0 + x, y0 + y, eye)));
      if (all) continue;
      left = std::min(left, x), right = std::min(right, side - 1 - x);
      top = std::min(top, y), bottom = std::min(bottom, side - 1 - y);
    }
  }
  if (left == side) return {};
  const auto count = [](int n) { return static_cast<uint64_t>(n); };
  return {count(left), count(right), count(top), count(bottom)};
}

// Calls `visit` with what is said of a walk, a Closed or an EyeClosed.
template <class O, class Visit>
void visit_closed(const Config& c, O& open, uint64_t walk, Visit&& visit) {
  const int eye = walk_eye(c, walk);
  if (!walk_by_square(c, walk))
    return eye == kAllEyes ? visit(open.whole) : eye == 0 ? visit(open.eye_0) : visit(open.eye_1);
  switch (walk_part(c, walk)) {
    case 0: return visit(open.part_0);
    case 1: return visit(open.part_1);
    case 2: return visit(open.part_2);
    case 3: return visit(open.part_3);
    case 4: return visit(open.part_4);
    case 5: return visit(open.part_5);
    case 6: return visit(open.part_6);
    default: return visit(open.part_7);
  }
}
inline Closed walk_closed(const Config& c, const Open& open, uint64_t walk) {
  Closed closed;
  visit_closed(c, open, walk, [&](const auto& one) { closed = {one.left, one.right, one.top, one.bottom}; });
  return closed;
}
inline void close_walk(const Config& c, Open& open, uint64_t walk, const Closed& closed) {
  visit_closed(c, open, walk, [&](auto& one) { one = {closed.left, closed.right, closed.top, closed.bottom}; });
}

// What pipegs_open makes of a window that all RUs are in.
inline Open open_of(const Config& c, const RegionSet& closed, uint64_t window_x, uint64_t window_y) {
  Open open{.known = 1, .window_x = window_x, .window_y = window_y};
  for (const uint64_t walk : all_walks(c)) close_walk(c, open, walk, closed_of(c, closed, walk));
  return open;
}

// pipegs_closed: of a walk of a window.
inline Closed closed_at(const Config& c, const Open& open, uint64_t window_x, uint64_t window_y, uint64_t walk) {
  if (open.known == 0 || open.window_x != window_x || open.window_y != window_y) return {};
  return walk_closed(c, open, walk);
}

}  // namespace pipegs
