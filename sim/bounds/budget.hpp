// SPDX-License-Identifier: Apache-2.0
// budget: how far power, alpha and colour of one Gaussian may lie from the truth, derived from the formats of the
// Config.
//
// Idea    Each narrowing of docs/numerics/numbers.md is a small perturbation of what the truth computes; its effect on
//         the power is bounded in the metric of the Gaussian's own covariance S (dilated, so at least 0.3):
//           a shift m of the mean     2 sqrt(k B) |S^-1/2 m| + k |S^-1/2 m|^2           B the power that counts, 8 bits
//           a change dU of U          B x / (1 - x),  x = 2 |S^-1/2 dU| + |S^-1/2 dU|^2
//           curvatures, slope         B (relative error) + B (error of the slope) sqrt(narrow / wide)
//         so a needle, for which a relative error of the covariance would mean nothing, gets a bound that means
//         something.
// Rule    All figures follow from entries of the Config: a changed width moves the bound, and every test that uses it.
// Docs    docs/numerics/error_budget.md derives each line. Units: log2 of alpha for powers, scene units for lengths.
#pragma once

#include "cpp_model/config.hpp"
#include "cpp_model/float/projection.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// What a bound needs to know of a packed Gaussian's surroundings, in scene units.
struct BudgetUnits {
  double world = 0;   // a world unit
  double offset = 0;  // unit of the offset of its mean from the chunk's centre
  double view = 0;    // unit of its chunk's view space
  double scale = 0;   // the smallest scale that its chunk's codes know (record = 48)
};

// Worst error of the power, log2 units, in any pixel that counts; infinite where nothing can be said.
struct PowerBudget {
  double record = 0;        // the packed record and the camera's fields; 0 when the truth gets the same
  double projection = 0;    // mean, Jacobian, rotation R'
  double conic = 0;         // covariance, determinant, curvatures, slope
  double coefficients = 0;  // A to F
  double accumulators = 0;  // the region's start and the Row Units' additions
  double compensation = 0;  // the opacity of antialiased scenes
  double total() const { return record + projection + conic + coefficients + accumulators + compensation; }
};

// One Gaussian's truth and how far the machine may stray from it.
struct GaussianBudget {
  TruthProjection truth;
  PowerBudget power;
  glm::dvec3 rgb{0};    // the truth's colour before its clamps, the constant band clipped as the record does
  double color = 0;     // error of each channel of it
  bool certain = true;  // false: so near the near plane that the machine may drop it
};

// The projection of one Gaussian and its bounds. `exact_record`: the Gaussian and camera given are what the record
// holds.
GaussianBudget gaussian_budget(const Config& config, const Camera& camera, const ProjectionOptions& options,
                               const ActivatedGaussian& gaussian, const glm::vec3& sh_dc, const float* sh_rest,
                               int sh_degree, const BudgetUnits& units, bool exact_record = false);

// The truth's power at a pixel in log2 units, opacity included.
double budget_power(const TruthProjection& truth, double x, double y);

struct Interval {
  double low = 0, high = 0;
};

// Alphas that the machine may give where the truth's power is `power` and the machine's within `error` of it.
Interval alpha_interval(const Config& config, double power, double error);
// The same of one colour channel, clipped to its format.
Interval color_interval(const Config& config, double color, double error);

// What alpha's own steps (exp2 and rounding) add: half a unit and a little, for an alpha that counts.
double alpha_rounding(const Config& config);
// Rounding of one weight (and so of T) and of one weight times colour.
double weight_rounding(const Config& config);
double blend_rounding(const Config& config);
// T below which a pixel stops.
double stop_level(const Config& config);

}  // namespace pipegs
