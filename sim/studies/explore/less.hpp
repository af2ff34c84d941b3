// SPDX-License-Identifier: Apache-2.0
// less.hpp: a view with less of it drawn: the scene without the Gaussians that add least, a picture of fewer pixels
// (scaled_camera) brought back to full size, pixels that stop early (SimulateOptions::rest), proxies (lod_pixels).
//
// Idea    A Gaussian's contribution is the largest weight alpha T that it has at any pixel of any camera, as RadSplat
//         (arXiv 2403.13806) prunes by. What no camera sees has none and goes first.
//         Both pictures cover the same rectangle: pixel i of n reaches from i / n to (i + 1) / n of it. Back to full
//         size by Catmull-Rom splines (libstb), in float, what lies outside the picture as its nearest pixel; the
//         colours alone.
// Rule    Cameras are those of the file, the view that is measured among them: elsewhere more may be missing.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct Less {
  double scale = 1;    // of the picture's sides
  double without = 0;  // share of the Gaussians that is left out
  double rest = 0;     // transmittance at which a pixel stops
  double lod = 0;      // pixels: proxies that differ by less stand for groups
  bool operator==(const Less&) const = default;
};

// Of each Gaussian, in float64 and depth order; `progress` is called with 0 to 1.
std::vector<float> contributions(const Scene& scene, const std::vector<Camera>& cameras, double near_plane,
                                 const std::function<void(double)>& progress);

// How many of `count` Gaussians a share is: the nearest number.
size_t left_out(size_t count, double without);
// The scene without its share `without` (0 to 1) of least contribution; equal ones by index, the first go.
Scene without_least(const Scene& scene, const std::vector<float>& contributions, double without);

// The picture's colours at another size. OwnFailure when there is no memory for it.
Image resampled(const Image& image, int width, int height);

}  // namespace pipegs
