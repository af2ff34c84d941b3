// SPDX-License-Identifier: Apache-2.0
// frame_areas.cpp: see frame_areas.hpp.
#include "cpp_model/areas/frame_areas.hpp"

#include "cpp_model/eyes.hpp"
#include "cpp_model/frame_setup.hpp"

namespace pipegs {

uint64_t overflow_area(const Config& config, uint64_t slots, uint64_t windows) {
  const pipegs_configuration machine = driver_configuration(config);
  return pipegs_overflow_size(&machine, slots, windows) / machine.line;
}

void move_frame(Frame& frame, uint64_t lines) {
  Tables& tables = frame.tables;
  if (frame.raster.aovs.lines != 0) frame.raster.aovs.base += lines;
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

Areas frame_areas(const Config& config, const PackedScene& scene, const Frame& frame, const Picture& picture) {
  const MemoryLayout& at = scene.layout;
  Areas areas;
  areas.cells = at.groups - at.cells;
  areas.groups = at.chunks - at.groups;
  areas.chunks = at.gaussians - at.chunks;
  areas.gaussians = at.colors - at.gaussians;
  areas.colors = at.pixels - at.colors;
  areas.pixels = static_cast<uint64_t>(config.eyes) * pixel_area(config, frame.raster.width, frame.raster.height);
  areas.overflow = overflow_area(config, scene.gaussians.size(), frame_windows(frame));
  areas.picture = picture.format != 0 ? picture.stride * frame.raster.height : 0;
  if (picture.format != 0 && wants_eye(config, frame, 1)) areas.picture += frame.raster.eye_lines;
  return areas;
}

}  // namespace pipegs
