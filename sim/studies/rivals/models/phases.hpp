// SPDX-License-Identifier: Apache-2.0
// phases.hpp: a frame of any machine as phases one after the other, each with its traffic and its items in a pipeline.
//
// Idea    In a phase, items (blocks of Gaussians, tiles, groups of pixels) go through memory and then through units.
//         The phase's flows are played through the DRAM model once (traffic.hpp); an item holds memory for its
//         share of that time. Items enter a stage in order, each at the unit that is free first. Two items of each unit
//         lie between a stage and the next (double buffers): a stage begins an item only when the next one has begun
//         the one that many before it.
// Rule    What bounds a phase is the stage whose units are busiest; what bounds a frame is what bounds most of its
//         cycles. Latencies of single accesses and of the pipelines inside units are nothing beside a frame, and left
//         out: in every machine's favour.
// Units   Cycles of the machine's clock; bytes over the pins; joules.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/studies/rivals/models/traffic.hpp"
#include "sim/silicon/process.hpp"

namespace pipegs {

// What was played is kept: a phase whose flows do not change is played once.
class PlayedMemory {
 public:
  explicit PlayedMemory(std::string dram) : dram_(std::move(dram)) {}  // as of play_traffic()
  const Traffic& play(const std::vector<Flow>& flows, double ghz);
  const std::string& dram() const { return dram_; }

 private:
  std::string dram_;
  std::map<std::string, Traffic> played_;
};

struct UnitStage {
  std::string unit;
  int units = 1;
  std::vector<double> cycles;  // of each item, on one unit
};

struct Phase {
  std::string name;
  std::vector<Flow> flows;
  std::vector<double> shares;  // of each item in the phase's bytes, in any unit
  std::vector<UnitStage> stages;
};

struct StageSpan {  // for a timeline
  std::string phase, unit;
  int units = 1;
  double begin = 0, end = 0, busy = 0;  // busy: summed over the units
};

struct MachineFrame {
  double ghz = 1, cycles = 0;
  std::vector<StageSpan> spans = {};         // phase by phase, memory first
  std::map<std::string, double> bytes = {};  // by kind of flow
  double memory_cycles = 0;                  // in which memory is busy
  std::string bound = {};                    // a unit or "memory"
  double bound_share = 0;                    // of the cycles that it bounds
  double chip_joules = 0;                    // published power for the time of the frame
  Range dram_joules = {};                    // bytes over the pins, by kDramPjPerBit

  double seconds() const { return cycles / ghz * 1e-9; }
  double fps() const { return cycles > 0 ? 1 / seconds() : 0; }
  double all_bytes() const;
  double busy(const std::string& unit) const;  // summed over units and phases
};

// All items alike: `gaussians` through units that each take `per_cycle` of them in a cycle.
Phase even_phase(const std::string& name, const std::vector<Flow>& flows, double gaussians, const std::string& unit,
                 int units, double per_cycle);

// Throws std::invalid_argument when a stage has no unit, a negative time, or not one time for each item.
MachineFrame run_phases(const std::vector<Phase>& phases, double ghz, double watts, PlayedMemory& memory);

// Passes of a splitter by `ways` pivots until a list of n has parts of at most `chunk`.
int split_levels(double n, double chunk = 16, double ways = 8);
double ceil_div(double n, double by);

}  // namespace pipegs
