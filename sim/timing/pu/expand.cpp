// SPDX-License-Identifier: Apache-2.0
// expand.cpp: see expand.hpp.
#include "sim/timing/pu/expand.hpp"

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void Expand::step(Machine& m, Cycle now, Output<Beat>& conic) {
  Color& color = m.pu[static_cast<size_t>(lane_)].color;
  const int self = unit(kExpand, lane_);

  // The walk.
  const bool out_free = !out.valid;
  const auto emit = [&](Beat beat) {
    out.set(now + 1, beat);
    m.wheel.wake(unit(kCoeff, lane_), now + 1);
    m.wheel.wake(self, now + 1);
  };
  if (walking_) {
    const bool passed = m.trace.passed[next_] != 0;
    if (out_free || passed) {
      if (passed) m.wheel.wake(self, now + 1);
      else emit(next_);
      if (++next_ == end_) {
        walking_ = false;
        queue_.pop(now);
        color.taken(m, now);
      }
    }
  } else if (color.shown(now)) {
    if (is_end(color.out.value.beat)) {
      if (out_free) emit(color.out.value.beat), color.taken(m, now);
    } else if (queue_.valid(now)) {
      walking_ = true;
      next_ = m.trace.pairs[queue_.front()];
      end_ = m.trace.pairs[queue_.front() + 1];
      m.wheel.wake(self, now + 1);
    }
  }
  if (!walking_) m.wheel.wake(self, queue_.head_from());

  // The box.
  if (!conic.shown(now)) return;
  const Beat beat = conic.value;
  if (!give_) {
    give_ = true;
    m.wheel.wake(self, now + 1);
    return;
  }
  const bool data = !is_end(beat), none = data ? m.trace.pairs[beat] == m.trace.pairs[beat + 1] : beat == kLayerEndBeat;
  if (!none) {
    if ((data && !queue_.room(now)) || !color.room(now)) return m.wheel.wake(self, now + 1);
    Splat splat;
    splat.beat = beat;
    color.push(m, now, splat);
    if (data) queue_.push(now, beat);
  }
  give_ = false;
  conic.valid = false;
  m.wheel.wake_now(unit(kConic, lane_));
}

void Parts::step(Machine& m, Cycle now, Output<Beat>& conic) {
  if (!conic.shown(now)) return;
  const int self = unit(kExpand, lane_);
  const Beat beat = conic.value;
  bool leaves = false;
  const auto emit = [&](Beat pair) {
    out.set(now + 1, pair);
    m.wheel.wake(unit(kCoeff, lane_), now + 1);
  };
  if (walking_) {
    if (next_ != end_) {
      if (out.valid) return;  // pu_coeff wakes us
      emit(next_++);
    }
    leaves = next_ == end_;
    walking_ = !leaves;
  } else if (is_end(beat)) {
    if (out.valid) return;
    emit(beat);
    leaves = true;
  } else {
    next_ = m.trace.pairs[beat];
    end_ = m.trace.pairs[beat + 1];
    walking_ = true;
  }
  if (walking_) m.wheel.wake(self, now + 1);
  if (!leaves) return;
  conic.valid = false;
  m.wheel.wake_now(unit(kConic, lane_));
}

}  // namespace pipegs::timing
