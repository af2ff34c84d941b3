// SPDX-License-Identifier: Apache-2.0
// jpeg: a photograph in JPEG, by libjpeg.
//
// Rule    The size in the header is held against the caller's before memory is taken. A picture that ends early or
//         holds codes that are none is refused; libjpeg would fill it with grey.
// Errors  InputError with libjpeg's own words.
#pragma once

#include <filesystem>

#include "cpp_model/float/image.hpp"

namespace pipegs {

// 8-bit RGB of exactly this size.
Rgb8 read_jpeg(const std::filesystem::path& path, int width, int height);

}  // namespace pipegs
