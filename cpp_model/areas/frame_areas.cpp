// SPDX-License-Identifier: Apache-2.0
// frame_areas.cpp: see frame_areas.hpp.
#include "cpp_model/areas/frame_areas.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace pipegs {
namespace {

constexpr uint64_t kGibibyte = uint64_t{1} << 24;  // lines

}  // namespace

uint64_t overflow_area(const Config& c, uint64_t slots, uint64_t windows) {
  const auto units = static_cast<uint64_t>(c.units), regions = static_cast<uint64_t>(c.regions());
  uint64_t share = 0;  // of a unit
  if (c.overflow) {
    const uint64_t records =
        std::clamp<uint64_t>(slots * static_cast<uint64_t>(c.parts()), 64, kGibibyte / (2 * units));
    share = 2 * records;
  }
  if (has_alpha_areas(c)) {
    const uint64_t layers = c.has_lists() ? 1 : 2;
    const uint64_t lines =
        slots * regions * (c.has_lists() ? windows : 1) * static_cast<uint64_t>(c.alpha_memory_lines());
    share = 2 * std::max(share, layers * std::clamp<uint64_t>(lines, 64, kGibibyte / (layers * units)));
  }
  share = (share + 15) / 16 * 16;  // every part is exact
  if (!c.has_lists()) return units * share;
  uint64_t list = std::bit_ceil(std::clamp<uint64_t>(slots + 1, 64, uint64_t{1} << c.list_entry_w()));
  while (list > 1 && windows * list > 2 * kGibibyte) list /= 2;
  return 2 * std::max(units * share, windows * list);
}

void move_tables(Tables& tables, uint64_t lines) {
  for (uint64_t* at : {&tables.cells, &tables.groups, &tables.chunks, &tables.gaussians, &tables.colors, &tables.pixels,
                       &tables.overflow})
    *at += lines;
}

uint64_t frame_windows(const Frame& frame) {
  const Windows& w = frame.raster.windows;
  return (w.last_x - w.first_x + 1) * (w.last_y - w.first_y + 1);
}

Span overflow_span(const Frame& frame, const Areas& areas) { return {frame.tables.overflow, areas.overflow}; }

uint64_t pixel_area(const Config& config, uint64_t width, uint64_t height) {
  const auto side = static_cast<uint64_t>(config.window);
  const uint64_t windows = (width + side - 1) / side * ((height + side - 1) / side);
  return windows * side * side / static_cast<uint64_t>(config.memory_w() / config.pixel_w);
}

Areas frame_areas(const Config& config, const PackedScene& scene, const Frame& frame) {
  const MemoryLayout& at = scene.layout;
  Areas areas;
  areas.cells = at.groups - at.cells;
  areas.groups = at.chunks - at.groups;
  areas.chunks = at.gaussians - at.chunks;
  areas.gaussians = at.colors - at.gaussians;
  areas.colors = at.pixels - at.colors;
  areas.pixels = pixel_area(config, frame.raster.width, frame.raster.height);
  areas.overflow = overflow_area(config, scene.gaussians.size(), frame_windows(frame));
  return areas;
}

}  // namespace pipegs
