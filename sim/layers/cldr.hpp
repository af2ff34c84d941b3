// SPDX-License-Identifier: Apache-2.0
// cldr: the loss that keeps Gaussians inside their layers, and which share of a scene is not inside.
//
// Paper   Eq. 4: sigma_n^2 = n^T R diag(s^2) R^T n, n a world axis.
//         Eq. 5: L_boundary = 1/N sum_i max(0, sigma_n - gamma d)^2, d the distance to the nearest boundary.
//         Eq. 6: what is returned is weight * L_boundary, lambda_cldr = 0.05, gamma = 0.9.
// Idea    Printed so, the loss has the square of a length as its unit: in scene units it is nothing beside the
//         photographs' loss for a Gaussian of a hundredth. kLogarithm is max(0, log(sigma / gamma d))^2: the same
//         Gaussians, a number that does not depend on the unit. There d is at least kLeastDistance of a cell: a mean on
//         a boundary has a finite loss, and is left alone once it is smaller than that.
// Axes    The mean of the losses of all three: the paper's n is the principal axis of the view's camera.
// Rule    Means through d, log scales and rotations have a gradient. What cannot be drawn has no loss, and counts in N.
#pragma once

#include <array>
#include <cstddef>

#include "sim/layers/layer_grid.hpp"
#include "sim/layers/parameters.hpp"

namespace pipegs {

inline constexpr double kLeastDistance = 1e-3, kGamma = 0.9;

enum class CldrForm { kPrinted, kLogarithm };

struct CldrOptions {
  CldrForm form = CldrForm::kLogarithm;
  double weight = 0.05;
};

// Adds to `sum`, if it is not null.
double cldr_loss(const Parameters& parameters, const LayerGrid& grid, const CldrOptions& options, Gradient* sum);

inline constexpr std::array<int, 2> kMarginGrids = {4, 8};  // cells along an axis

// A view is drawn in the layers of its principal axis, so there is one share for each axis and grid.
struct Margin {
  int grid = 0;
  std::array<double, 3> share{};  // by axis: of the Gaussians that can be drawn, those with sigma > gamma d
};

Margin margin(const Scene& scene, const LayerGrid& grid);

}  // namespace pipegs
