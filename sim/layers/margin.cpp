// SPDX-License-Identifier: Apache-2.0
// margin: see margin.hpp.
#include "sim/layers/margin.hpp"

#include <cmath>
#include <limits>

#include "sim/layers/cldr.hpp"

namespace pipegs {
namespace {

constexpr double kMeanDb = 49.3, kMeanDecade = -1.464, kDbOfDecade = -2.95;  // of the fit

}  // namespace

Margin margin(const Scene& scene, const LayerGrid& grid) {
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    drawn += activate(scene, i, gaussian) == Cull::kNone;
  }
  Margin result{grid.cells, {}};
  if (drawn == 0) return result;
  const std::array<std::size_t, 3> over = violators(scene, grid, CldrOptions().gamma);
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.share[axis] = static_cast<double>(over[axis]) / static_cast<double>(drawn);
  return result;
}

double expected_order_db(double share) {
  if (!(share > 0)) return std::numeric_limits<double>::infinity();
  return kMeanDb + kDbOfDecade * (std::log10(share) - kMeanDecade);
}

}  // namespace pipegs
