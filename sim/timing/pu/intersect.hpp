// SPDX-License-Identifier: Apache-2.0
// intersect.hpp: a PU's regions in the timing model: which cycle a Gaussian's mask is there.
//
// RTL     rtl/pu/conic/pu_intersect.sv: three records inside at once: one is set up, one walks the regions of its box,
//         of one the last region is being tested. A result that finds no room holds walk and test.
#pragma once

#include <algorithm>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

class Intersect {
 public:
  // A cycle with the record at the input, or null: tells whether it was taken. `mask`, `boxes`: by pair, see
  // TimingTrace.
  template <class Trace>
  bool step(Cycle now, const Beat* in, Output<Beat>& out, const Trace& trace) {
    const bool empty = !walking_ && !testing_, out_free = !out.valid;
    if (testing_ && now >= test_at_ && out_free) {
      testing_ = false;
      if (trace.mask[test_] != 0) out.set(now + 1, test_);
      // The walk stood still while the result waited.
      if (walking_) walk_last_ += std::max<Cycle>(0, now - std::max(test_at_, walk_first_));
    }
    if (walking_ && now >= walk_last_ && !testing_) {
      walking_ = false;
      testing_ = true;
      test_ = walk_;
      test_at_ = now + kTest;
    }
    if (in == nullptr || now < box_from_) return false;
    const Beat beat = *in;
    if (is_end(beat)) {
      if (!empty || !out_free) return false;
      out.set(now + 1, beat);
    } else {
      const int boxes = trace.boxes[beat];
      if (!placed_) {  // the box is made now
        placed_ = true;
        place_at_ = now + (boxes == 0 ? 1 : 2);
      }
      if (now < place_at_ || (boxes != 0 && walking_)) return false;
      placed_ = false;
      if (boxes != 0) {
        walking_ = true;
        walk_ = beat;
        walk_first_ = now + 1;
        walk_last_ = now + boxes;
      }
    }
    box_from_ = now + 1;
    return true;
  }

  // When something happens by itself; what waits for room at the output or for a record is not counted.
  Cycle next(Cycle now) const {
    Cycle when = kNever;
    const auto at = [&](Cycle cycle) {
      if (cycle > now) when = std::min(when, cycle);
    };
    if (testing_) at(test_at_);
    if (walking_) at(walk_last_);
    if (placed_) at(place_at_);
    return when;
  }

 private:
  static constexpr Cycle kTest = 3;  // of pu_edge

  bool placed_ = false, walking_ = false, testing_ = false;
  Beat walk_ = 0, test_ = 0;
  Cycle box_from_ = kLongAgo, place_at_ = 0;
  Cycle walk_first_ = 0, walk_last_ = 0;  // of its regions, the last one
  Cycle test_at_ = 0;                     // the verdict on the last region
};

}  // namespace pipegs::timing
