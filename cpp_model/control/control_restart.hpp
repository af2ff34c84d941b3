// SPDX-License-Identifier: Apache-2.0
// control_restart.hpp: bit- and cycle-accurate model of rtl/control/pipegs_control_restart.sv.
//
// Idea    The core is kept apart from the cycle after a give-up, in reset from the one behind it until the epoch has
//         turned and `cycles` more have passed, and apart for as many again. A reset of the whole machine ends in the
//         same way, but the epoch has nothing to turn from.
// RTL     rtl/control/pipegs_control_restart.sv
#pragma once

#include "cpp_model/config.hpp"

namespace pipegs {

class ControlRestart {
 public:
  explicit ControlRestart(int cycles = Config::reset_cycles()) : cycles_(cycles) { reset(); }
  void reset() {
    step_ = Step::kTurned, left_ = cycles_;
    epoch_ = false;
  }
  void step(bool give_up, bool drained) {
    switch (step_) {
      case Step::kRun:
        if (give_up) step_ = Step::kApart;
        break;
      case Step::kApart: step_ = Step::kStop; break;
      case Step::kStop:
        if (drained) step_ = Step::kTurned, left_ = cycles_, epoch_ = !epoch_;
        break;
      case Step::kTurned:
        if (--left_ == 0) step_ = Step::kFree, left_ = cycles_;
        break;
      case Step::kFree:
        if (--left_ == 0) step_ = Step::kRun;
        break;
    }
  }

  bool epoch() const { return epoch_; }
  bool apart() const { return step_ != Step::kRun; }
  bool core_reset() const { return step_ == Step::kStop || step_ == Step::kTurned; }
  bool ready(bool give_up) const { return !apart() && !give_up; }

 private:
  enum class Step { kRun, kApart, kStop, kTurned, kFree };
  int cycles_, left_ = 0;
  Step step_ = Step::kTurned;
  bool epoch_ = false;
};

}  // namespace pipegs
