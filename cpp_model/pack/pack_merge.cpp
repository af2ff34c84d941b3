// SPDX-License-Identifier: Apache-2.0
// pack_merge: see pack_merge.hpp. The only file of the models that reads Eigen's headers: the axes of a covariance.
#include "cpp_model/pack/pack_merge.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "cpp_model/float/projection.hpp"

namespace pipegs {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Axes = Eigen::SelfAdjointEigenSolver<Matrix>;

constexpr double kNothing = 1e-300;                     // weight of what covers nothing
constexpr double kLeastOpacity = 1.0 / (int{1} << 12);  // far below what a pixel shows

struct Part {
  Vector mean;
  Matrix covariance;
  double weight = 0;
};

// Of an ellipsoid with these variances, the mean over the three axes, up to a constant.
double area(const Vector& variances, double dilation) {
  const Vector s = (variances + Vector::Constant(dilation)).cwiseMax(0).cwiseSqrt();
  return (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]) / 3;
}

Part part_of(const Scene& scene, uint32_t index, double dilation) {
  ActivatedGaussian gaussian;
  activate(scene, index, gaussian);
  const glm::dmat3 axes = rotation_matrix(gaussian.rotation);
  Matrix rotation;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) rotation(row, column) = axes[column][row];
  }
  const Vector scale(gaussian.scale.x, gaussian.scale.y, gaussian.scale.z), variances = scale.cwiseProduct(scale);
  return {Vector(gaussian.mean.x, gaussian.mean.y, gaussian.mean.z),
          rotation * variances.asDiagonal() * rotation.transpose(), gaussian.opacity * area(variances, dilation)};
}

std::vector<Part> parts_of(const Scene& scene, std::span<const uint32_t> indices, double dilation) {
  std::vector<Part> parts;
  for (const uint32_t index : indices) {
    parts.push_back(part_of(scene, index, dilation));
    parts.back().weight = std::max(parts.back().weight, kNothing);
  }
  return parts;
}

// How the means spread around their own mean.
struct Spread {
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();
  double weight = 0;
};

Spread spread_of(const std::vector<Part>& parts) {
  Spread spread;
  for (const Part& part : parts) spread.mean += part.weight * part.mean, spread.weight += part.weight;
  spread.mean /= spread.weight;
  for (const Part& part : parts) {
    const Vector away = part.mean - spread.mean;
    spread.covariance += part.weight / spread.weight * (away * away.transpose());
  }
  return spread;
}

void split(const Scene& scene, std::vector<uint32_t> indices, int most, double pixel, std::vector<Merged>& result) {
  if (most == 1 || indices.size() <= 1) {
    if (!indices.empty()) result.push_back(merge_gaussians(scene, indices, pixel));
    return;
  }
  const std::vector<Part> parts = parts_of(scene, indices, kDilation * pixel * pixel);
  const Vector axis = Axes(spread_of(parts).covariance).eigenvectors().col(2);  // of the largest
  std::vector<size_t> order(indices.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return parts[a].mean.dot(axis) < parts[b].mean.dot(axis); });
  std::vector<uint32_t> low, high;
  for (size_t i = 0; i < order.size(); ++i) (i < order.size() / 2 ? low : high).push_back(indices[order[i]]);
  split(scene, low, most / 2, pixel, result);
  split(scene, high, most - most / 2, pixel, result);
}

}  // namespace

Merged merge_gaussians(const Scene& scene, std::span<const uint32_t> indices, double pixel) {
  const size_t rest = scene.sh_degree == 0 ? 0 : 3 * static_cast<size_t>(sh_rest_count(scene.sh_degree));
  const auto sh_of = [&](uint32_t index) { return std::span(sh_rest_of(scene, index), rest); };
  Merged merged;
  merged.heaviest = indices[0];
  if (indices.size() == 1) {
    merged.gaussian = scene.gaussians[indices[0]];
    const std::span own = sh_of(indices[0]);
    merged.sh_rest.assign(own.begin(), own.end());
    return merged;
  }
  const double dilation = kDilation * pixel * pixel;
  const std::vector<Part> parts = parts_of(scene, indices, dilation);
  const Spread spread = spread_of(parts);
  Matrix covariance = spread.covariance;
  glm::dvec3 dc(0);
  std::vector<double> sh(rest);
  double heaviest = -1;
  for (size_t i = 0; i < parts.size(); ++i) {
    const double share = parts[i].weight / spread.weight;
    covariance += share * parts[i].covariance;
    dc += share * glm::dvec3(scene.gaussians[indices[i]].sh_dc);
    for (size_t k = 0; k < rest; ++k) sh[k] += share * static_cast<double>(sh_of(indices[i])[k]);
    const bool more = parts[i].weight > heaviest;
    if (more || (parts[i].weight == heaviest && indices[i] < merged.heaviest)) merged.heaviest = indices[i];
    heaviest = std::max(heaviest, parts[i].weight);
  }

  const Axes axes(covariance);
  glm::dmat3 rotation;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) rotation[column][row] = axes.eigenvectors()(row, column);
    merged.gaussian.log_scale[column] = static_cast<float>(std::log(std::max(axes.eigenvalues()[column], 0.0)) / 2);
  }
  if (glm::determinant(rotation) < 0) rotation[0] = -rotation[0];
  const glm::dquat turn = glm::quat_cast(rotation);
  merged.gaussian.rotation = glm::vec4(turn.w, turn.x, turn.y, turn.z);
  merged.gaussian.mean = glm::vec3(spread.mean[0], spread.mean[1], spread.mean[2]);
  merged.gaussian.sh_dc = glm::vec3(dc);
  const double covered = area(axes.eigenvalues(), dilation),
               opacity = covered > 0 ? std::clamp(spread.weight / covered, kLeastOpacity, kMaxAlpha) : kMaxAlpha;
  merged.gaussian.opacity_logit = static_cast<float>(std::log(opacity / (1 - opacity)));
  merged.sh_rest.assign(sh.begin(), sh.end());
  return merged;
}

std::vector<Merged> merge_parts(const Scene& scene, std::span<const uint32_t> indices, int most, double pixel) {
  std::vector<Merged> result;
  split(scene, {indices.begin(), indices.end()}, most, pixel, result);
  return result;
}

}  // namespace pipegs
