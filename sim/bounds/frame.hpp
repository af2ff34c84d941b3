// SPDX-License-Identifier: Apache-2.0
// budget_frame: a golden frame held against the truth in the same order, pixel by pixel, with the bounds of budget.hpp.
//
// Idea    Each pixel is walked once, in the order of golden's rank, with the truth in double and with intervals: alpha
//         and colour lie in theirs, so T and the accumulated colour lie in
//           T' in [T.low (1 - alpha.high) - r, T.high (1 - alpha.low) + r]      r: the rounding of one weight
//         Where the interval of T' holds the stop level both ways are followed, and the result is the hull of both.
//         With AOVs (aovs.hpp) theirs are walked beside them.
// Rule    What the packer left out (and counted) is left out of the truth too; colours clip as the format does.
#pragma once

#include <optional>
#include <string>

#include "sim/bounds/aovs.hpp"
#include "sim/bounds/budget.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

// Of one quantity over all pixels (alphas: over all pairs of Gaussian and pixel).
struct BudgetFigure {
  double error = 0;   // worst |golden - truth|
  double bound = 0;   // worst bound, so error <= bound
  double excess = 0;  // worst distance beyond a pixel's own bound: 0 when all hold
};

struct BudgetReport {
  BudgetFigure alpha, t, color, expected;  // expected: depth, as a fraction of the frame's range
  size_t medians = 0, indices = 0;         // pixels where only one Gaussian can be it
  double power_bound = 0;                  // worst of a drawn Gaussian that has one
  size_t pairs = 0;                        // of Gaussian and pixel that golden or truth counts
  size_t vacuous = 0;                      // of these, pairs for which the bound says nothing
  std::optional<std::string> first;        // the first violation in words

  bool holds() const { return !first.has_value(); }
};

// Needs simulate_golden on the same scene, camera and options.
BudgetReport budget_frame(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                          const Simulation& simulation);

}  // namespace pipegs
