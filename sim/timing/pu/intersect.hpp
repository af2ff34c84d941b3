// SPDX-License-Identifier: Apache-2.0
// intersect.hpp: a PU's regions in the timing model: which cycle a Gaussian's mask is there.
//
// RTL     rtl/pu/conic/pu_intersect.sv: one record is set up, one walks the regions of its box, of one the last region
//         is being tested; at a pace of four cycles the box of the next is made while one is placed, and two are being
//         tested. A result that finds no room holds walk and tests.
#pragma once

#include <algorithm>
#include <array>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

class Intersect {
 public:
  explicit Intersect(bool ahead) : ahead_(ahead) {}

  // A cycle with the record at the input, or null: tells whether it was taken. `mask`, `boxes`: by pair, see
  // TimingTrace.
  template <class Trace>
  bool step(Cycle now, const Beat* in, Output<Beat>& out, const Trace& trace) {
    const bool empty = !placing_ && !walking_ && tested_ == 0, out_free = !out.valid;
    const bool hold = tested_ > 0 && now >= tests_[0].at && !out_free;
    if (tested_ > 0 && now >= tests_[0].at && out_free) {
      const Test test = tests_[0];
      tests_[0] = tests_[1];
      --tested_;
      if (trace.mask[test.beat] != 0) out.set(now + 1, test.beat);
      // Walk and tests stood still while the result waited.
      if (tested_ > 0) tests_[0].at += now - test.at;
      if (walking_) walk_last_ += std::max<Cycle>(0, now - std::max(test.at, walk_first_));
    }
    if (walking_ && !hold && now >= walk_last_ && tested_ < (ahead_ ? 2 : 1)) {
      walking_ = false;
      tests_[static_cast<size_t>(tested_++)] = {walk_, now + kTest};
    }
    if (placing_ && now >= place_at_ && !walking_) {
      placing_ = false;
      walking_ = true;
      walk_ = place_;
      walk_first_ = now + 1;
      walk_last_ = now + trace.boxes[place_];
      if (!ahead_) return taken(now);
    }
    if (in == nullptr || now < box_from_) return false;
    const Beat beat = *in;
    if (is_end(beat)) {
      if (!empty || !out_free) return false;
      out.set(now + 1, beat);
      return taken(now);
    }
    if (!boxed_ && !placing_) {
      boxed_ = true;
      start_at_ = now + 1;
    }
    if (!boxed_ || now < start_at_) return false;
    boxed_ = false;
    const bool none = trace.boxes[beat] == 0;
    if (!none) placing_ = true, place_ = beat, place_at_ = now + 1;
    return (none || ahead_) && taken(now);
  }

  // When something happens by itself; what waits for room at the output or for a record is not counted.
  Cycle next(Cycle now) const {
    Cycle when = kNever;
    const auto at = [&](Cycle cycle) {
      if (cycle > now) when = std::min(when, cycle);
    };
    for (int i = 0; i < tested_; ++i) at(tests_[static_cast<size_t>(i)].at);
    if (walking_) at(walk_last_);
    if (boxed_) at(start_at_);
    if (placing_) at(place_at_);
    return when;
  }

 private:
  static constexpr Cycle kTest = 3;  // of pu_edge
  struct Test {
    Beat beat = 0;
    Cycle at = 0;  // the verdict on its last region
  };
  bool taken(Cycle now) {
    box_from_ = now + 1;
    return true;
  }

  const bool ahead_;
  bool boxed_ = false, placing_ = false, walking_ = false;
  Beat place_ = 0, walk_ = 0;
  Cycle box_from_ = kLongAgo, start_at_ = 0, place_at_ = 0;
  Cycle walk_first_ = 0, walk_last_ = 0;  // of its regions, the last one
  std::array<Test, 2> tests_;             // the oldest first
  int tested_ = 0;
};

}  // namespace pipegs::timing
