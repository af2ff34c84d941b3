// SPDX-License-Identifier: Apache-2.0
// truth: the float64 reference renderer, in three semantics.
//
// Paper   Eq. 1 (projection) and Eq. 2 (blending) of 3D Gaussian splatting, without tiles, layers
//         or fixed point: what the hardware and its integer bit-accurate model are measured against.
// Idea    kExact   what the hardware promises: a Gaussian counts at a pixel iff
//                    alpha = min(0.99, opacity * exp(power)) >= 1/255     no 3-sigma truncation
//         kInria   diff-gaussian-rasterization: evaluates the 16x16 tiles that the 3-sigma square
//                  touches; 1e-7 beside w; power > 0 is skipped instead of clamped.
//         kGsplat  gsplat: half-pixel centres, opacity-aware box of at most 3.33 sigma,
//                  stops at T <= 1e-4 instead of <, keeps z = near.
//         All: +0.3 px^2 dilation, x/z clamped to 1.3 tan(fov/2) only inside J, a pixel is finished
//         by the Gaussian that would bring T below 1e-4, and that Gaussian is not blended.
// Order   Ascending options.rank, ties by index; without a rank by view depth: kExact in double,
//         the other two rounded to float, since that is their sort key.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "cpp_model/float/projection.hpp"
#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct TruthOptions {
  Semantics semantics = Semantics::kExact;
  const std::vector<std::uint32_t>* rank = nullptr;  // per Gaussian, smaller first; null: by depth
  double near_plane = 0.2;                           // in all semantics; gsplat's own default is 0.01
  bool clip_window = false;                          // render only [x0, x1) x [y0, y1)
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  unsigned threads = 0;                          // 0: as many as the machine has
  std::function<void(double)> progress;          // called with 0..1, rising, never from two threads at once
  int sh_degree = kMaxShDegree;                  // cap below the scene's own degree
  std::vector<float>* largest_weight = nullptr;  // per Gaussian: raised to the largest weight that it has at a pixel
  bool aovs = false;                             // Image::median and index, too
};

struct TruthStep {
  std::uint32_t index;  // of the Gaussian in the scene
  double power;         // natural logarithm, <= 0
  double alpha, weight, transmittance_before;
};

// Non-finite Gaussians and zero quaternions are left out. std::invalid_argument for a rank or weights of the
// wrong length or a window outside the image.
Image render_truth(const Scene& scene, const Camera& camera, const TruthOptions& options);

// The Gaussians blended at pixel (px, py) in their order; the clip window plays no role.
std::vector<TruthStep> explain_truth(const Scene& scene, const Camera& camera, const TruthOptions& options, int px,
                                     int py);

}  // namespace pipegs
