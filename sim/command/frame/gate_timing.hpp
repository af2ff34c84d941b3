// SPDX-License-Identifier: Apache-2.0
// gate_timing.hpp: gates beside the timing model, which takes what the RTL takes, event by event and cycle by cycle.
//
// Why     Any order of chunks gives the same pixels, and the same beats behind the sort. Gates that lose the depth of a
//         chunk differ from the RTL in time alone.
#pragma once

#include "sim/compare/simulate.hpp"
#include "sim/timing/lockstep.hpp"

namespace pipegs {

class GateTiming {
 public:
  // The golden model has run. `options` and `simulation` outlive this; the lockstep sees what the machine shows.
  GateTiming(const Simulation& simulation, SimulateOptions& options);

  // When the machine has run: other events or cycles are one more mismatch of `simulation`.
  void compare(Simulation& simulation);

 private:
  const SimulateOptions& options_;
  const TimingTrace trace_;
  Lockstep lockstep_;
};

}  // namespace pipegs
