// SPDX-License-Identifier: Apache-2.0
// ru_lanes.cpp: see ru_lanes.hpp.
#include "cpp_model/ru/ru_lanes.hpp"

// The loop is compiled twice where the compiler can choose at run time.
#if defined(__x86_64__) && defined(__linux__)
#define PIPEGS_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define PIPEGS_CLONES
#endif

namespace pipegs {
namespace {

struct LoopResult {
  uint32_t blended, stopped, saturated, done;
};

template <class Wide>
inline __attribute__((always_inline)) LoopResult blend_loop(const BlendConstants& k, RegionState& s,
                                                            const uint16_t* codes, const uint32_t* color) {
  const int alpha_shift = k.alpha_w, color_shift = k.color_shift;
  const Wide alpha_half = Wide{1} << (alpha_shift - 1), color_half = Wide{1} << (color_shift - 1);
  const uint32_t stop_at = k.stop, rest = k.rest, rgb_max = k.rgb_max, rgb_top = k.rgb_top;
  const Wide c0 = color[0], c1 = color[1], c2 = color[2];
  LoopResult sum{0, 0, 0, 0};
  for (int i = 0; i < kRegionPixels; ++i) {
    const uint32_t t = s.t[i], was_done = s.done[i];
    const auto product = static_cast<uint32_t>((Wide{t} * codes[i] + alpha_half) >> alpha_shift);
    const uint32_t over = t - product < stop_at ? 1u : 0u, last = (t < rest ? 1u : 0u) & (codes[i] != 0 ? 1u : 0u);
    const uint32_t stops = over | last;
    const uint32_t live = (was_done | over) - 1u;  // all ones when the pixel takes the Gaussian
    const uint32_t weight = (last != 0 ? t : product) & live;
    const uint32_t r = s.rgb[0][i] + static_cast<uint32_t>((Wide{weight} * c0 + color_half) >> color_shift);
    const uint32_t g = s.rgb[1][i] + static_cast<uint32_t>((Wide{weight} * c1 + color_half) >> color_shift);
    const uint32_t b = s.rgb[2][i] + static_cast<uint32_t>((Wide{weight} * c2 + color_half) >> color_shift);
    s.t[i] = t - weight;
    s.done[i] = was_done | stops;
    s.rgb[0][i] = r > rgb_max ? rgb_top | (r & rgb_max) : r;
    s.rgb[1][i] = g > rgb_max ? rgb_top | (g & rgb_max) : g;
    s.rgb[2][i] = b > rgb_max ? rgb_top | (b & rgb_max) : b;
    sum.blended += live & (codes[i] != 0 ? 1u : 0u);
    sum.stopped += stops & ~was_done & 1u;
    sum.saturated += (r > rgb_max ? 1u : 0u) + (g > rgb_max ? 1u : 0u) + (b > rgb_max ? 1u : 0u);
    sum.done += was_done | stops;
  }
  return sum;
}

PIPEGS_CLONES LoopResult blend_narrow(const BlendConstants& k, RegionState& s, const uint16_t* codes,
                                      const uint32_t* color) {
  return blend_loop<uint32_t>(k, s, codes, color);
}

LoopResult blend_wide(const BlendConstants& k, RegionState& s, const uint16_t* codes, const uint32_t* color) {
  return blend_loop<uint64_t>(k, s, codes, color);
}

}  // namespace

bool RegionState::all_done() const {
  uint32_t all = 1;
  for (const uint32_t one : done) all &= one;
  return all != 0;
}

RegionState ru_fresh_region(const Config& config, const Frame& frame, uint64_t window_x, uint64_t window_y,
                            int region) {
  const BlendConstants constants(config);
  RegionState state{};
  const uint64_t x0 = window_x * config.window + 8 * static_cast<uint64_t>(region_x(config, region));
  const uint64_t y0 = window_y * config.window + 8 * static_cast<uint64_t>(region_y(config, region));
  for (int i = 0; i < kRegionPixels; ++i) {
    state.t[i] = constants.one;
    state.done[i] = x0 + i % 8 >= frame.raster.width || y0 + i / 8 >= frame.raster.height;
  }
  return state;
}

bool ru_blend_region(const BlendConstants& constants, RegionState& state, const uint16_t codes[kRegionPixels],
                     const uint32_t color[3], BlendCounts* counts) {
  const LoopResult sum =
      constants.narrow ? blend_narrow(constants, state, codes, color) : blend_wide(constants, state, codes, color);
  if (counts != nullptr) {
    counts->blended += sum.blended;
    counts->stopped += sum.stopped;
    counts->saturated += sum.saturated;
  }
  return sum.done == kRegionPixels;
}

}  // namespace pipegs
