// SPDX-License-Identifier: Apache-2.0
// control_done.hpp: bit- and cycle-accurate model of rtl/control/control_done.sv.
//
// Idea    One number for all frames that wait: the writes that the youngest of them waits for. When it is 0 they are
//         told, one per cycle.
// RTL     rtl/control/control_done.sv
#pragma once

namespace pipegs {

class ControlDone {
 public:
  void reset() { *this = {}; }
  // writes: accepted and not answered before this cycle.
  void step(bool core_done, bool give_up, int writes, bool answered) {
    const int told = done(give_up);
    frames_ += core_done - told;
    if (core_done) {
      left_ = writes - answered;
    } else if (left_ > 0) {
      left_ -= answered;
    }
    if (give_up) frames_ = left_ = 0;
  }

  bool done(bool give_up) const { return waiting() && left_ == 0 && !give_up; }
  bool waiting() const { return frames_ > 0; }

 private:
  int frames_ = 0, left_ = 0;
};

}  // namespace pipegs
