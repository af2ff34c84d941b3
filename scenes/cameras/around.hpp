// SPDX-License-Identifier: Apache-2.0
// around: views about each view of a file: what a person sees who looks round there.
//
// Idea    Each is the view of the file, moved by up to a tenth of the way to the nearest other one along each axis of
//         the world, and turned by up to 8 degrees about a direction drawn by chance. The same seed gives the same.
// Rule    The views of the file stay as they are; those about one follow it, around_NAME_1 and so on.
#pragma once

#include <cstdint>
#include <vector>

#include "scenes/camera.hpp"

namespace pipegs {

std::vector<Camera> cameras_around(const std::vector<Camera>& views, int each, std::uint64_t seed);

}  // namespace pipegs
