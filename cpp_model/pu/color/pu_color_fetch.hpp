// SPDX-License-Identifier: Apache-2.0
// pu_color_fetch: takes a colour job apart: what travels on, the direction, and the line of memory with its
// coefficients.
//
// Paper   Sec. 2 (SH colours).
// Stream  color_job -> color_task, view_direction, address of the SH line.
// Layout  Degree 1: four Gaussians in a line (128 bits each); degree 2 and 3: one line each; degree 0: none. As codes
//         (sh_code.hpp) twice as many, and half a line is asked for.
// RTL     rtl/pu/color/pu_color_fetch.sv
#pragma once

#include <algorithm>

#include "cpp_model/records.hpp"

namespace pipegs {

// The SH degree that the machine evaluates in this frame.
inline int color_degree(const Config& config, const Frame& frame) {
  return std::min(static_cast<int>(frame.tables.sh_degree), config.sh_degree);
}

// Gaussians in a line, of a scene of this degree.
inline int color_slots_per_line(const Config& config, int sh_degree) {
  return (sh_degree == 1 ? 4 : 1) * (config.coded() ? 2 : 1);
}

// Line of the coefficients of `slot`, and where in it they begin, in bits; only asked for when color_degree() > 0.
inline uint64_t color_line(const Config& config, const Frame& frame, uint64_t slot) {
  const int per_line = color_slots_per_line(config, static_cast<int>(frame.tables.sh_degree));
  return frame.tables.colors + slot / static_cast<uint64_t>(per_line);
}
inline int color_place(const Config& config, int sh_degree, uint64_t slot) {
  const int per_line = color_slots_per_line(config, sh_degree);
  return static_cast<int>(slot % static_cast<uint64_t>(per_line)) * (config.memory_w() / per_line);
}

inline ColorTask color_task(const Config& config, const ColorJob& job) {
  return {.kind = job.kind,
          .depth = job.depth,
          .index = job.index,
          .quarter = job.slot & ((uint64_t{1} << config.quarter_w()) - 1),
          .mask = job.mask,
          .address = job.address,
          .ext = job.ext,
          .base_r = job.base_r,
          .base_g = job.base_g,
          .base_b = job.base_b};
}

inline ViewDirection color_direction(const ColorJob& job) { return {.x = job.dir_x, .y = job.dir_y, .z = job.dir_z}; }

}  // namespace pipegs
