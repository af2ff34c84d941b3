// SPDX-License-Identifier: Apache-2.0
// scene_check: see scene_check.hpp.
#include "scenes/check/scene_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "scenes/check/origin.hpp"
#include "scenes/percentile.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kFewest = 16, kSample = 200000;
constexpr double kFaint = 1.0 / 255;
constexpr double kExtremeAnisotropy = 1e4;
constexpr double kUnitTolerance = 1e-3;  // INRIA stores what the optimiser left, gsplat unit ones
constexpr double kOften = 0.9, kNearlyAll = 0.98;
constexpr double kOpaque = 0.9;  // as a share of 1; no scene has this logit everywhere

struct Counted {
  std::size_t count = 0, first = 0;
  void add(std::size_t index) {
    if (count++ == 0) first = index;
  }
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  bool is_one() const { return low == high; }
};

// What single Gaussians cannot show.
struct Whole {
  double extent = 0, median_scale = 0, low_log_scale = 0;
  double away = 0;  // half of them are farther from the origin, along an axis
  std::size_t usable = 0;
  Range log_scale, logit, color;
  std::size_t share_logits = 0, share_colors = 0;     // from 0 to 1
  std::array<std::size_t, 4> negative{}, positive{};  // components of the rotation
};

bool is_share(double value) { return value >= 0 && value <= 1; }

Whole look_at_all(const Scene& scene) {
  Whole all;
  std::array<std::vector<double>, 3> axes;
  std::vector<double> scales, logarithms, away;
  const std::size_t step = scene.gaussians.size() / kSample + 1;
  for (std::size_t i = 0; i < scene.gaussians.size(); i += step) {
    ActivatedGaussian active;
    if (activate(scene, i, active) != Cull::kNone) continue;
    const Gaussian& g = scene.gaussians[i];
    ++all.usable;
    for (int k = 0; k < 3; ++k) {
      axes[static_cast<std::size_t>(k)].push_back(g.mean[k]);
      if (std::isfinite(g.log_scale[k])) logarithms.push_back(g.log_scale[k]), all.log_scale.add(g.log_scale[k]);
      all.color.add(g.sh_dc[k]);
      all.share_colors += is_share(g.sh_dc[k]);
    }
    scales.push_back(std::max({active.scale.x, active.scale.y, active.scale.z}));
    const glm::dvec3 place = glm::abs(active.mean);
    away.push_back(std::max({place.x, place.y, place.z}));
    all.logit.add(g.opacity_logit);
    all.share_logits += is_share(g.opacity_logit);
    for (std::size_t k = 0; k < 4; ++k) {
      const float v = g.rotation[static_cast<int>(k)];
      all.negative[k] += v < 0;
      all.positive[k] += v > 0;
    }
  }
  if (all.usable == 0) return all;
  glm::dvec3 side(0);
  for (int k = 0; k < 3; ++k) {
    const auto& values = axes[static_cast<std::size_t>(k)];
    side[k] = percentile(values, 0.98) - percentile(values, 0.02);
  }
  all.extent = glm::length(side);
  all.median_scale = percentile(scales, 0.5);
  all.away = percentile(away, 0.5);
  all.low_log_scale = logarithms.empty() ? 0 : percentile(logarithms, 0.02);
  return all;
}

