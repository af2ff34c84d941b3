// SPDX-License-Identifier: Apache-2.0
// ranges.hpp: a rival's figures as ranges, every parameter that is not read in its paper over its range; and those of a
// machine of this project.
//
// Idea    Each parameter alone at both ends says which end helps which figure; then all at the ends that help, and all
//         at the ends that hurt. low and high are the least and the most of all these frames, with the area's ends in
//         frames/s/mm2.
// Ours    Cycles and bytes of the timing model, area, clock and energy of the frame model. The clock is 1 GHz, or less
//         where the longest path asks for it. Ranges are those of 28 nm (process.hpp). Gates and SRAMs alone: no clock
//         tree, wires and rings; what is published of others may have them.
// Units   Frames per second; mm2 of 28 nm; frames per joule of the chip alone, and with its DRAM at kDramPjPerBit.mid.
#pragma once

#include <string>
#include <vector>

#include "sim/silicon/frame_model.hpp"
#include "sim/studies/rivals/models/rival.hpp"
#include "sim/timing/cycle_engine.hpp"

namespace pipegs {

struct Figures {
  Range fps, fps_mm2, frames_j, frames_j_dram;
};

struct Swing {  // of one parameter alone
  const Parameter* parameter;
  double fps_low, fps_high;            // with the parameter at its low, at its high
  double frames_j_low, frames_j_high;  // of the chip with its DRAM
};

struct RivalResult {
  const Rival* rival;
  MachineFrame frame;  // all parameters at their values
  Range mm2;           // in 28 nm
  Figures figures;
  std::vector<Swing> swings;
};
RivalResult rival_result(const Rival& rival, const FrameCounts& counts, PlayedMemory& memory);

struct OwnMachine {
  std::string name;
  double ghz = 1, cycles = 0, bytes = 0;
  Range mm2;
  Figures figures;
};

// Throws ConfigError for a machine whose area the model does not know.
OwnMachine own_machine(const std::string& name, const Config& config, const EngineResult& frame,
                       const FrameModel& model);

// 0 of a frame that takes no energy.
double frames_per_joule_with_dram(const MachineFrame& frame);

// a / b of two ranges that know nothing of each other.
Range ratio(const Range& a, const Range& b);

}  // namespace pipegs
