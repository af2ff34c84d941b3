// SPDX-License-Identifier: Apache-2.0
// cldr: see cldr.hpp.
//
// Idea    For a world axis n, and row n of R: sigma^2 = sum_k (R_nk s_k)^2. Of both forms of the excess follow
//           d sigma / d log s_k = (R_nk s_k)^2 / sigma      d sigma / d R_nk = R_nk s_k^2 / sigma
#include "sim/layers/cldr.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cpp_model/float/parallel.hpp"
#include "cpp_model/float/projection.hpp"
#include "sim/layers/rotation.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kBlock = 4096;  // Gaussians whose losses are summed by one thread

// Row n of R S, whose length is sigma along axis n.
glm::dvec3 extent(const glm::dmat3& rotation, const glm::dvec3& scale, int axis) {
  return glm::dvec3(rotation[0][axis], rotation[1][axis], rotation[2][axis]) * scale;
}

// How far a Gaussian is beyond what is allowed, and the derivatives by sigma and by the coordinate of its mean.
struct Excess {
  double value = 0, by_sigma = 0, by_mean = 0;
};

Excess excess(double sigma, const LayerGrid::Distance& distance, double least, CldrForm form) {
  if (!(sigma > kGamma * distance.length)) return {};
  if (form == CldrForm::kPrinted) return {sigma - kGamma * distance.length, 1, -kGamma * distance.slope};
  const double d = std::max(distance.length, least), slope = distance.length > least ? distance.slope : 0;
  if (!(sigma > kGamma * d)) return {};
  return {std::log(sigma / (kGamma * d)), 1 / sigma, -slope / d};
}

// One Gaussian's part of the loss; adds to `sum`, if it is not null. `share` is the weight of one Gaussian and axis.
double loss_of(const Parameters& parameters, std::size_t i, const LayerGrid& grid, double share, CldrForm form,
               Gradient* sum) {
  ActivatedGaussian gaussian;
  if (activate(parameters, i, gaussian) != Cull::kNone) return 0;
  const glm::dmat3 rotation = rotation_matrix(gaussian.rotation);
  glm::dmat3 d_rotation(0);
  double loss = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 row = extent(rotation, gaussian.scale, axis);
    const double sigma = glm::length(row);
    const Excess e =
        excess(sigma, grid.distance(axis, gaussian.mean[axis]), kLeastDistance * grid.cell_size[axis], form);
    if (!(e.value > 0)) continue;
    loss += share * e.value * e.value;
    if (sum == nullptr) continue;
    const double d_value = 2 * share * e.value, d_sigma = d_value * e.by_sigma;
    sum->mean[i][axis] += static_cast<float>(d_value * e.by_mean);
    sum->log_scale[i] += glm::vec3(d_sigma / sigma * row * row);
    for (int k = 0; k < 3; ++k) d_rotation[k][axis] = d_sigma / sigma * row[k] * gaussian.scale[k];
  }
  if (sum == nullptr || loss == 0) return loss;
  const double length = glm::length(glm::dvec4(parameters.rotation[i]));
  sum->rotation[i] += glm::vec4(rotation_gradient(gaussian.rotation, length, d_rotation));
  return loss;
}

}  // namespace

double cldr_loss(const Parameters& parameters, const LayerGrid& grid, const CldrOptions& options, Gradient* sum) {
  if (sum != nullptr) check_same_shape(parameters, *sum);
  // Of one Gaussian and axis in the loss: 1/N, and the mean over the axes.
  const double share = options.weight / (static_cast<double>(std::max<std::size_t>(parameters.size(), 1)) * 3);
  std::vector<double> losses((parameters.size() + kBlock - 1) / kBlock);
  parallel_for(losses.size(), 0, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(parameters.size(), (block + 1) * kBlock); ++i) {
      losses[block] += loss_of(parameters, i, grid, share, options.form, sum);
    }
  });
  return std::accumulate(losses.begin(), losses.end(), 0.0);
}

Margin margin(const Scene& scene, const LayerGrid& grid) {
  Margin result{grid.cells, {}};
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) continue;
    ++drawn;
    const glm::dmat3 rotation = rotation_matrix(gaussian.rotation);
    for (int axis = 0; axis < 3; ++axis) {
      const double sigma = glm::length(extent(rotation, gaussian.scale, axis));
      result.share[static_cast<std::size_t>(axis)] += sigma > kGamma * grid.distance(axis, gaussian.mean[axis]).length;
    }
  }
  for (double& share : result.share) share /= static_cast<double>(std::max<std::size_t>(drawn, 1));
  return result;
}

}  // namespace pipegs
