// SPDX-License-Identifier: Apache-2.0
// aovs.cpp: see aovs.hpp.
#include "sim/bounds/aovs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pipegs {
namespace {

constexpr double kSlack = 1e-9;  // of the double arithmetic of the bounds themselves

double unit(int fraction) { return std::ldexp(1.0, -fraction); }
double largest(const Config& config) { return 1 - unit(config.linear_w()); }

}  // namespace

Interval depth_interval(const Config& config, double depth, double error, double range) {
  const int mantissa_w = config.depth_w - config.exp_w();
  // To nearest; where the key has more bits than fit, some are cut before.
  const double rounding = unit(config.linear_w() + 1) * (mantissa_w > config.linear_w() ? 2 : 1);
  const double low = (depth - error) * (1 - unit(mantissa_w)) / range - rounding,
               high = (depth + error) / range + rounding;
  return {std::clamp(low, 0.0, largest(config)), std::clamp(high, 0.0, largest(config))};
}

double depth_rounding(const Config& config) { return unit(config.linear_w() + 1); }

void AovBounds::take(const Config& config, const BlendStep& step, uint32_t index, Interval depth) {
  if (!step.possible) return;
  ++most_;
  least_ += step.certain;
  const double rounding = depth_rounding(config), least = step.certain ? step.weight.low : 0;
  expected_.low += std::max(0.0, least * depth.low - rounding);
  expected_.high = std::min(expected_.high + step.weight.high * depth.high + rounding, largest(config));
  if (step.before.high >= 0.5 && step.next.low < 0.5) {
    ++candidates_;
    median_ = {std::min(median_.low, depth.low), std::max(median_.high, depth.high)};
    falls_ = falls_ || (step.certain && step.next.high < 0.5);
  }
  best_ = std::max(best_, least);
  std::erase_if(may_be_best_, [&](const Best& one) { return one.most < best_; });
  if (step.weight.high >= best_) may_be_best_.push_back({index, step.weight.high});
}

bool AovBounds::allows_median(double found) const {
  if (found == 0 && !falls_) return true;
  return found >= median_.low - kSlack && found <= median_.high + kSlack;
}

std::string AovBounds::median_text() const {
  return fmt::format("{:.7f} to {:.7f}{}", median_.low, median_.high, falls_ ? "" : ", or none");
}

bool AovBounds::allows_index(std::optional<uint32_t> found) const {
  if (!found) return best_ == 0;
  return std::any_of(may_be_best_.begin(), may_be_best_.end(), [&](const Best& one) { return one.index == *found; });
}

bool AovBounds::one_index() const { return best_ > 0 && may_be_best_.size() == 1; }

}  // namespace pipegs
