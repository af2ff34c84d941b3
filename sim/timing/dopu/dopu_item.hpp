// SPDX-License-Identifier: Apache-2.0
// dopu_item.hpp: what moves inside the DOPU of the timing model, and what its parts share in a cycle.
#pragma once

#include <algorithm>
#include <array>

#include "sim/timing/knobs.hpp"

#include "sim/timing/cycle.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs::timing {

// A node on one of the levels (cell, group, chunk), or an end.
struct DopuItem {
  Beat end = 0;
  uint8_t set = 0;
  bool last = false;  // the end of the frame's last window
  uint32_t node = 0;
  uint32_t mark = 0;                   // watermark of a layer's end, a depth (order 2)
  const TimingChunk* chunk = nullptr;  // of a chunk that passed
  bool data() const { return !is_end(end); }
};

// A set of planes: a window that is walked.
struct DopuSet {
  bool valid = false, fresh = false, last = false, done = false;
  size_t window = 0;  // a walk
  RegionSet open, raw;
  size_t chunk = 0;  // of the window's chunks that pass, the next one to enter the test (orders 0 and 1)
};

// The rectangle around the open regions: of the window (1), of each part (2).
inline RegionSet around(const Config& c, const RegionSet& open, int kind) {
  if (kind == 0) return open;
  RegionSet result;
  for (int p = kind == 2 ? 0 : -1; p < (kind == 2 ? c.parts() : 0); ++p) {
    int x0 = 99, x1 = -1, y0 = 99, y1 = -1;
    for (int r = 0; r < c.regions(); ++r) {
      if (!open.has(c, r) || (p >= 0 && region_part(c, r) != p)) continue;
      x0 = std::min(x0, region_x(c, r)), x1 = std::max(x1, region_x(c, r));
      y0 = std::min(y0, region_y(c, r)), y1 = std::max(y1, region_y(c, r));
    }
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) result.add(c, region_at(c, x, y));
  }
  return result;
}

using DopuSets = std::array<DopuSet, 2>;

// A cycle of the unit.
struct DopuCycle {
  Cycle now = 0;
  int phase = 0;                    // of the box test: a node enters in every third cycle
  int granted = -1, answered = -1;  // whose request, whose line: 0 groups, 1 chunks, 2 the table of cells
  const DopuItem* cell = nullptr;   // that the walk of the cells shows
  bool cell_taken = false;
  bool node_taken = false;  // dopu_origin takes what is shown
  bool moved = false;       // as the unit's clock counts it: it runs on
  bool changed = false;     // a register changed: the next cycle must be played
  Cycle next = kNever;      // what comes by itself

  void at(Cycle when) { next = when < next ? when : next; }
};

}  // namespace pipegs::timing
