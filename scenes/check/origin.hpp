// SPDX-License-Identifier: Apache-2.0
// origin: positions of 64 bits as those of a scene, which have 32.
//
// Idea    Coordinates of a map (UTM, ECEF) lie millions of units from their origin, where float32 has steps of half a
//         unit. About a point among them they keep all their digits. Whoever looks at the scene subtracts the same
//         point from its cameras (SceneFormat::origin).
// Rule    Only where the steps at the middle of the scene are above kStep of the median scale: others stay as they are.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scenes/formats/format.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

// The step of float32 at a coordinate above 0; 0 where there is none.
double float_step(double at);

// The scene has its scales already.
void set_positions(const std::vector<glm::dvec3>& positions, Scene& scene, SceneFormat& format);

}  // namespace pipegs
