// SPDX-License-Identifier: Apache-2.0
// gaze_parts: the cameras of one picture in several frames, finer where an eye looks, and that picture from theirs.
//
// Idea    The driver cuts the picture (cpp_model/driver/pipegs_gaze.h), as a user's program does. Joined, a pixel shows
//         its sample's colour, or a blend of the four samples whose centres are nearest, of those that are as large;
//         where one of them is not, it shows its own. That is a display's work: the machine writes samples.
#pragma once

#include <array>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "scenes/camera.hpp"

namespace pipegs {

struct Gaze {
  int x = 0, y = 0;        // pixel at which the eye looks
  int full = 0, half = 0;  // pixels to each side of it, up to which samples have one pixel, and two in each direction
};

struct GazePart {
  Camera camera;     // its sizes and lens in samples
  int x = 0, y = 0;  // pixel of the picture at which it begins
  int pitch = 0;     // a sample is 2^pitch pixels wide and high
  int side() const { return 1 << pitch; }
};

// Throws FrameError when the driver cuts no parts of this camera's picture.
std::vector<GazePart> gaze_parts(const Camera& camera, const Gaze& gaze);

// The picture of `whole` from those of its parts, colours and T; of each pixel the pitch of its sample.
struct GazePicture {
  Image repeated, smooth;
  std::vector<int> pitch;
};
GazePicture join_gaze(const Camera& whole, const std::vector<GazePart>& parts, const std::vector<Image>& images);

}  // namespace pipegs
