// SPDX-License-Identifier: Apache-2.0
// ours.hpp: a machine of this project in the rivals' table: cycles and bytes of the timing model, area, clock and
// energy of the frame model.
//
// Rule    The clock is 1 GHz, or less where the longest path asks for it. Ranges are those of 28 nm (process.hpp).
//         Gates and SRAMs alone: no clock tree, wires and rings; what is published of others may have them.
#pragma once

#include "sim/studies/rivals/compare/ranges.hpp"
#include "sim/silicon/frame_model.hpp"
#include "sim/timing/cycle_engine.hpp"

namespace pipegs {

struct OwnMachine {
  std::string name;
  double ghz = 1, cycles = 0, bytes = 0;
  Range mm2;
  Figures figures;
};

// Throws ConfigError for a machine whose area the model does not know.
OwnMachine own_machine(const std::string& name, const Config& config, const EngineResult& frame,
                       const FrameModel& model);

}  // namespace pipegs
