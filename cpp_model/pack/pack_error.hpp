// SPDX-License-Identifier: Apache-2.0
// pack_error: how small some Gaussians must be on the screen before others may be drawn in their place.
//
// Paper   None: level of detail.
// Idea    Both sets are drawn without perspective along the three axes, blended front to back as in every picture (low
//         pass of 0.3 pixel^2, opacities cut at 1/255), at ever smaller pixels. The loss is what the pictures differ
//         by: the sum over the pixels of the mean square of three colours and the transmittance, the mean of the three
//         views. It may be `most`; the result is the smallest pixel at which it is not more.
// Rule    Nothing hides anything but what is in the sets themselves, and colours are those of SH band 0: a measure, not
//         a bound. No finer pixel than 1/128 of the widest extent is tried, and none coarser than eight
//         of them.
#pragma once

#include <span>

#include "scenes/scene.hpp"

namespace pipegs {

inline constexpr double kNeverAlike = 0;  // the sets differ by more at every size that was tried

// The side of such a pixel in scene units, or kNeverAlike. All Gaussians are such that activate() accepts them.
double alike_pixel(std::span<const ActivatedGaussian> one, std::span<const glm::vec3> one_dc,
                   std::span<const ActivatedGaussian> other, std::span<const glm::vec3> other_dc, double most);

}  // namespace pipegs
