// SPDX-License-Identifier: Apache-2.0
// ru_blend: one lane of an RU (the paper's Rendering Unit) blends one Gaussian into one pixel, front to back.
//
// Paper   Eq. 2: C += c * alpha * T,  T *= 1 - alpha.
// Idea    One product serves weight and update: w = T * alpha, T' = T - w. T plus the sum of all weights so stays
//         exactly 1. INRIA's stop rule: when T' would fall below 1/TCut (1e-4) the pixel is done and this Gaussian is
//         not blended. With a frame's `rest`: of a pixel whose T is below it the next Gaussian takes all, and the pixel
//         is done: what is left is shown in that colour, which is mostly near that of what is hidden.
// Error   of a pixel, by `rest`: less than rest times the difference of two colours.
// Stream  alpha u0.AlphaW (0: no contribution), T u1.(TW-1), colour u2.(ColorW-2), accumulated colour u2.(RgbW-2).
// Round   w and w * colour to nearest, ties up; the accumulated colour saturates at the top (counted; wraps if
//         Saturation is 0).
// RTL     rtl/ru/ru_blend.sv
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cpp_model/config.hpp"

namespace pipegs {

struct BlendConstants {
  explicit BlendConstants(const Config& c, uint64_t rest_of_frame = 0)
      : alpha_w(c.alpha_w),
        color_shift(c.t_w + c.color_w - c.rgb_w - 1),
        one(1u << (c.t_w - 1)),
        rest(c.early_stop ? static_cast<uint32_t>(rest_of_frame) : 0),
        stop(rest == 0 && c.early_stop ? static_cast<uint32_t>(c.t_stop()) : 0),
        rgb_max((1u << c.rgb_w) - 1),
        rgb_top(c.saturation ? rgb_max : 0),
        narrow(c.t_w - 1 + c.alpha_w <= 32 && c.t_w - 1 + c.color_w <= 32) {}

  int alpha_w;
  int color_shift;  // from the fraction of w * colour to that of the accumulated colour
  uint32_t one;     // T = 1
  uint32_t rest;    // Frame::raster.rest: below this T the next Gaussian takes all; 0: none does
  uint32_t stop;    // without it: smallest T that may remain; 0: none stops
  uint32_t rgb_max;
  uint32_t rgb_top;  // bits that stay set above it: all when it saturates, none when it wraps
  bool narrow;       // every product fits 32 bits
};

struct PixelState {
  uint32_t t = 0;
  uint32_t rgb[3] = {0, 0, 0};
  bool done = false;
  bool operator==(const PixelState&) const = default;
};

// Frame::raster.rest of a transmittance below 1, to nearest; of more than 0 at least the least that there is.
inline uint64_t rest_of(const Config& config, double transmittance) {
  const double unit = std::ldexp(1.0, config.rest_w());
  return static_cast<uint64_t>(std::clamp(std::round(transmittance * unit), 1.0, unit - 1));
}

// What happened, summed over calls.
struct BlendCounts {
  uint64_t blended = 0;    // pairs with alpha that changed their pixel's state
  uint64_t stopped = 0;    // pixels that became done
  uint64_t saturated = 0;  // colour channels held at the top
};

// Blends one Gaussian into one pixel; returns its weight, u1.(TW-1).
inline uint32_t ru_blend(const BlendConstants& k, PixelState& pixel, uint32_t code, const uint32_t color[3],
                         BlendCounts* counts = nullptr) {
  if (pixel.done) return 0;
  auto weight = static_cast<uint32_t>((uint64_t{pixel.t} * code + (uint64_t{1} << (k.alpha_w - 1))) >> k.alpha_w);
  const bool last = pixel.t < k.rest && code != 0, over = pixel.t - weight < k.stop;
  if (last || over) {
    pixel.done = true;
    if (counts != nullptr) ++counts->stopped;
    if (over) return 0;
    weight = pixel.t;
  }
  pixel.t -= weight;
  for (int i = 0; i < 3; ++i) {
    const auto add =
        static_cast<uint32_t>((uint64_t{weight} * color[i] + (uint64_t{1} << (k.color_shift - 1))) >> k.color_shift);
    const bool over = pixel.rgb[i] + add > k.rgb_max;
    pixel.rgb[i] = over ? k.rgb_top | ((pixel.rgb[i] + add) & k.rgb_max) : pixel.rgb[i] + add;
    if (over && counts != nullptr) ++counts->saturated;
  }
  if (code != 0 && counts != nullptr) ++counts->blended;
  return weight;
}

}  // namespace pipegs
