// SPDX-License-Identifier: Apache-2.0
// margin: which share of a scene's Gaussians reaches over the planes between layers, and what that lets expect.
//
// Paper   Eq. 4 and 5: a Gaussian violates the margin along an axis when sigma > gamma d, gamma = 0.9.
// Idea    A view is drawn in the layers of its principal axis, so there is one share for each axis and grid.
// Limit   The share says little of a view's order PSNR. The estimate is the line through psnr_order_db of `dop` over
//         the logarithm of the share, in ten views of four trained scenes (terrace, statue, plushdog, flowers): they
//         lie between 40 and 64 dB, and the line is off by 7.1 dB in the root of the mean square where their mean
//         alone is off by 7.3. Our own scene, which was not trained, has 80 dB where 50 are expected. Which Gaussians
//         stand at a plane, and what hides them, only a drawn view tells.
#pragma once

#include <array>

#include "scenes/scene.hpp"
#include "sim/layers/layer_grid.hpp"

namespace pipegs {

inline constexpr std::array<int, 2> kMarginGrids = {4, 8};  // cells along an axis
inline constexpr double kOrderDbError = 7;

struct Margin {
  int grid = 0;
  std::array<double, 3> share{};  // by axis: of the Gaussians that can be drawn, those that violate it
};

Margin margin(const Scene& scene, const LayerGrid& grid);

// What psnr_order_db of a view along an axis with this share is near; infinite where none violates it.
double expected_order_db(double share);

}  // namespace pipegs
