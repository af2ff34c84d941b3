// SPDX-License-Identifier: Apache-2.0
// densify: see densify.hpp.
//
// Idea    The new arrays are the old ones at a list of places, for values and for moments alike; then what differs of
//         the new Gaussians is written over.
#include "sim/studies/train/optimise/densify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cpp_model/float/projection.hpp"
#include "scenes/generate/generate_random.hpp"

namespace pipegs {
namespace {

constexpr float kDemanded = 2e-4f, kFaintest = 0.005f, kResetTo = 0.01f, kLargeShare = 0.1f, kDenseShare = 0.01f;
constexpr float kShrunk = 1.6f;  // 0.8 times the two halves

float logit(float opacity) { return std::log(opacity / (1 - opacity)); }
float largest_scale(const Parameters& p, std::size_t i) {
  return std::exp(std::max({p.log_scale[i].x, p.log_scale[i].y, p.log_scale[i].z}));
}

template <class Value>
void take(std::vector<Value>& values, const std::vector<std::uint32_t>& places, std::size_t width) {
  std::vector<Value> taken;
  taken.reserve(places.size() * width);
  for (const std::uint32_t place : places) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(place * width);
    taken.insert(taken.end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  values = std::move(taken);
}

void take(Parameters& p, const std::vector<std::uint32_t>& places) {
  take(p.mean, places, 1);
  take(p.log_scale, places, 1);
  take(p.sh_dc, places, 1);
  take(p.rotation, places, 1);
  take(p.opacity_logit, places, 1);
  take(p.sh_rest, places, static_cast<std::size_t>(3 * sh_rest_count(p.sh_degree)));
}

void zero_from(Parameters& p, std::size_t first) {
  const auto zero = [first](auto& values, std::size_t width) {
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(first * width), values.end(),
              typename std::decay_t<decltype(values)>::value_type(0));
  };
  zero(p.mean, 1), zero(p.log_scale, 1), zero(p.sh_dc, 1), zero(p.rotation, 1), zero(p.opacity_logit, 1);
  zero(p.sh_rest, static_cast<std::size_t>(3 * sh_rest_count(p.sh_degree)));
}

// Which of those that stay grow, with the largest demand first where there is room for `room` only; ascending.
std::vector<std::uint32_t> growing(const Demand& demand, const std::vector<bool>& stays, std::size_t room) {
  std::vector<std::uint32_t> chosen;
  std::vector<float> mean(demand.sum.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i] = demand.seen[i] == 0 ? 0 : demand.sum[i] / static_cast<float>(demand.seen[i]);
    if (stays[i] && mean[i] >= kDemanded) chosen.push_back(static_cast<std::uint32_t>(i));
  }
  if (chosen.size() > room) {
    std::sort(chosen.begin(), chosen.end(),
              [&](std::uint32_t a, std::uint32_t b) { return mean[a] > mean[b] || (mean[a] == mean[b] && a < b); });
    chosen.resize(room);
    std::sort(chosen.begin(), chosen.end());
  }
  return chosen;
}

// A point drawn from the Gaussian.
glm::vec3 drawn_from(const Parameters& p, std::size_t i, generate::Random& random) {
  const glm::dvec3 offset = glm::dvec3(glm::exp(p.log_scale[i])) * random.normals();
  return glm::dvec3(p.mean[i]) + rotation_matrix(glm::normalize(glm::dvec4(p.rotation[i]))) * offset;
}

}  // namespace

void Demand::clear(std::size_t gaussians) {
  sum.assign(gaussians, 0);
  seen.assign(gaussians, 0);
}

void Demand::add(const Seen& view) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (!(view.radius[i] > 0)) continue;
    sum[i] += view.mean_gradient[i];
    ++seen[i];
  }
}

void densify(Parameters& p, Moments& moments, Demand& demand, const DensifyOptions& options) {
  const auto extent = static_cast<float>(options.extent);
  std::vector<bool> stays(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool fits = !options.prune_large || largest_scale(p, i) <= kLargeShare * extent;
    stays[i] = fits && p.opacity_logit[i] >= logit(kFaintest);
  }
  const auto kept = static_cast<std::size_t>(std::count(stays.begin(), stays.end(), true));
  std::vector<std::uint32_t> places, clones, halves;
  for (const std::uint32_t i : growing(demand, stays, options.most - std::min(options.most, kept))) {
    if (largest_scale(p, i) <= kDenseShare * extent) {
      clones.push_back(i);
    } else {
      halves.insert(halves.end(), {i, i});
      stays[i] = false;
    }
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (stays[i]) places.push_back(static_cast<std::uint32_t>(i));
  }
  const std::size_t first_new = places.size(), first_half = first_new + clones.size();
  places.insert(places.end(), clones.begin(), clones.end());
  places.insert(places.end(), halves.begin(), halves.end());
  take(p, places);
  take(moments.first, places);
  take(moments.second, places);
  zero_from(moments.first, first_new);
  zero_from(moments.second, first_new);
  generate::Random random(options.seed);
  for (std::size_t i = first_half; i < p.size(); ++i) {
    p.mean[i] = drawn_from(p, i, random);
    p.log_scale[i] -= std::log(kShrunk);
  }
  demand.clear(p.size());
}

void reset_opacity(Parameters& p, Moments& moments) {
  for (float& value : p.opacity_logit) value = std::min(value, logit(kResetTo));
  std::fill(moments.first.opacity_logit.begin(), moments.first.opacity_logit.end(), 0.0f);
  std::fill(moments.second.opacity_logit.begin(), moments.second.opacity_logit.end(), 0.0f);
}

}  // namespace pipegs
