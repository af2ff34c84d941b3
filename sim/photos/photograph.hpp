// SPDX-License-Identifier: Apache-2.0
// photograph: a picture file as the camera of a COLMAP folder saw it, and the same with fewer pixels.
//
// Reads   PNG and JPEG, recognised by their first bytes, not by their names; 8 bits for a channel. Grey becomes
//         RGB; where a PNG has alpha, its colours stand over black. A JPEG that ends early or holds codes that are none
//         is refused; libjpeg would fill it with grey.
// Rule    A picture has the size that its camera says: no other is stretched to it.
// Errors  InputError with file and sizes, or with libjpeg's own words.
#pragma once

#include <filesystem>

#include "cpp_model/float/image.hpp"
#include "scenes/camera.hpp"

namespace pipegs {

Rgb8 read_photograph(const std::filesystem::path& path, const Camera& camera);

// Each pixel the mean of what it covers of the larger picture; both show the same rectangle. Codes, rounded.
Rgb8 shrunk(const Rgb8& picture, int width, int height);

}  // namespace pipegs
