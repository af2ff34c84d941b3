// SPDX-License-Identifier: Apache-2.0
// pu_color_fetch: takes a colour job apart: what travels on, the direction, and the line of memory with its
// coefficients.
//
// Paper   Sec. 2 (SH colours).
// Stream  color_job -> color_task, view_direction, address of the SH line.
// Layout  Degree 1: four Gaussians in a line (128 bits each); degree 2 and 3: one line each; degree 0: none.
// RTL     rtl/pu/color/pu_color_fetch.sv
#pragma once

#include <algorithm>

#include "cpp_model/records.hpp"

namespace pipegs {

// The SH degree that the machine evaluates in this frame.
inline int color_degree(const Config& config, const Frame& frame) {
  return std::min(static_cast<int>(frame.tables.sh_degree), config.sh_degree);
}

// Line of the coefficients of `slot`; only asked for when color_degree() > 0.
inline uint64_t color_line(const Frame& frame, uint64_t slot) {
  return frame.tables.colors + (frame.tables.sh_degree == 1 ? slot >> 2 : slot);
}

inline ColorTask color_task(const ColorJob& job) {
  return {.kind = job.kind,
          .depth = job.depth,
          .index = job.index,
          .quarter = job.slot & 3,
          .mask = job.mask,
          .address = job.address,
          .ext = job.ext,
          .base_r = job.base_r,
          .base_g = job.base_g,
          .base_b = job.base_b};
}

inline ViewDirection color_direction(const ColorJob& job) { return {.x = job.dir_x, .y = job.dir_y, .z = job.dir_z}; }

}  // namespace pipegs
