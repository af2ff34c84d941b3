// SPDX-License-Identifier: Apache-2.0
// pixel_words.hpp: a word of the RU's pixel buffer (a quarter of a region, or a quad) from the pixels of the golden
// model.
#pragma once

#include "cpp_model/ru/ru_aovs.hpp"
#include "cpp_model/ru/ru_quads.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

inline int pixel_word_width(const Config& config) {
  return ru_word_pixels(config) * (3 * config.rgb_w + config.t_w + 1 + config.aov_bits());
}

inline RegionState random_region(const Config& config, std::mt19937_64& rng) {
  RegionState region{};
  for (int i = 0; i < kRegionPixels; ++i) {
    region.t[i] = rng() % ((1u << (config.t_w - 1)) + 1);
    for (auto& channel : region.rgb) channel[i] = rng() % (1u << config.rgb_w);
    region.done[i] = rng() % 2;
  }
  return region;
}

inline RegionAovs random_region_aovs(const Config& config, std::mt19937_64& rng) {
  RegionAovs aovs;
  for (PixelAovs& pixel : aovs) pixel = random_record<PixelAovs>(config, rng);
  return aovs;
}

inline void copy_bits(const uint32_t* from, int first, uint32_t* to, int at, int width) {
  for (int done = 0; done < width; done += 32) {
    const int piece = std::min(32, width - done);
    put_bits(to, at + done, piece, get_bits(from, first + done, piece));
  }
}

inline Words pack_words(const Config& config, const PixelAovs& aovs) {
  Words words(static_cast<size_t>(record_words<PixelAovs>(config) + 2));
  pack(config, aovs, words.data());
  return words;
}

// A quarter, or with quads the quad that the group owns in a row of quads; the AOVs of its pixels lie above it.
inline Words pixel_word(const Config& config, const RegionState& region, int part, int group = 0,
                        const RegionAovs* aovs = nullptr) {
  Words words(pixel_word_width(config) / 32 + 2);
  const int colors = 3 * config.rgb_w, pixels = ru_word_pixels(config);
  for (int i = 0; i < pixels; ++i) {
    const PixelState pixel = region.pixel(ru_word_pixel(config, group, part, i));
    for (int j = 0; j < 3; ++j) put_bits(words.data(), i * colors + j * config.rgb_w, config.rgb_w, pixel.rgb[j]);
    put_bits(words.data(), pixels * colors + i * config.t_w, config.t_w, pixel.t);
    put_bits(words.data(), pixels * (colors + config.t_w) + i, 1, pixel.done);
    if (aovs == nullptr) continue;
    const Words packed = pack_words(config, (*aovs)[static_cast<size_t>(ru_word_pixel(config, group, part, i))]);
    copy_bits(packed.data(), 0, words.data(), pixels * (colors + config.t_w + 1) + i * config.aov_bits(),
              config.aov_bits());
  }
  return words;
}

// The pixel of a word that differs first, as text; empty when the words are equal.
inline std::string pixel_difference(const Config& config, const Words& expected, const Words& found) {
  const int colors = 3 * config.rgb_w, pixels = ru_word_pixels(config);
  for (int i = 0; i < pixels; ++i) {
    std::string text[2];
    for (int side = 0; side < 2; ++side) {
      const uint32_t* words = (side == 0 ? expected : found).data();
      for (int j = 0; j < 3; ++j)
        text[side] += std::to_string(get_bits(words, i * colors + j * config.rgb_w, config.rgb_w)) + " ";
      text[side] += "T " + std::to_string(get_bits(words, pixels * colors + i * config.t_w, config.t_w));
      text[side] += get_bits(words, pixels * (colors + config.t_w) + i, 1) ? " done" : "";
      for (int bit = config.aov_bits(); bit-- > 0;) {
        if (bit == config.aov_bits() - 1) text[side] += " AOVs ";
        text[side] += get_bits(words, pixels * (colors + config.t_w + 1) + i * config.aov_bits() + bit, 1) ? "1" : "0";
      }
    }
    if (text[0] != text[1]) return "pixel " + std::to_string(i) + ": expected rgb " + text[0] + ", found " + text[1];
  }
  return "";
}

}  // namespace pipegs