void check_forms(const Whole& all, Findings& findings) {
  if (all.usable < kFewest) return;
  const auto nearly_all = [&](std::size_t count, std::size_t of) {
    return static_cast<double>(count) >= kNearlyAll * static_cast<double>(of);
  };
  const bool coarse = all.median_scale > all.extent / 20;
  if (all.low_log_scale >= 0 && all.median_scale > 1 && (coarse || all.low_log_scale < 0.5)) {
    const bool every = all.log_scale.low >= 0;
    findings.emplace_back("scale_form",
                          fmt::format("{} scales are 0 or more in the logarithm: {} Gaussian is smaller than 1 unit in "
                                      "a scene of {:.3g}; scales look linear where logarithms are expected",
                                      every ? "all" : "nearly all", every ? "no" : "hardly a", all.extent));
  } else if (all.median_scale > all.extent) {
    findings.emplace_back("scale_form",
                          fmt::format("the median scale of {:.3g} is above the extent of {:.3g}: scales look linear "
                                      "where logarithms are expected",
                                      all.median_scale, all.extent));
  }
  if (nearly_all(all.share_logits, all.usable) && (!all.logit.is_one() || all.logit.low >= kOpaque)) {
    findings.emplace_back("opacity_form", fmt::format("opacities lie from {:.3g} to {:.3g}, {} of {} from 0 to 1: they "
                                                      "look like shares of 1 where logits are expected",
                                                      all.logit.low, all.logit.high, all.share_logits, all.usable));
  } else if (all.logit.low >= 0 && all.logit.high > 20) {
    findings.emplace_back("opacity_form", fmt::format("opacities reach {:.3g} and none is below 0: they look like "
                                                      "codes up to 255 where logits are expected",
                                                      all.logit.high));
  }
  if (!all.color.is_one() && nearly_all(all.share_colors, 3 * all.usable)) {
    findings.emplace_back("color_form",
                          fmt::format("{} of {} constant coefficients lie from 0 to 1: they look like colours where "
                                      "coefficients of SH are expected",
                                      all.share_colors, 3 * all.usable));
  } else if (all.color.low >= 0 && all.color.high > 8) {
    findings.emplace_back("color_form",
                          fmt::format("constant coefficients reach {:.3g} and none is below 0: they look like codes "
                                      "up to 255 where coefficients of SH are expected",
                                      all.color.high));
  }
  // Writers that make one component positive make w positive: it is the first.
  const auto one_sign = [&](std::size_t k) {
    return all.negative[k] == 0 && static_cast<double>(all.positive[k]) > kOften * static_cast<double>(all.usable);
  };
  const auto both_signs = [&](std::size_t k) {
    return 4 * all.negative[k] > all.usable && 4 * all.positive[k] > all.usable;
  };
  for (std::size_t k = 1; k < 4; ++k) {
    if (!one_sign(k) || !both_signs(0)) continue;
    findings.emplace_back("rotation_form",
                          fmt::format("component {} of all quaternions is positive and the first has both signs: they "
                                      "look like {} where w x y z is expected",
                                      k + 1, k == 3 ? "x y z w" : "another order of components"));
    break;
  }
}

void check_distance(const Whole& all, Findings& findings) {
  const double step = float_step(all.away);
  if (all.usable < 2 || step == 0 || !(step > all.median_scale / 20)) return;
  findings.emplace_back(
      "far_away", fmt::format("half of all lie {:.3g} or more from the origin, where steps of float32 are {:.2g}: "
                              "they are rounded by up to half of that, the median scale is {:.2g}; subtract an "
                              "origin from scene and cameras before float32 is written",
                              all.away, step, all.median_scale));
}

}  // namespace

Findings check_scene(const Scene& scene) {
  check_consistent(scene);
  const Whole all = look_at_all(scene);
  Counted non_finite, zero, not_unit, faint, needle, large;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian g;
    const Cull cull = activate(scene, i, g);
    if (cull == Cull::kNonFinite) non_finite.add(i);
    if (cull == Cull::kZeroQuaternion) zero.add(i);
    if (cull != Cull::kNone) continue;
    const double largest = std::max({g.scale.x, g.scale.y, g.scale.z});
    const double smallest = std::min({g.scale.x, g.scale.y, g.scale.z});
    if (std::abs(glm::length(glm::dvec4(scene.gaussians[i].rotation)) - 1) > kUnitTolerance) not_unit.add(i);
    if (g.opacity < kFaint) faint.add(i);
    if (largest > kExtremeAnisotropy * smallest) needle.add(i);
    if (all.usable > 1 && largest > all.extent) large.add(i);
  }
  Findings findings;
  const auto add = [&](const char* key, const char* what, const Counted& found) {
    if (found.count > 0) findings.emplace_back(key, what, found.count, found.first);
  };
  add("non_finite", "non-finite values, culled", non_finite);
  add("zero_rotation", "zero quaternion, culled", zero);
  add("rotation_length", "quaternion not of unit length", not_unit);
  add("faint", "opacity below 1/255, never drawn", faint);
  add("needle", "largest / smallest scale above 1e4", needle);
  add("large", "scale above the extent of the scene", large);
  const std::size_t count = scene.gaussians.size(), usable = count - non_finite.count - zero.count;
  if (count == 0) findings.emplace_back("no_gaussian", "the scene holds no Gaussian");
  else if (usable == 0)
    findings.emplace_back("nothing_usable", fmt::format("none of {} Gaussians can be drawn: all are culled", count));
  else if (faint.count == usable)
    findings.emplace_back("all_faint",
                          fmt::format("all {} Gaussians have an opacity below 1/255, none is drawn", usable));
  check_forms(all, findings);
  check_distance(all, findings);
  return findings;
}

}  // namespace pipegs
