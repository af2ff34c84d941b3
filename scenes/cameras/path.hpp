// SPDX-License-Identifier: Apache-2.0
// path: frames along a smooth way through the views of a file.
//
// Idea    From one key view to the next takes equally many frames. Positions, principal points and logarithms of focal
//         lengths follow Catmull-Rom splines, rotations spherical ones (squad): both pass through every key view, and
//         speed has no jump there. Before the first and behind the last view the line goes straight on.
// Rule    A frame that falls on a key view is that view to the bit. Of two views it is a straight line at even speed.
// Errors  InputError: fewer than two views, or views of several sizes.
#pragma once

#include <vector>

#include "scenes/camera.hpp"

namespace pipegs {

// `frames`, at least two, from the first key view to the last.
std::vector<Camera> camera_path(const std::vector<Camera>& keys, int frames);

}  // namespace pipegs
