// SPDX-License-Identifier: Apache-2.0
// frame_ports: gives a module under test the parts of a frame that it has ports for.
//
// Idea    A module takes only what it looks at: the whole frame, one of its records, a single field, or one of its
//         areas. The name of the port says which. Unless a test says otherwise, the areas have room for all.
#pragma once

#include <algorithm>
#include <array>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/dopu/walk.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

inline constexpr uint64_t kWideLines = uint64_t{1} << 33, kOverflowLines = uint64_t{1} << 30;
inline Areas wide_areas() {
  return {kWideLines, kWideLines, kWideLines, kWideLines, kWideLines, kWideLines, kOverflowLines, kWideLines};
}
inline Span wide_overflow(const Frame& frame) { return overflow_span(frame, wide_areas()); }

inline uint64_t cut_bits(int64_t value, int width) {
  return static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1);
}

// What dopu_test knows of the eyes; `of`: whom either set of planes is for.
template <class Dut>
void write_test_eyes(const Config& config, Dut& dut, const Frame& frame, const std::array<int, 2>& of) {
  Words words(8);
  int at = 0;
  const auto put = [&](int bits, uint64_t value) { put_bits(words.data(), at, bits, value), at += bits; };
  for (const int eye : of) put(1, eye == 1);
  for (const int eye : of) put(1, eye != kAllEyes);
  put(config.eye_reach_w(), frame.eyes.reach_x), put(1, frame.eyes.half_x < 0);
  put(config.eye_reach_w(), frame.eyes.reach_y), put(1, frame.eyes.half_y < 0);
  put(config.exp_w(), frame.eyes.length);
  if (config.eyes == 1) std::fill(words.begin(), words.end(), 0);
  write_port(dut.test_eyes_i, words.data());
}

template <class Dut>
void write_frame(const Config& config, Dut& dut, const Frame& frame, const Areas& areas = wide_areas()) {
// clang-format off
#define RECORD_PORT(port, part) if constexpr (requires { dut.port; }) write_record(config, dut.port, frame.part);
#define FIELD_PORT(port, part) if constexpr (requires { dut.port; }) dut.port = frame.part;
#define HALF_PORT(port, part) \
  if constexpr (requires { dut.port; }) dut.port = cut_bits(frame.part, std::max(1, config.half_eye_w()));
#define SPAN_PORT(port, part) \
  if constexpr (requires { dut.port; }) write_record(config, dut.port, Span{frame.tables.part, areas.part});
  if constexpr (requires { dut.frame_i; }) write_record(config, dut.frame_i, frame);
  if constexpr (requires { dut.areas_i; }) write_record(config, dut.areas_i, areas);
  RECORD_PORT(camera_i, camera)
  RECORD_PORT(position_i, camera.position)
  RECORD_PORT(rotation_i, camera.rotation)
  RECORD_PORT(quaternion_i, camera.quaternion)
  RECORD_PORT(lens_i, lens)
  RECORD_PORT(grid_i, grid)
  RECORD_PORT(tables_i, tables)
  RECORD_PORT(raster_i, raster)
  RECORD_PORT(windows_i, raster.windows)
  FIELD_PORT(focal_x_i, lens.focal_x)
  FIELD_PORT(focal_y_i, lens.focal_y)
  FIELD_PORT(near_plane_i, lens.near_plane)
  SPAN_PORT(cells_i, cells)
  SPAN_PORT(groups_i, groups)
  SPAN_PORT(chunks_i, chunks)
  SPAN_PORT(gaussians_i, gaussians)
  SPAN_PORT(colors_i, colors)
  SPAN_PORT(overflow_i, overflow)
  FIELD_PORT(sh_degree_i, tables.sh_degree)
  FIELD_PORT(pixels_i, tables.pixels)
  if constexpr (requires { dut.test_eyes_i; }) write_test_eyes(config, dut, frame, {kAllEyes, kAllEyes});
  HALF_PORT(half_x_i, eyes.half_x)
  HALF_PORT(half_y_i, eyes.half_y)
#undef RECORD_PORT
#undef SPAN_PORT
#undef FIELD_PORT
#undef HALF_PORT
  // clang-format on
}

}  // namespace pipegs
