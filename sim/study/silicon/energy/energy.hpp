// SPDX-License-Identifier: Apache-2.0
// energy.hpp: energy of a frame in 28 nm, unit by unit: gates that switch, accesses of the SRAMs, leakage, bytes from
// DRAM.
//
// Idea    Gates: `make synth` tells what a clocked cycle of a unit takes while no data changes (clock_j) and what it
//         takes more when each net toggles once (switch_j). A frame has so many clocked cycles, and so many toggles for
//         each bit of the unit's signals: the RTL's signals stand for the nets between the gates. SRAMs: accesses times
//         the law. DRAM: bytes.
// Rule    Energies cross from a library to 28 nm as multiples of C V^2 of one input of its NAND2: process.hpp.
// Trust   No wires, no clock tree, no glitches: docs/silicon/energy.md.
// Units   J for one frame, W. Ranges are of process.hpp; of SRAMs the least, median and most of the kinds of cells.
// Errors  InputError: synth.json is of other RTL than the activity.
#pragma once

#include <string>
#include <vector>

#include "sim/study/silicon/energy/frame_activity.hpp"
#include "sim/study/silicon/silicon.hpp"

namespace pipegs {

struct EnergyRow {
  std::string name;          // DOPU, PU, SU, RU, Other, Buffers, Total, DRAM; Total is that of the chip
  Range frame_j = {};        // without leakage
  Range leakage_w = {};      // while the chip has power
  double awake = 0;          // share of the cycles in which a unit of the row has its clock; 0 where that says nothing
  double clocks_j = 0;       // of frame_j (mid): what clocked cycles take in which no data changes
  double halves_differ = 0;  // how far frame_j (mid) of the halves of the samples lie apart, as a share of it

  Range watts(double fps) const { return frame_j * fps + leakage_w; }
};
std::vector<EnergyRow> energy_rows(const Config& config, const Synth& synth, const SramLaw& law,
                                   const FrameActivity& activity);

}  // namespace pipegs
