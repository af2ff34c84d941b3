// SPDX-License-Identifier: Apache-2.0
// aovs: what the AOVs of a pixel may be, where alphas, weights and depths are known to lie in intervals.
//
// Idea    blended    a Gaussian counts for certain where no alpha of its interval is 0 and no machine has stopped
//                    before
//         expected   the sum of weight * depth, ends of the intervals and the rounding of each product apart
//         median     the depth of one of the Gaussians with which T may fall below one half; none where none must
//         index      one of the Gaussians that may weigh most: not below what another one weighs for certain
//         So a median is another Gaussian's only where T is within its own error of one half, an index only where two
//         weights are within theirs of each other.
// Docs    docs/numerics/error_budget.md. Depths are fractions of the frame's range.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/bounds/budget.hpp"

namespace pipegs {

// One Gaussian blended into a pixel, or not.
struct BlendStep {
  bool possible = false, certain = false;
  Interval before, weight, next;  // T, what it adds, T
};

// Depths that a machine may keep for a view z in scene units, which may be off by `error`; `range`: the frame's.
Interval depth_interval(const Config& config, double depth, double error, double range);
// Rounding of one weight times depth.
double depth_rounding(const Config& config);

class AovBounds {
 public:
  void take(const Config& config, const BlendStep& step, uint32_t index, Interval depth);

  Interval blended() const { return {static_cast<double>(least_), static_cast<double>(most_)}; }
  Interval expected() const { return expected_; }
  bool allows_median(double found) const;
  bool allows_index(std::optional<uint32_t> found) const;
  std::string median_text() const;
  bool one_median() const { return falls_ && candidates_ == 1; }
  bool one_index() const;

 private:
  struct Best {
    uint32_t index;
    double most;
  };
  size_t least_ = 0, most_ = 0, candidates_ = 0;
  Interval expected_, median_{std::numeric_limits<double>::infinity(), 0};
  bool falls_ = false;  // T falls below one half for certain
  double best_ = 0;     // what some Gaussian weighs for certain
  std::vector<Best> may_be_best_;
};

}  // namespace pipegs
