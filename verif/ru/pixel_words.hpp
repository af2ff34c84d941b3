// SPDX-License-Identifier: Apache-2.0
// pixel_words.hpp: a word of the RU's pixel buffer (sixteen pixels) from the pixels of the golden model.
#pragma once

#include "cpp_model/ru/ru_lanes.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

inline constexpr int kLanes = 16;

inline int pixel_word_width(const Config& config) { return kLanes * (3 * config.rgb_w + config.t_w + 1); }

inline Words pixel_word(const Config& config, const RegionState& region, int quarter) {
  Words words(pixel_word_width(config) / 32 + 2);
  const int colors = 3 * config.rgb_w;
  for (int i = 0; i < kLanes; ++i) {
    const PixelState pixel = region.pixel(kLanes * quarter + i);
    for (int j = 0; j < 3; ++j) put_bits(words.data(), i * colors + j * config.rgb_w, config.rgb_w, pixel.rgb[j]);
    put_bits(words.data(), kLanes * colors + i * config.t_w, config.t_w, pixel.t);
    put_bits(words.data(), kLanes * (colors + config.t_w) + i, 1, pixel.done);
  }
  return words;
}

// The pixel of a word that differs first, as text; empty when the words are equal.
inline std::string pixel_difference(const Config& config, const Words& expected, const Words& found) {
  const int colors = 3 * config.rgb_w;
  for (int i = 0; i < kLanes; ++i) {
    std::string text[2];
    for (int side = 0; side < 2; ++side) {
      const uint32_t* words = (side == 0 ? expected : found).data();
      for (int j = 0; j < 3; ++j)
        text[side] += std::to_string(get_bits(words, i * colors + j * config.rgb_w, config.rgb_w)) + " ";
      text[side] += "T " + std::to_string(get_bits(words, kLanes * colors + i * config.t_w, config.t_w));
      text[side] += get_bits(words, kLanes * (colors + config.t_w) + i, 1) ? " done" : "";
    }
    if (text[0] != text[1]) return "pixel " + std::to_string(i) + ": expected rgb " + text[0] + ", found " + text[1];
  }
  return "";
}

}  // namespace pipegs
