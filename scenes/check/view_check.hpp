// SPDX-License-Identifier: Apache-2.0
// view_check: whether a view can show anything of a scene, and why not: before anything is drawn.
//
// Idea    A Gaussian is behind the camera, nearer than the near plane, beside the picture, or in it. A scene whose unit
//         is small, as COLMAP's may be, lies wholly before a near plane of 0.2; one in other axes than its cameras lies
//         behind them.
// Rule    Of a view of which kSample Gaussians say that it shows something no more are asked; of the others all are, of
//         the first kSearched of them.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/check/finding.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

Findings check_views(const Scene& scene, std::span<const Camera> cameras, double near_plane);

// The same of points of photographs, to be trained on.
Findings check_views(const std::vector<glm::dvec3>& points, std::span<const Camera> cameras, double near_plane);

}  // namespace pipegs
