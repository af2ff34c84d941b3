// SPDX-License-Identifier: Apache-2.0
// frame_check: a look at a scene that was packed, of which some may be left out, and at a frame that the golden model
// has drawn: whether anything was fetched and drawn at all.
#pragma once

#include "scenes/check/finding.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

Findings check_packed(const PackedScene& packed);
// A window or a crop may be empty.
Findings check_frame(const Simulation& simulation, const SimulateOptions& options);

}  // namespace pipegs
