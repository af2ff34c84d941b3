// SPDX-License-Identifier: Apache-2.0
// rival.hpp: what a model of another accelerator is: what its paper prints, what it does not and is assumed, and a
// frame from the counts of a view.
//
// Idea    A model holds no view and no memory: `frame` takes counts, a value for each parameter and the memory. All
//         machines render the view of the counts, with the same memory.
// Marks   Where a value is from: H read in the paper or in its own simulator, M in notes about it or in another one's
//         simulator, L assumed. A value of mark H has no range; one of M or L has none where it is a published figure
//         or where another parameter's range stands for both (cores for lanes).
// Units   mm2 in the published node, W at full speed without DRAM, GHz. Cycles are those of the machine's own clock.
// Errors  std::invalid_argument: a parameter that the model has not, or a value outside of its limits.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/studies/rivals/counts.hpp"
#include "sim/studies/rivals/models/phases.hpp"
#include "sim/silicon/process.hpp"

namespace pipegs {

enum class Mark { kRead, kNoted, kAssumed };
inline char letter(Mark mark) { return "HML"[static_cast<int>(mark)]; }

struct Parameter {
  std::string name;
  double value, low, high;  // low <= value <= high; which end is the faster one is measured
  std::string unit;
  Mark mark;
  std::string source;  // what it is, and where the value is from
};

// What another node's square micrometre is in 28 nm.
struct TechNode {
  std::string name;
  double nm;
  Range nand2_um2;  // of its NAND2; 28 nm: that of process.hpp, mid
  std::string source;

  double plain() const { return (28 / nm) * (28 / nm); }  // by the square of the node
  // By NAND2: the mid of process.hpp for 28 nm over that of the node. At 28 nm one: an area printed for 28 nm stands.
  Range factor() const {
    return {kNand2Um2.mid / nand2_um2.high, kNand2Um2.mid / nand2_um2.mid, kNand2Um2.mid / nand2_um2.low};
  }
};
inline const TechNode kNode28 = {"28 nm", 28, {kNand2Um2.mid, kNand2Um2.mid, kNand2Um2.mid}, "as published"};

using Values = std::map<std::string, double>;

struct Rival {
  std::string key, name, venue;
  TechNode node;
  double ghz, mm2;                    // mm2 in its node
  std::vector<Parameter> parameters;  // "watts" is always one of them
  MachineFrame (*frame)(const FrameCounts& counts, const Values& values, PlayedMemory& memory);

  Range mm2_28() const { return node.factor() * mm2; }
};

// The value of every parameter, but for those in `changed`. What a model is asked beyond its ranges (a part of the
// machine left out) goes by the same names.
Values values_of(const Rival& rival, const Values& changed = {});
double value(const Values& values, const std::string& name);
MachineFrame frame_of(const Rival& rival, const FrameCounts& counts, PlayedMemory& memory, const Values& changed = {});

const Rival& gscore();
const Rival& gs_tg();
const Rival& streaminggs();
const Rival& gsacc();
const Rival& neo();
const Rival& flicker();
std::vector<const Rival*> all_rivals();

}  // namespace pipegs
