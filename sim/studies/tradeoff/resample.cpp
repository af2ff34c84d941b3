// SPDX-License-Identifier: Apache-2.0
// resample.cpp: see resample.hpp.
#include "sim/studies/tradeoff/resample.hpp"

#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#include <stb/stb_image_resize.h>

#include <vector>

#include "scenes/own_failure.hpp"

namespace pipegs {

Image resampled(const Image& image, int width, int height) {
  std::vector<float> in(3 * image.rgb.size());
  for (size_t i = 0; i < image.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) in[3 * i + static_cast<size_t>(c)] = static_cast<float>(image.rgb[i][c]);
  }
  Image result(width, height);
  std::vector<float> out(3 * result.rgb.size());
  if (stbir_resize_float_generic(in.data(), image.width, image.height, 0, out.data(), width, height, 0, 3,
                                 STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP, STBIR_FILTER_CATMULLROM,
                                 STBIR_COLORSPACE_LINEAR, nullptr) == 0)
    throw OwnFailure("no memory to resample a picture");
  for (size_t i = 0; i < result.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) result.rgb[i][c] = static_cast<double>(out[3 * i + static_cast<size_t>(c)]);
  }
  return result;
}

}  // namespace pipegs
