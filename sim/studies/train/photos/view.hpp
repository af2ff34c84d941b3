// SPDX-License-Identifier: Apache-2.0
// view: what the training looks at: a camera and the picture that it should give.
//
// Idea    Photographs are kept as their 8-bit codes, pictures that were computed as floats; both are handed out as
//         floats from 0 to 1 a picture at a time.
// Rule    Every 8th view in the order of names, the first one among them, is held out: it is measured and never trained
//         on (INRIA's llffhold). Of a folder with a test.txt those that it names.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "cpp_model/frame_setup.hpp"
#include "scenes/camera.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct TrainingView {
  Camera camera;
  std::vector<std::uint8_t> codes;  // r, g, b of each pixel; or
  std::vector<glm::vec3> computed;
  double near_plane = kNearPlane;

  std::vector<glm::vec3> picture() const;
  Image image() const;  // opaque
};

struct TrainingViews {
  std::vector<TrainingView> trained, held_out;
  double extent = 1;  // of the scene, as the cameras tell it: 1.1 times the largest distance from their middle
};

inline constexpr std::size_t kHeldOutEvery = 8;

// Called with 0..1, rising; it may throw.
using Advance = std::function<void(double)>;

// The photographs of the folder, their sides divided by `downscale`. What had to be done to them is found.
TrainingViews views_of_photographs(const ColmapFolder& folder, int downscale, double near_plane, const Advance& advance,
                                   Findings& findings);
// Where the near plane of views of these points is to be: INRIA's, unless more than a few of them lie before it.
double near_plane_of(const ColmapFolder& folder, Findings& findings);

// What the float64 truth draws of the scene in exact order from cameras whose sides are divided by `downscale`.
TrainingViews views_of_scene(const Scene& scene, std::vector<Camera> cameras, int downscale, unsigned threads,
                             const Advance& advance, double near_plane = kNearPlane);

}  // namespace pipegs
