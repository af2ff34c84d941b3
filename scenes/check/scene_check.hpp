// SPDX-License-Identifier: Apache-2.0
// scene_check: a look at a scene as a whole, after it was read: what is culled, and values that are not in the form in
// which a scene has them.
//
// Idea    A file that holds scales instead of their logarithms, opacities from 0 to 1 instead of logits, colours
//         instead of coefficients, or quaternions with w last is read without an error and drawn as fog. No Gaussian
//         alone shows it, all together do: trained values lie on both sides of 0.
// Rule    A form is doubted only where kFewest Gaussians agree. Percentiles are of at most kSample, evenly out of all.
#pragma once

#include "scenes/check/finding.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

// Throws std::invalid_argument as check_consistent() does.
Findings check_scene(const Scene& scene);

}  // namespace pipegs
