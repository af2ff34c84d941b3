// SPDX-License-Identifier: Apache-2.0
// start: the Gaussians with which training begins.
//
// Idea    Of points (INRIA's create_from_pcd): a ball on each, of the size of the mean distance to its three nearest
//         neighbours (root of the mean square), opacity 0.1, its colour in the constant coefficient.
//         Of a scene: the scene, so that what it leaves out of a picture is gone and what is at the end of a float is
//         brought to where a step can move it: flat axes to 1e-7 of the scene's extent, opacities to 1e-6 from 0 and 1.
#pragma once

#include <vector>

#include "scenes/colmap/colmap.hpp"
#include "sim/layers/parameters.hpp"

namespace pipegs {

// At most `most` Gaussians: of more points, evenly many in their order.
Parameters start_of_points(const std::vector<ScenePoint>& points, int sh_degree, std::size_t most, unsigned threads);

// The mean of the squared distances of each point to the three nearest others; of fewer where there are not so many, 0
// for one point alone. Coordinates are finite.
std::vector<double> mean_squared_distances(const std::vector<glm::dvec3>& points, unsigned threads);

// InputError naming `file` for a scene that is antialiased or has no Gaussian that can be drawn.
Parameters start_of_scene(const std::string& file, const Scene& scene, double extent);

}  // namespace pipegs
