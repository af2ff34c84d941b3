// SPDX-License-Identifier: Apache-2.0
// ru_aovs: what an RU knows of a pixel beside its colour: how many Gaussians, how deep, which one weighs most.
//
// Paper   None: its RUs give colours.
// Idea    All follows from what blending knows: T before a Gaussian, its weight w, and whether it was blended at all.
//           blended   plus one, up to the most that there is room for
//           expected  plus w * depth: the sum of the weights is 1 - T, and background adds nothing
//           median    depth of the Gaussian with which T falls below one half
//           best      weight and index of the Gaussian that weighs most, of equal ones the nearest
//         A depth is a fraction of the frame's range: its key, exponent and mantissa, shifted (ru_linear).
// Error   of a depth half a unit and what the key leaves out, 2^-(DepthW - 6) of it; of the sum half a unit for each
//         Gaussian, beside what the weights are off.
// Stream  T, w u1.(TW-1); depth u0.LinearW; an AOV's word is 32 bits.
// Round   depth and w * depth to nearest, ties up; the sum and the count stay at the top.
// RTL     rtl/ru/aovs/
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_lanes.hpp"

namespace pipegs {

enum class Aov : int { kCoverage, kDepth, kMedian, kIndex };
inline constexpr std::array kAovs{Aov::kCoverage, Aov::kDepth, Aov::kMedian, Aov::kIndex};
inline constexpr std::array<std::string_view, kAovs.size()> kAovNames{"coverage", "depth", "median", "index"};

// Of each the pixels of a picture as they lie in memory, row by row; none where nobody wants it.
using AovPixels = std::array<std::vector<uint32_t>, kAovs.size()>;

// Whether the machine has it.
inline bool has_aov(const Config& c, Aov aov) { return (c.aovs_built() >> static_cast<int>(aov) & 1) != 0; }

// Whether a frame writes it.
inline bool wants_aov(const Config& c, const Frame& frame, Aov aov) {
  return has_aov(c, aov) && (frame.raster.aovs.wanted >> static_cast<int>(aov) & 1) != 0;
}

// Its first line: those that a frame writes lie one behind the other.
inline uint64_t aov_line(const Config& c, const Frame& frame, Aov aov) {
  uint64_t line = frame.raster.aovs.base;
  for (const Aov other : kAovs) line += other < aov && wants_aov(c, frame, other) ? frame.raster.aovs.lines : 0;
  return line;
}

// A depth key as a fraction of 2^(range + 1) world units.
inline uint32_t ru_linear(const Config& c, uint64_t key, uint64_t range) {
  const int mantissa_w = c.depth_w - c.exp_w(), linear_w = c.linear_w();
  const uint64_t exponent = key >> mantissa_w, most = (uint64_t{1} << linear_w) - 1,
                 mantissa = (uint64_t{1} << mantissa_w) | (key & ((uint64_t{1} << mantissa_w) - 1));
  if (exponent > range) return static_cast<uint32_t>(most);
  const uint64_t down = range - exponent;
  if (down > static_cast<uint64_t>(linear_w)) return 0;
  // The leading one at the top of LinearW bits, and one bit of fraction below them.
  const uint64_t aligned =
      mantissa_w > linear_w ? mantissa >> (mantissa_w - linear_w) : mantissa << (linear_w - mantissa_w);
  return static_cast<uint32_t>(std::min(((aligned >> down) + 1) >> 1, most));
}

inline PixelAovs ru_fresh_aovs(const Config& c) {
  return {.blended = 0, .expected = 0, .median = 0, .best = 0, .index = (uint64_t{1} << c.best_index_w()) - 1};
}

// A blended Gaussian: `before` is T before it, `weight` what it adds.
inline void ru_add_aovs(const Config& c, PixelAovs& pixel, uint64_t before, uint64_t weight, uint32_t depth,
                        uint64_t index) {
  const uint64_t half = uint64_t{1} << (c.t_w - 2);
  const auto most = [](int width) { return (uint64_t{1} << width) - 1; };
  pixel.blended = std::min(pixel.blended + 1, most(c.blended_w()));
  if (c.aov_depth != 0) {
    const uint64_t add = (weight * depth + half) >> (c.t_w - 1);
    pixel.expected = std::min(pixel.expected + add, most(c.expected_w()));
  }
  if (c.aov_median != 0 && before >= half && before - weight < half) pixel.median = depth;
  if (c.aov_index != 0 && weight > pixel.best) pixel.best = weight, pixel.index = index;
}

// Those of a region's pixels, row by row.
using RegionAovs = std::array<PixelAovs, kRegionPixels>;

inline RegionAovs ru_fresh_region_aovs(const Config& c) {
  RegionAovs aovs;
  aovs.fill(ru_fresh_aovs(c));
  return aovs;
}

// A Gaussian blended into a region, which was `before` and has become `after`.
inline void ru_add_region_aovs(const Config& c, const BlendConstants& k, RegionAovs& aovs, const RegionState& before,
                               const RegionState& after, const uint16_t codes[kRegionPixels], uint32_t depth,
                               uint64_t index) {
  for (int i = 0; i < kRegionPixels; ++i) {
    if (!ru_takes(k, before.pixel(i), codes[i])) continue;
    ru_add_aovs(c, aovs[static_cast<size_t>(i)], before.t[i], before.t[i] - after.t[i], depth, index);
  }
}

// A pixel of one, as it lies in memory.
inline uint64_t ru_aov_word(const Config& c, Aov aov, uint32_t t, const PixelAovs& pixel) {
  switch (aov) {
    case Aov::kCoverage: {
      const uint64_t t16 = c.t_w >= 16 ? t >> (c.t_w - 16) : uint64_t{t} << (16 - c.t_w);
      return pixel.blended << 16 | t16;
    }
    case Aov::kDepth: return pixel.expected << (32 - c.linear_w());
    case Aov::kMedian: return pixel.median << (32 - c.linear_w());
    case Aov::kIndex: break;
  }
  return pixel.index == (uint64_t{1} << c.best_index_w()) - 1 ? 0xffffffff : pixel.index;
}

}  // namespace pipegs
