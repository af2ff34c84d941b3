// SPDX-License-Identifier: Apache-2.0
// framing: a camera for a scene that comes without any, or views on a circle round what it shows.
//
// Idea    A trained scene is finest where it was photographed: a Gaussian counts by its opacity over its size, so
//         backgrounds, floaters and far shells weigh little. What is to be seen is the 2..98 % box of these weights,
//         not of the means, and its centre is their median.
// Rule    A bounded thing (98 % within six times the median distance) is seen from where its box just fills the view.
//         Of an unbounded capture, which was photographed from within, the half about the centre fills it. A room, with
//         a roof over most of a ring round its centre and wider than high, is seen from within, from the place on that
//         ring where least hides what lies opposite.
// Axes    Up is -y as in INRIA's scenes, unless x or z is a quarter of both other sides or less, as up is of rooms and
//         grounds: then that axis. The camera looks along +z (+y where z is up), 20 degrees down outside, level inside.
#pragma once

#include <optional>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct Framing {
  int width = 1280, height = 720;
  int views = 1;    // on a circle about the axis that points up; the first is the camera itself
  double fov = 60;  // degrees, from the left to the right side of the picture
  std::optional<glm::dvec3> from, look_at, up;  // what is none is found
};

// InputError with the scene's name when it has nothing to see, or when the framing has no direction.
std::vector<Camera> framed_cameras(const Scene& scene, const Framing& framing);

}  // namespace pipegs
