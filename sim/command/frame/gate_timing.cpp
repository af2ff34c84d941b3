// SPDX-License-Identifier: Apache-2.0
// gate_timing.cpp: see gate_timing.hpp.
#include "sim/command/frame/gate_timing.hpp"

#include <fmt/format.h>

#include "sim/timing/timing_model.hpp"

namespace pipegs {

GateTiming::GateTiming(const Simulation& simulation, SimulateOptions& options)
    : options_(options), trace_(timing_trace(simulation.input)), lockstep_(trace_, options.config, options.memory) {
  options.taps = &lockstep_;
}

void GateTiming::compare(Simulation& simulation) {
  lockstep_.finish();
  const uint64_t gates = simulation.rtl.cycles, rtl = timing_run(trace_, options_.config, options_.memory).cycles;
  const auto& first = lockstep_.first();
  if (gates == rtl && !first) return;
  std::string line = fmt::format("gates take {} cycles, RTL {} (by the timing model)", gates, rtl);
  if (first)
    line += fmt::format("; they part in cycle {}, {}: gates {}, RTL {}", first->cycle, first->unit, first->rtl,
                        first->model);
  ++simulation.mismatches;
  const auto& windows = simulation.input.frame.raster.windows;
  if (simulation.first_mismatch) simulation.first_mismatch->what += "; " + line;
  else
    simulation.first_mismatch = {.tap = Tap::kTime,
                                 .expected = fmt::to_string(rtl),
                                 .found = fmt::to_string(gates),
                                 .window_x = windows.first_x,
                                 .window_y = windows.first_y,
                                 .cycle = static_cast<int64_t>(first ? first->cycle : gates),
                                 .what = line};
}

}  // namespace pipegs
