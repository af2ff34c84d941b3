// SPDX-License-Identifier: Apache-2.0
// stress: hostile views through golden model, RTL and bounds; a failure is shrunk to the smallest view that still
// fails.
//
// Idea    stress_check says in one line what is wrong with a view: a stream or pixel that differs between RTL and
//         golden, an assertion, a value beyond its bound. stress_shrink is delta debugging: halves, quarters ... of the
//         Gaussians are left out while the failure stays; then the image is made smaller, and once more the Gaussians.
// Rule    The predicate is a parameter, so a test can shrink towards a failure that it injects.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/bounds/frame.hpp"
#include "sim/bounds/hostile_scene.hpp"

namespace pipegs {

// What is wrong with a view; nothing when all is well.
using StressPredicate = std::function<std::optional<std::string>(const StressView&)>;

struct StressFigures {
  uint64_t views = 0, gaussians = 0, pairs = 0, vacuous = 0, beats = 0, cycles = 0;
  Saturations saturations;
  double alpha = 0, t = 0, color = 0;  // worst errors
};

// Golden against bounds and, unless `rtl` is false, RTL against golden. Adds to the figures when there are some.
std::optional<std::string> stress_check(const StressView& view, SimulateOptions options, bool rtl,
                                        StressFigures* figures = nullptr);

struct StressShrunk {
  StressView view;
  std::string what;  // of the shrunk view
  int tried = 0;
};

// `view` fails: the smallest one found that does. `step` is called after each try; returning false stops where it is.
StressShrunk stress_shrink(const StressView& view, const StressPredicate& predicate,
                           const std::function<bool(const StressShrunk&)>& step = {});

}  // namespace pipegs
