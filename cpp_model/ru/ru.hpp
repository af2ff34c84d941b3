// SPDX-License-Identifier: Apache-2.0
// ru: a whole RU over a frame: sorted splats in, finished windows out.
//
// Paper   Fig. 7 (RU with its T and RGB buffers), Eq. 2.
// Idea    The owned regions of one window at a time; the end of a layer changes nothing, that of a window hands the
//         pixels out and starts the next window, row by row from first to last.
// Stream  sorted_t in; where lines of alphas come from and where lines of pixels go is the caller's (two functions).
// RTL     rtl/ru/pipegs_ru.sv; the window's coordinates: rtl/ru/place/ru_window.sv
#pragma once

#include <bit>
#include <vector>

#include "cpp_model/memory_line.hpp"
#include "cpp_model/ru/ru_aovs.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "cpp_model/ru/ru_walk.hpp"

namespace pipegs {

struct RuState {
  int unit = 0;
  uint64_t own = 0;                     // the regions of this RU in a part, as a mask
  uint64_t window_x = 0, window_y = 0;  // the window that is being blended
  std::vector<RegionState> regions;     // by slot
  std::vector<RegionAovs> aovs;         // likewise; none where the machine has none
  RegionSet done;                       // owned regions that are done
  BlendCounts counts;
};

// Makes the regions of the current window fresh.
inline void ru_start_window(const Config& c, const Frame& frame, RuState& state) {
  state.regions.clear();
  state.aovs.clear();
  state.done = {};
  for (int slot = 0; slot < c.regions() / c.units; ++slot) {
    const int region = ru_region(c, state.unit, slot);
    state.regions.push_back(ru_fresh_region(c, frame, state.window_x, state.window_y, region));
    state.done.add(c, region, state.regions.back().all_done());
    if (c.has_aovs()) state.aovs.push_back(ru_fresh_region_aovs(c));
  }
}

inline RuState ru_start(const Config& c, const Frame& frame, int unit) {
  RuState state{.unit = unit,
                .own = ru_own_mask(c, unit),
                .window_x = frame.raster.windows.first_x,
                .window_y = frame.raster.windows.first_y,
                .regions = {},
                .aovs = {},
                .done = {},
                .counts = {}};
  ru_start_window(c, frame, state);
  return state;
}

// Whether rows leave together with those of the RU that has the other halves of their lines (rtl/ru/write/ru_join.sv).
inline bool ru_joined(const Config& c, const Picture& picture) { return picture.format != 0 && c.units > 1; }

// Whether a region leaves the RU: one that is inside the image, or whose left neighbour on the same lines is.
inline bool ru_leaves(const Config& c, const Frame& frame, const Picture& picture, const RuState& state, int region) {
  return ru_inside(c, frame, state.window_x, state.window_y, ru_joined(c, picture) ? region / 2 * 2 : region);
}

// The requests that write a region of the current window, or of one of its AOVs, which lies `ahead` lines further:
// pixels(line address, halves of it, const MemoryLine&). by_windows(pixel), in_raster(pixel): as they lie in memory.
template <class ByWindows, class InRaster, class Pixels>
void ru_write_lines(const Config& c, const Frame& frame, const Picture& picture, const RuState& state, int region,
                    uint64_t ahead, ByWindows&& by_windows, InRaster&& in_raster, Pixels&& pixels) {
  const uint64_t x = state.window_x * c.window + 8 * static_cast<uint64_t>(region_x(c, region)),
                 y = state.window_y * c.window + 8 * static_cast<uint64_t>(region_y(c, region));
  const int rows = picture.format != 0 ? 1 : 8 / c.region_lines();  // in a request
  for (int row = 0; row < 8; row += rows) {
    MemoryLine line{};
    if (picture.format == 0) {
      for (int i = 0; i < 8 * rows; ++i)
        put_bits(line.data(), ru_pixel_bit(c, row + i / 8, i % 8), c.pixel_w, by_windows(8 * row + i));
      pixels(ru_pixel_line(c, frame, state.window_x, state.window_y, region, row) + ahead, 3, line);
    } else if (y + static_cast<uint64_t>(row) < frame.raster.height) {
      for (int i = 0; i < 8; ++i)
        put_bits(line.data(), ru_raster_bit(x + static_cast<uint64_t>(i)), 32, in_raster(8 * row + i));
      const uint64_t eye = static_cast<uint64_t>(region_eye(c, region)) * frame.raster.eye_lines;
      pixels(ru_raster_line(picture, x, y + static_cast<uint64_t>(row)) + eye + ahead, 1 << ru_raster_half(x), line);
    }
  }
}

// The requests that write a region of the current window, its AOVs behind its colours.
template <class Pixels>
void ru_write(const Config& c, const Frame& frame, const Picture& picture, const RuState& state, int region,
              Pixels&& pixels) {
  const RegionState& of = state.regions[ru_slot(c, region)];
  const auto color = [&](int i) { return ru_resolve(c, of.pixel(i)); };
  ru_write_lines(
      c, frame, picture, state, region, 0, color, [&](int i) { return ru_rgba8(c, color(i)); }, pixels);
  const uint64_t base = picture.format != 0 ? picture.base : frame.tables.pixels;
  for (const Aov aov : kAovs) {
    if (!wants_aov(c, frame, aov)) continue;
    const RegionAovs& aovs = state.aovs[ru_slot(c, region)];
    const auto word = [&](int i) { return ru_aov_word(c, aov, of.t[i], aovs[static_cast<size_t>(i)]); };
    ru_write_lines(c, frame, picture, state, region, aov_line(c, frame, aov) - base, word, word, pixels);
  }
}

// Takes one beat. codes(splat, region) gives the 64 alpha codes of a region, `const uint16_t*`;
// pixels(line address, halves, const MemoryLine&) takes a line of the finished window, or half of one.
template <class Codes, class Pixels>
void ru_take(const Config& c, const BlendConstants& k, const Frame& frame, const Picture& picture, RuState& state,
             const Sorted& splat, Codes&& codes, Pixels&& pixels) {
  if (splat.kind == kData) {
    const uint32_t color[3] = {static_cast<uint32_t>(splat.red), static_cast<uint32_t>(splat.green),
                               static_cast<uint32_t>(splat.blue)};
    for (uint64_t rest = splat.mask & state.own & ~state.done.mask[splat.part]; rest != 0; rest &= rest - 1) {
      const int region = region_number(c, splat.part, std::countr_zero(rest)), slot = ru_slot(c, region);
      const uint16_t* const of_region = codes(splat, region);
      RegionState& pixels_of = state.regions[slot];
      const RegionState before = pixels_of;
      if (ru_blend_region(k, pixels_of, of_region, color, &state.counts)) state.done.add(c, region);
      if (c.has_aovs())
        ru_add_region_aovs(c, k, state.aovs[slot], before, pixels_of, of_region,
                           ru_linear(c, splat.depth, frame.raster.aovs.range), splat.index);
    }
    return;
  }
  if (splat.kind != kWindowEnd) return;
  for (int slot = 0; slot < c.regions() / c.units; ++slot) {
    const int region = ru_region(c, state.unit, slot);
    if (ru_leaves(c, frame, picture, state, region)) ru_write(c, frame, picture, state, region, pixels);
  }
  if (state.window_x == frame.raster.windows.last_x) {
    state.window_x = frame.raster.windows.first_x;
    ++state.window_y;
  } else {
    ++state.window_x;
  }
  ru_start_window(c, frame, state);
}

}  // namespace pipegs
