// SPDX-License-Identifier: Apache-2.0
// eye_pair: two cameras that a walk of the scene serves at once, as the eyes of one camera between them.
//
// Idea    Eyes see every Gaussian at one depth: they have one rotation and one lens, and neither stands in front of the
//         other. Cameras that were measured are never quite that: what a hundredth of a pixel or a ten thousandth of
//         the way between them does not show is rounded away, with the first one's rotation.
#pragma once

#include <array>

#include "scenes/camera.hpp"

namespace pipegs {

struct EyePair {
  Camera middle;
  std::array<double, 2> half;  // of the way from the first one to the second one, along right and down, scene units
};

// Throws InputError that says what the two differ in: their lens, their angle in degrees, or the way that one stands in
// front of the other.
EyePair eye_pair(const Camera& first, const Camera& second);

}  // namespace pipegs
