// SPDX-License-Identifier: Apache-2.0
// squared_loss: how far a picture is from one that was computed, and its derivative by every pixel.
//
// Idea    The mean squared difference, that of PSNR. A photograph has noise, reflections and blur that no scene
//         explains, so its loss is L1 and SSIM (photo_loss.hpp). A computed picture can be met to the last bit: where
//         it is met, the derivative of the square is 0 and nothing moves, while that of L1 has the same size as ever.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pipegs {

// `d_picture` is overwritten. std::invalid_argument for pictures of different sizes.
double squared_loss(const std::vector<glm::vec3>& picture, const std::vector<glm::vec3>& wanted,
                    std::vector<glm::vec3>* d_picture);

}  // namespace pipegs
