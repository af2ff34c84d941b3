// SPDX-License-Identifier: Apache-2.0
// aov_image.cpp: see aov_image.hpp.
#include "cpp_model/aov_image.hpp"

#include <cmath>

namespace pipegs {

double key_depth(const PackedScene& packed, uint64_t key) {
  const int mantissa_bits = packed.config.depth_w - 6;
  const double mantissa =
      1 + std::ldexp(static_cast<double>(key & ((uint64_t{1} << mantissa_bits) - 1)), -mantissa_bits);
  return std::ldexp(mantissa, static_cast<int>(key >> mantissa_bits) + packed.scene_exponent);
}

void show_aovs(const PackedScene& packed, const Frame& frame, const AovPixels& aovs, Image& image) {
  const auto& [coverage, depth, median, index] = aovs;
  const int range = static_cast<int>(frame.raster.aovs.range) + 1 + packed.scene_exponent;
  const auto to_depth = [&](uint32_t word) { return std::ldexp(static_cast<double>(word), range - 32); };
  for (size_t i = 0; i < coverage.size(); ++i) {
    image.transmittance[i] = std::ldexp(static_cast<double>(coverage[i] & 0xffff), -15);
    image.blended[i] = coverage[i] >> 16;
  }
  for (size_t i = 0; i < depth.size(); ++i) image.depth[i] = to_depth(depth[i]);
  image.median.resize(median.size());
  for (size_t i = 0; i < median.size(); ++i) image.median[i] = to_depth(median[i]);
  image.index.resize(index.size());
  for (size_t i = 0; i < index.size(); ++i)
    image.index[i] = index[i] == kNoGaussian ? kNoGaussian : packed.scene_index(index[i]);
}

}  // namespace pipegs
