// SPDX-License-Identifier: Apache-2.0
// rotation: from d loss / d (matrix of a rotation) to d loss / d (quaternion as stored, unnormalised).
//
// Idea    matrix = R(q / |q|). The derivative with respect to the unit quaternion, without its part along q, over |q|:
//         a longer quaternion is the same rotation, so a step along it changes nothing.
#pragma once

#include <glm/glm.hpp>

namespace pipegs {

// `unit` = w, x, y, z; `length` of the stored quaternion; d_matrix[column][row] as GLM has it.
inline glm::dvec4 rotation_gradient(const glm::dvec4& unit, double length, const glm::dmat3& d_matrix) {
  const double w = unit[0], x = unit[1], y = unit[2], z = unit[3];
  const auto g = [&](int row, int column) { return d_matrix[column][row]; };
  const glm::dvec4 gradient{
      2 * (z * (g(1, 0) - g(0, 1)) + y * (g(0, 2) - g(2, 0)) + x * (g(2, 1) - g(1, 2))),
      2 * (y * (g(0, 1) + g(1, 0)) + z * (g(0, 2) + g(2, 0)) + w * (g(2, 1) - g(1, 2)) - 2 * x * (g(1, 1) + g(2, 2))),
      2 * (x * (g(0, 1) + g(1, 0)) + z * (g(1, 2) + g(2, 1)) + w * (g(0, 2) - g(2, 0)) - 2 * y * (g(0, 0) + g(2, 2))),
      2 * (x * (g(0, 2) + g(2, 0)) + y * (g(1, 2) + g(2, 1)) + w * (g(1, 0) - g(0, 1)) - 2 * z * (g(0, 0) + g(1, 1)))};
  return (gradient - unit * glm::dot(unit, gradient)) / length;
}

}  // namespace pipegs
