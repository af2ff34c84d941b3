// SPDX-License-Identifier: Apache-2.0
// energy.hpp: energy of a frame in 28 nm, unit by unit: gates that switch, accesses of the SRAMs, leakage, bytes from
// DRAM.
//
// Idea    Clocks: `make synth` tells what the flip-flops behind each clock gate take for an edge, and what those
//         without one and the gates themselves take; waves tell how many edges pass each gate. Data: what a unit takes
//         when each net toggles once (switch_j), times the toggles of each bit of the unit's signals: the RTL's signals
//         stand for the nets between the gates. SRAMs: accesses times the law. DRAM: bytes.
// Rule    Energies cross from a library to 28 nm as multiples of C V^2 of one input of its NAND2: process.hpp.
// Trust   No wires, no clock tree, no glitches: docs/silicon/energy.md.
// Units   J for one frame, W. Ranges are of process.hpp; of SRAMs the least, median and most of the kinds of cells.
// Errors  InputError: synth.json or enables.json is of other RTL than the activity.
#pragma once

#include <string>
#include <vector>

#include "sim/silicon/energy/frame_activity.hpp"
#include "sim/silicon/silicon.hpp"

namespace pipegs {

struct EnergyRow {
  std::string name;      // DOPU, PU, SU, RU, Other, Buffers, Total, DRAM; Total is that of the chip
  Range frame_j = {};    // without leakage
  Range leakage_w = {};  // while the chip has power
  double awake = 0;      // share of the cycles in which a unit of the row has its clock; 0 where that says nothing
  double clocks_j = 0;   // of frame_j (mid): what flip-flops and clock gates take for their clock
  double ungated_j = 0;  // of clocks_j: flip-flops that no enable gates
  double gates_j = 0;    // of clocks_j: the clock gates themselves
  double open_j = 0;     // what the flip-flops behind gates would take if every edge passed
  uint64_t flipflops = 0, gated = 0, unseen = 0;  // of all units; behind a gate; of those, with an enable not seen

  double gated_j() const { return clocks_j - ungated_j - gates_j; }
  double halves_differ = 0;  // how far frame_j (mid) of the halves of the samples lie apart, as a share of it

  Range watts(double fps) const { return frame_j * fps + leakage_w; }
};
std::vector<EnergyRow> energy_rows(const Config& config, const Synth& synth, const Enables& enables, const SramLaw& law,
                                   const FrameActivity& activity);

// What the clocks of one module's own flip-flops take in a frame (mid), all its instances in a row; dearest first.
struct ModuleClocks {
  std::string row, module;
  double ungated_j = 0, gated_j = 0, gates_j = 0, open_j = 0;  // as in EnergyRow
  uint64_t flipflops = 0, gated = 0;

  double all_j() const { return ungated_j + gated_j + gates_j; }
};
std::vector<ModuleClocks> module_clocks(const Synth& synth, const Enables& enables, const FrameActivity& activity);

}  // namespace pipegs
