// SPDX-License-Identifier: Apache-2.0
// margin: which share of a scene's Gaussians reaches over the planes between layers.
//
// Paper   Eq. 4 and 5: a Gaussian violates the margin along an axis when sigma > gamma d, gamma = 0.9.
// Idea    A view is drawn in the layers of its principal axis, so there is one share for each axis and grid.
#pragma once

#include <array>

#include "scenes/scene.hpp"
#include "sim/layers/layer_grid.hpp"

namespace pipegs {

inline constexpr std::array<int, 2> kMarginGrids = {4, 8};  // cells along an axis

struct Margin {
  int grid = 0;
  std::array<double, 3> share{};  // by axis: of the Gaussians that can be drawn, those that violate it
};

Margin margin(const Scene& scene, const LayerGrid& grid);

}  // namespace pipegs
