// SPDX-License-Identifier: Apache-2.0
// run.hpp: one view on a machine without the effects that were left out, held against the machine with all.
//
// Idea    The golden frame is that of the full configuration. The RTL of the plan writes its pixels, and every one is
//         compared with it: a detector that is wrong cannot pass. What went wrong is then looked for with all effects.
#pragma once

#include "sim/effects/effects.hpp"

namespace pipegs {

// Runs the RTL of `plan`; simulate_golden() with `full` must have run. Returns "", or one line when something that was
// left out is called for: then the RTL has run once more, with everything, and `simulation` holds what that gave.
std::string simulate_effects(const Scene& scene, const Camera& camera, const SimulateOptions& full,
                             const EffectPlan& plan, Simulation& simulation);

}  // namespace pipegs
