// SPDX-License-Identifier: Apache-2.0
// layers.hpp: the slabs of an orthogonal grid, and what the tiles and windows find in each.
#pragma once

#include "sim/studies/rivals/count/lists.hpp"

namespace pipegs {

// `cells`: 1 to kMostCells.
GridCounts count_layers(const Scene& scene, const SeenScene& seen, const TileLists& lists, int cells,
                        const Camera& camera, const CountOptions& options);

}  // namespace pipegs
