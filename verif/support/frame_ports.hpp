// SPDX-License-Identifier: Apache-2.0
// frame_ports: gives a module under test the parts of a frame that it has ports for.
//
// Idea    A module takes only what it looks at: the whole frame, one of its records, or a single field. The name of the
//         port says which.
#pragma once

#include "verif/support/bench.hpp"

namespace pipegs {

template <class Dut>
void write_frame(const Config& config, Dut& dut, const Frame& frame) {
// clang-format off
#define RECORD_PORT(port, part) if constexpr (requires { dut.port; }) write_record(config, dut.port, frame.part);
#define FIELD_PORT(port, part) if constexpr (requires { dut.port; }) dut.port = frame.part;
  if constexpr (requires { dut.frame_i; }) write_record(config, dut.frame_i, frame);
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
  FIELD_PORT(groups_i, tables.groups)
  FIELD_PORT(chunks_i, tables.chunks)
  FIELD_PORT(colors_i, tables.colors)
  FIELD_PORT(sh_degree_i, tables.sh_degree)
  FIELD_PORT(pixels_i, tables.pixels)
  FIELD_PORT(overflow_i, tables.overflow)
#undef RECORD_PORT
#undef FIELD_PORT
  // clang-format on
}

}  // namespace pipegs
