// SPDX-License-Identifier: Apache-2.0
// metrics: how far two images are apart.
//
// Idea    psnr = -10 log10(mean squared difference), peak 1, over r, g, b of all pixels, each value
//         clamped to [0,1] first since that is what a screen shows. Equal images give +infinity.
//         max_abs_error looks at the unclamped values: it is meant for finding a wrong bit.
//         ssim (Wang et al. 2004): per channel and window of 11x11 pixels, weighted by a Gaussian of sigma 1.5,
//           (2 ma mb + C1)(2 sab + C2) / ((ma^2 + mb^2 + C1)(saa + sbb + C2)),  C1 = 0.01^2, C2 = 0.03^2
//         on clamped values, averaged over all windows that lie wholly in the image and over the channels.
// Rule    Images of different size are a caller's error: std::invalid_argument with both sizes.
#pragma once

#include "cpp_model/float/image.hpp"

namespace pipegs {

double psnr(const Image& a, const Image& b);
double max_abs_error(const Image& a, const Image& b);

// Absolute errors of the unclamped values, all channels of all pixels: the smallest that `share` (0 to 1) of them do
// not exceed. 1 gives max_abs_error.
double percentile_abs_error(const Image& a, const Image& b, double share);

// 1 for equal images; NaN for images with a side below 11 pixels.
double ssim(const Image& a, const Image& b);

}  // namespace pipegs
