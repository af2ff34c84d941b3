// SPDX-License-Identifier: Apache-2.0
// axes: see axes.hpp.
//
// Idea    Directions of the integral: four heights of Gauss-Legendre's rule, eight angles; exact up to degree 7.
#include "scenes/formats/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <string_view>

#include "scenes/scene.hpp"
#include "scenes/sh_basis.hpp"

namespace pipegs {
namespace {

constexpr std::array<std::string_view, 3> kPairs = {"RL", "DU", "FB"};  // along x, y, z of a scene, and against
constexpr double kRounding = 1e-12;

using ShMatrix = std::array<std::array<double, kShBasis>, kShBasis>;

ShMatrix sh_matrix(const glm::dmat3& turn) {
  constexpr std::array<double, 4> kHeights = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                              0.8611363115940526};
  constexpr std::array<double, 4> kWeights = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                              0.3478548451374538};
  constexpr int kAngles = 8;
  ShMatrix matrix{};
  for (std::size_t i = 0; i < kHeights.size(); ++i) {
    for (int k = 0; k < kAngles; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / kAngles;
      const double radius = std::sqrt(1 - kHeights[i] * kHeights[i]);
      const glm::dvec3 d(radius * std::cos(angle), radius * std::sin(angle), kHeights[i]);
      const auto before = sh_basis(d), after = sh_basis(turn * d);
      const double weight = kWeights[i] * 2 * std::numbers::pi / kAngles;
      for (std::size_t m = 0; m < kShBasis; ++m) {
        // Coefficients of a degree are made of those of the same one alone.
        const std::size_t band = m < 1 ? 0 : m < 4 ? 1 : m < 9 ? 2 : 3;
        for (std::size_t n = band * band; n < (band + 1) * (band + 1); ++n)
          matrix[m][n] += weight * after[m] * before[n];
      }
    }
  }
  for (auto& row : matrix) {
    for (double& v : row) {
      if (std::abs(v - std::round(v)) < kRounding) v = std::round(v);
    }
  }
  return matrix;
}

void turn_sh(const ShMatrix& matrix, int degree, float* rest) {
  std::array<std::array<double, 3>, kShBasis> turned{};
  const int count = sh_rest_count(degree);
  for (int m = 1; m <= count; ++m) {
    const int band = m < 4 ? 1 : m < 9 ? 2 : 3;
    for (int n = band * band; n < (band + 1) * (band + 1); ++n) {
      const double factor = matrix[static_cast<std::size_t>(m)][static_cast<std::size_t>(n)];
      for (std::size_t c = 0; factor != 0 && c < 3; ++c)
        turned[static_cast<std::size_t>(m)][c] += factor * rest[3 * (n - 1) + static_cast<int>(c)];
    }
  }
  for (int m = 1; m <= count; ++m) {
    for (std::size_t c = 0; c < 3; ++c)
      rest[3 * (m - 1) + static_cast<int>(c)] = narrow(turned[static_cast<std::size_t>(m)][c]);
  }
}

}  // namespace

bool are_axes(const std::string& axes) {
  if (axes.size() != 3) return false;
  return std::all_of(kPairs.begin(), kPairs.end(), [&](std::string_view pair) {
    return std::count_if(axes.begin(), axes.end(), [&](char c) { return pair.find(c) != std::string_view::npos; }) == 1;
  });
}

glm::dmat3 turn_of(const std::string& axes) {
  glm::dmat3 turn(0.0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const std::size_t place = kPairs[static_cast<std::size_t>(row)].find(axes[static_cast<std::size_t>(column)]);
      if (place != std::string_view::npos) turn[column][row] = place == 0 ? 1 : -1;
    }
  }
  return turn;
}

void transform(Scene& scene, const glm::dmat3& turn, double scale, const glm::dvec3& shift) {
  if (turn == glm::dmat3(1.0) && scale == 1 && shift == glm::dvec3(0)) return;
  const glm::dquat rotation = glm::quat_cast(glm::determinant(turn) < 0 ? -turn : turn);
  const ShMatrix matrix = scene.sh_degree > 0 ? sh_matrix(turn) : ShMatrix{};
  const double grown = std::log(scale);
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(scene.sh_degree));
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    Gaussian& g = scene.gaussians[i];
    const glm::dvec3 mean = scale * (turn * glm::dvec3(g.mean)) + shift;
    const glm::dquat q = rotation * glm::dquat(g.rotation[0], g.rotation[1], g.rotation[2], g.rotation[3]);
    g.mean = {narrow(mean.x), narrow(mean.y), narrow(mean.z)};
    g.rotation = {narrow(q.w), narrow(q.x), narrow(q.y), narrow(q.z)};
    if (scale != 1) {
      for (int axis = 0; axis < 3; ++axis) g.log_scale[axis] = narrow(g.log_scale[axis] + grown);
    }
    if (rest > 0) turn_sh(matrix, scene.sh_degree, scene.sh_rest.data() + i * rest);
  }
}

}  // namespace pipegs
