// SPDX-License-Identifier: Apache-2.0
// walk.hpp: the lists of 16-px tiles walked in depth order, with the pixels that each Gaussian finds alive.
#pragma once

#include <vector>

#include "sim/studies/rivals/count/lists.hpp"

namespace pipegs {

// Counts tiles. Returns of each the depth at which its last pixel stops, infinity when one never does.
std::vector<double> count_walks(const std::vector<SeenGaussian>& seen, const TileLists& lists, const Camera& camera,
                                const CountOptions& options, FrameCounts& counts);

}  // namespace pipegs
