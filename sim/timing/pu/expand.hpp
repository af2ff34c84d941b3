// SPDX-License-Identifier: Apache-2.0
// expand.hpp: from one Gaussian of the frame to one pair for each window that its box touches, in the timing model
// (order 1).
//
// RTL     rtl/pu/list/pu_expand.sv.
// Idea    Beats before it are survivors of the cull, beats behind it pairs (trace.hpp). A Gaussian waits in a queue for
//         its colour, then its pairs leave one per cycle; those whose window is passed over take one, too.
#pragma once

#include "cpp_model/config.hpp"
#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

struct Machine;

class Expand {
 public:
  explicit Expand(int lane) : lane_(lane) {}

  void step(Machine& m, Cycle now, Output<Beat>& conic);
  Output<Beat> out;

 private:
  const int lane_;
  bool give_ = false;  // BoxGive: the conic's box is known
  SramQueue<Beat, Config::expand_depth()> queue_;
  bool walking_ = false;
  uint32_t next_ = 0, end_ = 0;  // of the walk: pairs
};

}  // namespace pipegs::timing
