// SPDX-License-Identifier: Apache-2.0
// margin: see margin.hpp.
#include "sim/layers/margin.hpp"

#include "sim/layers/cldr.hpp"

namespace pipegs {

Margin margin(const Scene& scene, const LayerGrid& grid) {
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    drawn += activate(scene, i, gaussian) == Cull::kNone;
  }
  Margin result{grid.cells, {}};
  if (drawn == 0) return result;
  const std::array<std::size_t, 3> over = violators(scene, grid);
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.share[axis] = static_cast<double>(over[axis]) / static_cast<double>(drawn);
  return result;
}

}  // namespace pipegs
