// SPDX-License-Identifier: Apache-2.0
// control_restart.hpp: bit- and cycle-accurate model of rtl/control/pipegs_control_restart.sv.
//
// Idea    The core is in reset from the cycle after a give-up until the epoch has turned, and one cycle more. A reset
//         of the whole machine ends in the same way, but the epoch has nothing to turn from.
// RTL     rtl/control/pipegs_control_restart.sv
#pragma once

namespace pipegs {

class ControlRestart {
 public:
  void reset() { *this = {}; }
  void step(bool give_up, bool drained) {
    if (running_) {
      running_ = !give_up;
      turned_ = false;
    } else if (turned_) {
      running_ = true;
    } else if (drained) {
      epoch_ = !epoch_;
      turned_ = true;
    }
  }

  bool epoch() const { return epoch_; }
  bool core_reset() const { return !running_; }
  bool ready(bool give_up) const { return running_ && !give_up; }

 private:
  bool running_ = false, turned_ = true, epoch_ = false;
};

}  // namespace pipegs
