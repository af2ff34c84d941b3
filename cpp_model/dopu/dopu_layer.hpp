// SPDX-License-Identifier: Apache-2.0
// dopu_layer: which slab of the grid holds the camera, and in which order the slabs are walked.
//
// Paper   Sec. 4.1: normalization unit and three-way multiplexer.        RTL  rtl/dopu/dopu_layer.sv
// Idea    The camera's own slab c = clamp(floor((camera - grid) * grid_scale / 2^WorldW), 0, Grid - 1), then outward:
//         c, c+1, c-1, c+2, c-2 ... without those outside. A ray leaves c towards one side only, so this is front to
//         back for every ray of a perspective camera, also for rays that run against the principal axis. Without slabs
//         (Layered 0, or watermarks) the cells in the order of their table, all in one layer.
#pragma once

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// Slab of the camera along an axis.
inline int dopu_layer_camera(const Config& config, const Frame& frame, int axis) {
  const int64_t camera = axis == 0   ? frame.camera.position.x
                         : axis == 1 ? frame.camera.position.y
                                     : frame.camera.position.z;
  const int64_t low = axis == 0 ? frame.grid.low.x : axis == 1 ? frame.grid.low.y : frame.grid.low.z;
  const uint64_t scale = axis == 0 ? frame.grid.scale_x : axis == 1 ? frame.grid.scale_y : frame.grid.scale_z;
  const Int128 cell = shift_floor(Int128{camera - low} * static_cast<Int128>(scale), config.world_w);
  return static_cast<int>(std::clamp<Int128>(cell, 0, config.grid - 1));
}

// The slab of step 0, 1, 2 ... 2 * Grid - 1 of the walk; -1 for a step that lies outside the grid.
inline int dopu_layer_step(const Config& config, int camera, int step) {
  if (!config.has_slabs()) return step == 0 ? 0 : -1;
  const int slab = step % 2 != 0 ? camera + (step + 1) / 2 : camera - step / 2;
  return slab < 0 || slab >= config.grid ? -1 : slab;
}

// Three-way multiplexer: the slab in which a cell lies.
inline int dopu_layer_of(const Config& config, int axis, int cell) {
  const int bits = clog2(config.grid);
  return (cell >> (axis * bits)) & (config.grid - 1);
}

// The inverse: cell number `n` of 0 .. Grid^2 - 1 inside a slab; the lower axis counts fastest.
inline int dopu_layer_cell(const Config& config, int axis, int slab, int n) {
  if (!config.has_slabs()) return n;
  const int bits = clog2(config.grid), below = n & ((1 << (axis * bits)) - 1), above = n >> (axis * bits);
  return (((above << bits) | slab) << (axis * bits)) | below;
}

}  // namespace pipegs
