// SPDX-License-Identifier: Apache-2.0
// photo_loss: how far a picture is from the one that it should be, and its derivative by every pixel.
//
// Paper   L_origin of Eq. 6: the loss of 3D Gaussian splatting, (1 - w) L1 + w (1 - SSIM), w = 0.2.
// Idea    As INRIA computes it: SSIM in windows of 11x11 pixels weighted by a Gaussian of sigma 1.5, beyond the edge
//         all is 0, the mean over all pixels and channels. That is another measure than ssim() of metrics.hpp, which
//         takes only windows that lie inside, and clamps.
//         SSIM depends on the picture through three blurred planes, p, p^2 and p q, so its derivative is three blurs.
//         A photograph has noise, reflections and blur that no scene explains. A computed picture can be met to the
//         last bit, so its loss is the mean squared difference, that of PSNR: where it is met the derivative is 0 and
//         nothing moves, while that of L1 has the same size as ever.
// Rule    Planes are float, or double for the tests; sums over pixels are double in the order of the pixels.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pipegs {

// `d_picture` (may be null) is overwritten. std::invalid_argument for pictures that have not width * height pixels.
double photo_loss(const std::vector<glm::vec3>& picture, const std::vector<glm::vec3>& photo, int width, int height,
                  double dssim_weight, std::vector<glm::vec3>* d_picture);
double photo_loss(const std::vector<glm::dvec3>& picture, const std::vector<glm::dvec3>& photo, int width, int height,
                  double dssim_weight, std::vector<glm::dvec3>* d_picture);

// From a computed picture. `d_picture` is overwritten. std::invalid_argument for pictures of different sizes.
double squared_loss(const std::vector<glm::vec3>& picture, const std::vector<glm::vec3>& wanted,
                    std::vector<glm::vec3>* d_picture);

}  // namespace pipegs
