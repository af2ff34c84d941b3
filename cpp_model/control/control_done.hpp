// SPDX-License-Identifier: Apache-2.0
// control_done.hpp: bit- and cycle-accurate model of rtl/control/pipegs_control_done.sv.
//
// Idea    Frames that wait stand in two groups. The older group waits for the writes of its youngest and takes nobody
//         in; the younger one takes in every frame that ends, and becomes the older one when that has been reported.
// RTL     rtl/control/pipegs_control_done.sv
#pragma once

namespace pipegs {

class ControlDone {
 public:
  void reset() { *this = {}; }
  // writes: accepted and not answered before this cycle.
  void step(bool core_done, bool give_up, int writes, bool answered) {
    older_.frames -= done(give_up);
    for (Group* group : {&older_, &younger_}) group->left -= answered && group->left > 0;
    if (core_done) younger_ = {younger_.frames + 1, writes - answered};
    if (older_.frames == 0) {
      older_ = younger_;
      younger_.frames = 0;
    }
    if (give_up) *this = {};
  }

  bool done(bool give_up) const { return waiting() && older_.left == 0 && !give_up; }
  bool waiting() const { return older_.frames > 0; }

 private:
  struct Group {
    int frames = 0, left = 0;  // writes that must be answered first
  };
  Group older_, younger_;
};

}  // namespace pipegs
