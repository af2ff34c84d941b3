// SPDX-License-Identifier: Apache-2.0
// axes: a scene in other axes, turned, moved or scaled, with its quaternions and SH coefficients.
//
// Terms   Axes are three letters, where x, y and z of the file point: Right or Left, Up or Down, Front or Back. INRIA's
//         cameras look along z with y down: RDF. RUB is OpenGL and what .spz's specification prefers, LUF is glTF.
// Idea    A colour that turns with the scene is the same function of another direction, so its coefficients of degree l
//         are those of before times a matrix, the integrals of Y_m(R d) Y_n(d). Gauss's rule makes them exact for the
//         polynomials that they are; a matrix of signs and zeros stays one, to the last bit.
// Rule    A mirrored ellipsoid is a turned one: its half turns are its own.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scenes/scene.hpp"

namespace pipegs {

inline constexpr const char* kSceneAxes = "RDF";

// Whether `axes` has a letter of each of the three pairs.
bool are_axes(const std::string& axes);
// From `axes` to those of a scene.
glm::dmat3 turn_of(const std::string& axes);

// mean -> scale * turn * mean + shift; `turn` is orthogonal.
void transform(Scene& scene, const glm::dmat3& turn, double scale = 1, const glm::dvec3& shift = glm::dvec3(0));

}  // namespace pipegs
