// metrics: how far two images are apart.
//
// Idea    psnr = -10 log10(mean squared difference), peak 1, over r, g, b of all pixels, each value
//         clamped to [0,1] first since that is what a screen shows. Equal images give +infinity.
//         max_abs_error looks at the unclamped values: it is meant for finding a wrong bit.
// Rule    Images of different size are a caller's error: std::invalid_argument with both sizes.
#pragma once

#include "cpp_model/float/image.hpp"

namespace pipegs {

double psnr(const Image& a, const Image& b);
double max_abs_error(const Image& a, const Image& b);

}  // namespace pipegs
