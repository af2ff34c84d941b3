// SPDX-License-Identifier: Apache-2.0
// parts.hpp: from one Gaussian of a window to one pair for each part that its box touches, in the timing model.
//
// RTL     rtl/pu/pu_parts.sv.
// Idea    Beats before it are survivors of the cull, beats behind it pairs (trace.hpp). The Gaussian stays where it is
//         until its last pair has left; pairs leave one per cycle.
#pragma once

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

struct Machine;

class Parts {
 public:
  explicit Parts(int lane) : lane_(lane) {}

  void step(Machine& m, Cycle now, Output<Beat>& conic);
  Output<Beat> out;

 private:
  const int lane_;
  bool walking_ = false;
  uint32_t next_ = 0, end_ = 0;  // of the walk: pairs
};

}  // namespace pipegs::timing
