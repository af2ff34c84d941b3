// SPDX-License-Identifier: Apache-2.0
// control_watch.hpp: bit- and cycle-accurate model of rtl/control/pipegs_control_watch.sv.
//
// Idea    Cycles in which something is owed and nothing moves are counted; as many as the limit said when the count
//         began are silence, and the count begins anew.
// RTL     rtl/control/pipegs_control_watch.sv
#pragma once

#include <cstdint>

namespace pipegs {

class ControlWatch {
 public:
  void step(uint32_t limit, bool waits, bool moves) {
    const bool still = waits && !moves && limit != 0, counts = still && limit_ != 0;
    count_ = counts ? count_ + 1 : 0;
    tell_ = counts && count_ == limit_;
    if (!counts || tell_) count_ = 0, limit_ = limit;
    silent_ = still && (silent_ || tell_);
  }

  bool tell() const { return tell_; }
  bool silent() const { return silent_; }

 private:
  uint32_t count_ = 0, limit_ = 0;
  bool tell_ = false, silent_ = false;
};

}  // namespace pipegs
