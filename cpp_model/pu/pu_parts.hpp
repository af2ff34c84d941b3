// SPDX-License-Identifier: Apache-2.0
// pu_parts: from one Gaussian of a window to one beat for each part of the window that its box touches.
//
// Paper   Sec. 4.2: the paper's windows have one part.
// Idea    A larger window fetches, culls and projects a Gaussian once for four windows of the old size; behind that the
//         mean is moved to the first pixel of each part, exactly, and saturated as pu_project does it in a window of
//         that size: the beat is bit for bit what a machine with windows as large as the part has there. Where one
//         part is walked it has no beat in the others.
// RTL     rtl/pu/pu_parts.sv
#pragma once

#include <vector>

#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/pu_span.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

struct PuPart {
  Conic conic;  // mean relative to the part's first pixel
  uint64_t part = 0;
};

// Row by row those of the walk, in an eye's picture; none for a Gaussian whose box touches none. With one square the
// Gaussian as it is.
inline std::vector<PuPart> pu_parts(const Config& c, const Conic& conic, uint64_t walk = kWholeWalk, uint64_t eye = 0) {
  if (c.squares() == 1) return {{conic, eye}};
  const int side = c.part_side(), to_mean = clog2(side) + c.mean_f;
  const std::optional<PuSpan> xs = pu_span(c, conic.mean_x, conic.extent_x, side, c.parts_x() - 1),
                              ys = pu_span(c, conic.mean_y, conic.extent_y, side, c.parts_x() - 1);
  std::vector<PuPart> parts;
  if (!xs || !ys) return parts;
  for (int64_t y = ys->first; y <= ys->last; ++y) {
    for (int64_t x = xs->first; x <= xs->last; ++x) {
      const uint64_t part = eye * static_cast<uint64_t>(c.squares()) + static_cast<uint64_t>(y * c.parts_x() + x);
      if (!walk_has(c, walk, part)) continue;
      parts.push_back({conic, part});
      PuPart& one = parts.back();
      one.conic.mean_x = saturate(conic.mean_x - (x << to_mean), c.window_mean_w());
      one.conic.mean_y = saturate(conic.mean_y - (y << to_mean), c.window_mean_w());
    }
  }
  return parts;
}

}  // namespace pipegs
