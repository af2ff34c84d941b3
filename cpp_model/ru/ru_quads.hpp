// SPDX-License-Identifier: Apache-2.0
// ru_quads: of a region only the quads of 2x2 pixels that a splat changes are blended (quads = 1).
//
// Paper   Sec. 4.2.3, Table 2 (sixteen Rendering Units per RU, here four groups of four lanes).
// Idea    Pixels have no order among each other, so each group blends its own quads at its own pace. Row r of the quads
//         of a region gives group g its column (g + 2 r) mod 4: a splat over few quads keeps all groups busy. A quad
//         lives when a pixel of it has an alpha and not all four have stopped; no other quad would change.
// Stream  64 alpha codes of a region, row by row; its quads, numbered row by row, as a mask.
// RTL     rtl/ru/live/ru_power.sv (what lives), rtl/ru/live/ru_quads.sv (blending), rtl/ru/live/ru_live.sv (groups)
#pragma once

#include "cpp_model/ru/ru_lanes.hpp"

namespace pipegs {

inline constexpr int kQuadPixels = 4;
inline constexpr int kQuads = kRegionPixels / kQuadPixels;

// The quad that a group owns in a row of quads.
inline int ru_quad(int group, int row) { return 4 * row + (group + 2 * row) % 4; }

// Pixel i of a quad as a pixel of its region, row by row both.
inline int ru_quad_pixel(int quad, int i) { return 8 * (quad / 4 * 2 + i / 2) + quad % 4 * 2 + i % 2; }

// The quads of which all pixels have stopped or lie outside the image.
inline uint32_t ru_stopped_quads(const RegionState& state) {
  uint32_t stopped = (1u << kQuads) - 1;
  for (int quad = 0; quad < kQuads; ++quad) {
    for (int i = 0; i < kQuadPixels; ++i) {
      if (!state.done[ru_quad_pixel(quad, i)]) stopped &= ~(1u << quad);
    }
  }
  return stopped;
}

// The quads that live.
inline uint32_t ru_live_quads(const uint16_t codes[kRegionPixels], uint32_t stopped) {
  uint32_t live = 0;
  for (int quad = 0; quad < kQuads; ++quad) {
    for (int i = 0; i < kQuadPixels; ++i) live |= uint32_t{codes[ru_quad_pixel(quad, i)] != 0} << quad;
  }
  return live & ~stopped;
}

// Blends one Gaussian into a quad of a region.
inline void ru_blend_quad(const BlendConstants& k, RegionState& state, int quad, const uint16_t codes[kRegionPixels],
                          const uint32_t color[3], BlendCounts* counts = nullptr) {
  for (int i = 0; i < kQuadPixels; ++i) {
    const int at = ru_quad_pixel(quad, i);
    PixelState pixel = state.pixel(at);
    ru_blend(k, pixel, codes[at], color, counts);
    state.t[at] = pixel.t;
    for (int j = 0; j < 3; ++j) state.rgb[j][at] = pixel.rgb[j];
    state.done[at] = pixel.done;
  }
}

// The pixels in a word of the pixel buffer, and in what a lane of taps shows of it.
inline int ru_word_pixels(const Config& c) { return c.quads ? kQuadPixels : 16; }

// Pixel i of such a word as a pixel of its region: of the quad of a group in a row of quads, or of a quarter.
inline int ru_word_pixel(const Config& c, int group, int part, int i) {
  return c.quads ? ru_quad_pixel(ru_quad(group, part), i) : 16 * part + i;
}

}  // namespace pipegs
