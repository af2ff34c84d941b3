// SPDX-License-Identifier: Apache-2.0
// expand.hpp: from one Gaussian to one pair for each place that its box touches, in the timing model: for each window
// of the frame (Expand, order 1), or for each part of a window (Parts).
//
// RTL     rtl/pu/list/pu_expand.sv, rtl/pu/pu_parts.sv.
// Idea    Beats before it are survivors of the cull, beats behind it pairs (trace.hpp), which leave one per cycle.
#pragma once

#include "cpp_model/config.hpp"
#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

struct Machine;

// A Gaussian waits in a queue for its colour; a pair whose window is passed over takes a cycle, too.
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

// The Gaussian stays where it is until its last pair has left.
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
