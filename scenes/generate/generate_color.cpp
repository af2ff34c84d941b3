// SPDX-License-Identifier: Apache-2.0
// generate_color: the colours of generate_builder.hpp.
//
// Idea    Normal equations A c = b with A = sum w y y^T + ridge, solved by Cholesky for the three
//         channels at once. The ridge keeps unseen directions near the seen average, and A positive.
#include "scenes/generate/generate_builder.hpp"

#include <cmath>
#include <vector>

#include "scenes/sh_basis.hpp"

namespace pipegs::generate {
namespace {

constexpr int kBasis = static_cast<int>(kShBasis);
// Where the imagined photographs were taken: rings at three heights, denser in front.
const std::vector<glm::dvec3>& photographers() {
  static const std::vector<glm::dvec3> all = [] {
    std::vector<glm::dvec3> out;
    for (int i = 0; i < 96; ++i) {
      const double turn = (i + 0.5) / 96 * 2 * kPi;
      const double angle = turn + 0.45 * std::sin(turn);  // bunches around angle pi = the front
      const double radius = 4.6 + 0.9 * ((i * 7) % 5) / 4.0, height = 0.7 + 0.75 * (i % 3);
      out.push_back({radius * std::sin(angle), -height, radius * std::cos(angle)});
    }
    return out;
  }();
  return all;
}

}  // namespace

ShColor fit_color(const glm::dvec3& point, const glm::dvec3& normal,
                  const std::function<glm::dvec3(const glm::dvec3&)>& seen) {
  const bool all_round = glm::dot(normal, normal) == 0;
  double a[kBasis][kBasis] = {};
  ShColor b{};
  double total = 0;
  for (const glm::dvec3& camera : photographers()) {
    const glm::dvec3 view = glm::normalize(camera - point);
    const double weight = all_round ? 1 : glm::smoothstep(-0.05, 0.25, glm::dot(view, normal));
    if (weight <= 0) continue;
    const auto y = sh_basis(-view);
    const glm::dvec3 target = seen(view) - 0.5;
    for (int i = 0; i < kBasis; ++i) {
      for (int j = 0; j <= i; ++j) a[i][j] += weight * y[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)];
      b[static_cast<std::size_t>(i)] += weight * y[static_cast<std::size_t>(i)] * target;
    }
    total += weight;
  }
  if (total == 0) return plain_color(seen(normal));  // never faces a photographer: not seen either
  for (int i = 0; i < kBasis; ++i) a[i][i] += (i == 0 ? 1e-6 : 4e-4) * total;
  for (int i = 0; i < kBasis; ++i) {
    for (int j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (int k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-12)) : sum / a[j][j];
    }
  }
  for (int i = 0; i < kBasis; ++i) {
    for (int k = 0; k < i; ++k) b[static_cast<std::size_t>(i)] -= a[i][k] * b[static_cast<std::size_t>(k)];
    b[static_cast<std::size_t>(i)] /= a[i][i];
  }
  for (int i = kBasis - 1; i >= 0; --i) {
    for (int k = i + 1; k < kBasis; ++k) b[static_cast<std::size_t>(i)] -= a[k][i] * b[static_cast<std::size_t>(k)];
    b[static_cast<std::size_t>(i)] /= a[i][i];
  }
  return b;
}

ShColor plain_color(const glm::dvec3& color) {
  ShColor out{};
  out[0] = (color - 0.5) / kShConstant;
  return out;
}

void add_gradient(ShColor& color, const glm::dvec3& axis, const glm::dvec3& amount) {
  color[1] -= axis.y / kShLinear * amount;
  color[2] += axis.z / kShLinear * amount;
  color[3] -= axis.x / kShLinear * amount;
}

}  // namespace pipegs::generate
