// SPDX-License-Identifier: Apache-2.0
// ru_lanes: blends one line of alphas into the 64 pixels of a region.
//
// Paper   Sec. 4 (sixteen Rendering Units per RU, here lanes): a region takes four cycles there.
// Idea    The same arithmetic as ru_blend, pixel by pixel, written as one loop over arrays so that compilers
//         vectorise it.
// Stream  64 alpha codes, row by row, and one colour in; the region's state is changed in place.
// RTL     rtl/ru/ru_lanes.sv
#pragma once

#include "cpp_model/records.hpp"
#include "cpp_model/regions.hpp"
#include "cpp_model/ru/ru_blend.hpp"

namespace pipegs {

inline constexpr int kRegionPixels = 64;

// The pixels of a region, row by row.
struct RegionState {
  alignas(64) uint32_t t[kRegionPixels];
  uint32_t rgb[3][kRegionPixels];
  uint32_t done[kRegionPixels];  // 0 or 1

  PixelState pixel(int i) const { return {t[i], {rgb[0][i], rgb[1][i], rgb[2][i]}, done[i] != 0}; }
  bool all_done() const;
};

// A region before its first Gaussian: T = 1, black; pixels outside the image are done.
RegionState ru_fresh_region(const Config& config, const Frame& frame, uint64_t window_x, uint64_t window_y, int region);

// Blends one Gaussian into a region. Returns whether all 64 pixels are done afterwards.
bool ru_blend_region(const BlendConstants& constants, RegionState& state, const uint16_t codes[kRegionPixels],
                     const uint32_t color[3], BlendCounts* counts = nullptr);

}  // namespace pipegs
