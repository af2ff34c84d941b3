// SPDX-License-Identifier: Apache-2.0
// generate_color: SH coefficients of one Gaussian, fitted as training fits them.
//
// Idea    Ask for the colour from a ring of cameras around the scene, weight the views from which
//         the surface faces the camera, and solve the 16 coefficients by regularised least squares.
//         Like a trained scene, the fit is sharp where cameras were and undefined elsewhere.
// Layout  color[0] the constant, color[1..15] in the order of f_rest; display colours minus 0.5.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>

namespace pipegs::generate {

using ShColor = std::array<glm::dvec3, 16>;

// seen(v): display colour toward `v`, the unit direction from the point to a camera. A zero normal
// means visible from all sides.
ShColor fit_color(const glm::dvec3& point, const glm::dvec3& normal,
                  const std::function<glm::dvec3(const glm::dvec3&)>& seen);

// The same colour from everywhere.
ShColor plain_color(const glm::dvec3& color);

// Adds `amount` * dot(direction from camera, axis): what shines through leaves and haze.
void add_gradient(ShColor& color, const glm::dvec3& axis, const glm::dvec3& amount);

}  // namespace pipegs::generate
