// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/gradient/cldr: the loss by hand on a few Gaussians, its slopes by differences, and who is
// outside.
#include "sim/layers/cldr.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sim/studies/train/test/gradient/gaussians.hpp"

namespace pipegs {
namespace {

// Boundaries at 1, 2 and 3 on each axis.
const LayerGrid kGrid{4, glm::dvec3(0), glm::dvec3(1)};
const double kSigma = std::exp(static_cast<double>(on_grid(std::log(0.25))));

TEST(Cldr, DistancesAreToBoundariesAndNotToTheFacesOfTheGrid) {
  EXPECT_EQ(kGrid.distance(0, 1.25).length, 0.25);
  EXPECT_EQ(kGrid.distance(0, 1.25).slope, 1);
  EXPECT_EQ(kGrid.distance(0, 1.75).length, 0.25);
  EXPECT_EQ(kGrid.distance(0, 1.75).slope, -1);
  EXPECT_EQ(kGrid.distance(1, 0.125).length, 0.875);  // 0 is a face: the first cell goes on below it
  EXPECT_EQ(kGrid.distance(1, -6).length, 7);
  EXPECT_EQ(kGrid.distance(2, 9).length, 6);
  EXPECT_EQ(kGrid.slab(0, -6), 0);
  EXPECT_EQ(kGrid.slab(0, 2.5), 2);
  EXPECT_EQ(kGrid.slab(0, 9), 3);
  EXPECT_TRUE(std::isinf(LayerGrid{}.distance(0, 0.5).length));
}

TEST(Cldr, IsEquationFiveOnABall) {
  // A ball of sigma 0.25 an eighth beyond the boundary 1 along x: allowed is 0.9 / 8. A second one is inside.
  Parameters p;
  add_gaussian(p, {1.125, 0.5, 2.5}, glm::dvec3(0.25), {1, 0, 0, 0}, 0, glm::dvec3(0.5));
  add_gaussian(p, {0.5, 0.5, 2.5}, glm::dvec3(0.25), {1, 0, 0, 0}, 0, glm::dvec3(0.5));
  const double over = kSigma - 0.9 / 8, share = 0.05 / 2 / 3;  // the other axes have none
  CldrOptions options{.form = CldrForm::kPrinted, .weight = 0.05};
  Gradient gradient = zero_gradient(p);
  EXPECT_NEAR(cldr_loss(p, kGrid, options, &gradient), share * over * over, 1e-12);
  EXPECT_NEAR(gradient.mean[0].x, share * 2 * over * -0.9, 1e-9);  // away from the boundary
  EXPECT_NEAR(gradient.log_scale[0].x, share * 2 * over * kSigma, 1e-9);
  EXPECT_EQ(gradient.log_scale[0].y, 0);
  EXPECT_EQ(gradient.mean[1], glm::vec3(0));
  EXPECT_EQ(gradient.log_scale[1], glm::vec3(0));
  options.form = CldrForm::kLogarithm;
  const double log = std::log(kSigma / (0.9 / 8));
  gradient = zero_gradient(p);
  EXPECT_NEAR(cldr_loss(p, kGrid, options, &gradient), share * log * log, 1e-12);
  EXPECT_NEAR(gradient.log_scale[0].x, share * 2 * log, 1e-9);  // of the logarithm of sigma: no unit, no d
  EXPECT_NEAR(gradient.mean[0].x, share * 2 * log * -8, 1e-7);
  EXPECT_EQ(margin(scene_of(p, ""), kGrid).share, (std::array<double, 3>{0.5, 0, 0}));
  EXPECT_EQ(margin(scene_of(p, ""), LayerGrid{}).share, (std::array<double, 3>{}));
}

TEST(Cldr, SigmaIsThatOfTheTurnedEllipsoid) {
  // 45 degrees about z: sigma along x is the root of the mean of both squares (Eq. 4).
  Parameters p;
  add_gaussian(p, {1.125, 0.5, 0.5}, {0.5, 0.125, 0.25}, {2 * std::cos(M_PI / 8), 0, 0, 2 * std::sin(M_PI / 8)}, 0,
               glm::dvec3(0.5));
  const double over = std::sqrt((0.25 + 1.0 / 64) / 2) - 0.9 / 8;
  const CldrOptions options{.form = CldrForm::kPrinted, .weight = 3};
  EXPECT_NEAR(cldr_loss(p, kGrid, options, nullptr), over * over, 1e-4);
}

TEST(Cldr, AMeanOnABoundaryHasAFiniteLoss) {
  Parameters p;
  add_gaussian(p, {2, 0.5, 0.5}, glm::dvec3(0.25), {1, 0, 0, 0}, 0, glm::dvec3(0.5));
  Gradient gradient = zero_gradient(p);
  const double log = std::log(kSigma / (0.9 * kLeastDistance));
  EXPECT_NEAR(cldr_loss(p, kGrid, {.weight = 3}, &gradient), log * log, 1e-9);
  EXPECT_EQ(gradient.mean[0].x, 0);
  EXPECT_GT(gradient.log_scale[0].x, 0);
}

TEST(Cldr, AGradientOfAnotherShapeIsRefused) {
  Gradient other = zero_gradient(random_gaussians(1, 3, 0));
  EXPECT_THROW(cldr_loss(random_gaussians(1, 2, 0), kGrid, {}, &other), std::invalid_argument);
}

TEST(Cldr, SlopesAreThoseOfDifferences) {
  // The loss is once differentiable at the hinge, and not at the middle of a cell or on a boundary: no mean is there.
  Parameters p = random_gaussians(9, 40, 0);
  const LayerGrid grid{4, glm::dvec3(-1.013), glm::dvec3(0.507)};
  for (glm::vec3& mean : p.mean) {
    for (int axis = 0; axis < 3; ++axis) {
      const double place = (mean[axis] - grid.low[axis]) / grid.cell_size[axis], part = place - std::floor(place);
      const double kept = part < 0.5 ? std::clamp(part, 0.1, 0.4) : std::clamp(part, 0.6, 0.9);
      mean[axis] = on_grid(grid.low[axis] + (std::floor(place) + kept) * grid.cell_size[axis]);
    }
  }
  for (const CldrForm form : {CldrForm::kPrinted, CldrForm::kLogarithm}) {
    const CldrOptions options{.form = form, .weight = 40};
    Gradient gradient = zero_gradient(p);
    cldr_loss(p, grid, options, &gradient);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double scale = 1e-3 * (glm::length(gradient.log_scale[i]) + glm::length(gradient.mean[i]));
      const auto expect = [&](float found, float& value) {
        const double wanted = central_difference(value, [&](int) { return cldr_loss(p, grid, options, nullptr); });
        EXPECT_NEAR(found, wanted, 1e-4 * (std::abs(wanted) + scale) + 1e-6)
            << i << " of form " << static_cast<int>(form);
        moved += std::abs(wanted) > 1e-3;
      };
      for (int k = 0; k < 3; ++k) expect(gradient.mean[i][k], p.mean[i][k]);
      for (int k = 0; k < 3; ++k) expect(gradient.log_scale[i][k], p.log_scale[i][k]);
      for (int k = 0; k < 4; ++k) expect(gradient.rotation[i][k], p.rotation[i][k]);
    }
    EXPECT_GT(moved, 30u);
  }
}

}  // namespace
}  // namespace pipegs
