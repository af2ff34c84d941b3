// SPDX-License-Identifier: Apache-2.0
// parts.cpp: see parts.hpp.
#include "sim/timing/pu/parts.hpp"

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

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
    if (out.valid) return;  // pu_coeff wakes us
    emit(next_++);
    leaves = next_ == end_;
    walking_ = !leaves;
  } else if (is_end(beat)) {
    if (out.valid) return;
    emit(beat);
    leaves = true;
  } else {
    next_ = m.trace.pairs[beat];
    end_ = m.trace.pairs[beat + 1];
    leaves = next_ == end_;
    walking_ = !leaves;
  }
  if (walking_) m.wheel.wake(self, now + 1);
  if (!leaves) return;
  conic.valid = false;
  m.wheel.wake_now(unit(kConic, lane_));
}

}  // namespace pipegs::timing
