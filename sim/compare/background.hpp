// SPDX-License-Identifier: Apache-2.0
// background.hpp: a frame over a background, from its pixels as they lie in the machine's memory.
//
// Idea    The machine blends over black and leaves in each pixel the share T of what lies behind (ru_resolve.hpp), so
//         the host adds T times the background. All are integers: colour u2.14, T u1.15, background n / 255; a code is
//         255 colour + T background, rounded half up, 255 at most. Over black it is the machine's own 8-bit picture.
// Rule    PixelW 64: pixels of 32 bits hold no T.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "cpp_model/float/projection.hpp"

namespace pipegs {

using Background = std::array<uint8_t, 3>;  // red, green, blue

inline uint8_t over_background(uint64_t color, uint64_t t, uint8_t background) {
  const uint64_t code = (2 * 255 * color + t * background + (uint64_t{1} << 14)) >> 15;
  return static_cast<uint8_t>(std::min<uint64_t>(code, 255));
}

// `pixels`: those of a frame of this width, row by row; `part` of them is shown.
inline Rgb8 over_background(const std::vector<uint64_t>& pixels, int width, const PixelRect& part,
                            const Background& background) {
  Rgb8 picture{part.x1 - part.x0, part.y1 - part.y0, {}};
  for (int y = part.y0; y < part.y1; ++y) {
    for (int x = part.x0; x < part.x1; ++x) {
      const uint64_t pixel = pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
      for (size_t j = 0; j < 3; ++j)
        picture.data.push_back(over_background(pixel >> 16 * j & 0xffff, pixel >> 48, background[j]));
    }
  }
  return picture;
}

}  // namespace pipegs
