// SPDX-License-Identifier: Apache-2.0
// checks.hpp: each model against figures of its own paper that the view at hand can show.
//
// Rule    Scenes of those papers are not at hand, so most figures are ratios of one model to itself or to GSCore's. A
//         figure passes within 15 %. Nothing is fitted to make one pass; where a parameter was taken from a figure, the
//         row says so.
#pragma once

#include <string>
#include <vector>

#include "sim/studies/rivals/models/rival.hpp"

namespace pipegs {

inline constexpr double kTolerance = 0.15;

struct Check {
  std::string rival, figure, unit;
  double published, ours;
  std::string why;       // what parts them, or where the agreement is from
  bool at_most = false;  // a bound
  bool chosen = false;   // a parameter is from this figure: it checks nothing
  double ratio() const { return ours / published; }
  bool passes() const { return !chosen && ratio() <= 1 + kTolerance && (at_most || ratio() >= 1 - kTolerance); }
};
std::vector<Check> checks_of(const FrameCounts& counts, PlayedMemory& memory);

// Cycles of a frame of Lego on GSCore as published (190 frames/s), and what its published bytes take in this memory at
// least: the second over the first is the efficiency that would close the figure.
inline constexpr double kLegoCycles = 5.26e6;
double lego_least_cycles(PlayedMemory& memory);

}  // namespace pipegs
