// SPDX-License-Identifier: Apache-2.0
// dopu_item.hpp: what moves inside the DOPU of the timing model, and what its parts share in a cycle.
#pragma once

#include <array>

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

// A set of planes: a walk.
struct DopuSet {
  bool valid = false, fresh = false, done = false;
  bool judges = false, given_up = false;  // on trial; this is how it ended
  size_t walk = 0;                        // of TimingTrace::walks
  size_t chunk = 0;                       // of its chunks that pass, the next one to enter the test (orders 0 and 1)
  Closed closed, closed_before;           // Occlusion: of its walk, in its planes; and before `closed_from`
  Cycle closed_from = 0;
};

// Whether a node passes that entered the test so long ago that its planes were those of these cycles: RTL
// rtl/dopu/dopu_test.sv.
inline bool passes(TimingSides sides, const DopuSet& set, Cycle entered) {
  const auto side = [&](int number, Cycle when, uint64_t Closed::*count) {
    const Closed& closed = when < set.closed_from ? set.closed_before : set.closed;
    return (sides >> (16 * number + static_cast<int>(closed.*count)) & 1) != 0;
  };
  return side(0, entered + 8, &Closed::left) && side(1, entered + 9, &Closed::right) &&
         side(2, entered + 9, &Closed::top) && side(3, entered + 10, &Closed::bottom);
}

using DopuSets = std::array<DopuSet, 2>;

// A cycle of the unit.
struct DopuCycle {
  Cycle now = 0;
  int phase = 0;                    // of the box test: a node enters in every third cycle
  int granted = -1, answered = -1;  // whose request, whose line: 0 groups, 1 chunks, 2 the table of cells
  const DopuItem* cell = nullptr;   // that the walk of the cells shows
  bool cell_taken = false;
  bool node_taken = false;             // dopu_origin takes what is shown
  bool judged = false, split = false;  // the trial is over; it is given up
  bool moved = false;                  // as the unit's clock counts it: it runs on
  bool changed = false;                // a register changed: the next cycle must be played
  Cycle next = kNever;                 // what comes by itself

  void at(Cycle when) { next = when < next ? when : next; }
};

}  // namespace pipegs::timing
