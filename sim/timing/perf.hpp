// perf.hpp: how a unit of the timing model spent its cycles.
//
// RTL     rtl/perf.sv.
// Idea    A state holds from the cycle in which it is said until the next one is said.
#pragma once

#include <array>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

enum PerfState : uint8_t { kBusy, kStarved, kBlocked, kMemoryWait };

class Perf {
 public:
  void set(Cycle now, PerfState state) {
    if (now > since_) counts_[state_] += static_cast<uint64_t>(now - since_), since_ = now;
    state_ = state;
  }
  uint64_t count(PerfState state) const { return counts_[state]; }

 private:
  std::array<uint64_t, 4> counts_{};
  PerfState state_ = kStarved;
  Cycle since_ = 1;
};

}  // namespace pipegs::timing
