// SPDX-License-Identifier: Apache-2.0
// difference.hpp: how far a picture is from the one in exact order, and several frames together.
#pragma once

#include <vector>

#include "cpp_model/float/image.hpp"

namespace pipegs {

// Of colours clamped to [0, 1], as a screen shows them.
struct Difference {
  double psnr_db = 0;  // peak 1; +infinity for equal pictures
  double largest = 0;  // of a channel of a pixel, 0 to 1
  double visible = 0;  // share of the pixels with a channel that differs by more than 1/255
};
Difference difference(const Image& found, const Image& exact);

// Of frames of one size: PSNR of their mean squared error, the largest of all, the mean share.
Difference together(const std::vector<Difference>& frames);
double worst_db(const std::vector<Difference>& frames);

}  // namespace pipegs
