// SPDX-License-Identifier: Apache-2.0
// resample.hpp: a picture of a camera with other pixels (scaled_camera), brought back to full size.
//
// Idea    Both pictures cover the same rectangle: pixel i of n reaches from i / n to (i + 1) / n of it. Back to full
//         size by Catmull-Rom splines (libstb), in float, what lies outside the picture as its nearest pixel; the
//         colours alone.
#pragma once

#include "cpp_model/float/image.hpp"

namespace pipegs {

// The picture's colours at another size. OwnFailure when there is no memory for it.
Image resampled(const Image& image, int width, int height);

}  // namespace pipegs
