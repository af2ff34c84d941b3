// SPDX-License-Identifier: Apache-2.0
// pu_rows: the 64 alphas of one region of a Gaussian.
//
// Paper   Fig. 5a, Fig. 7 (eight Row Units).           RTL  rtl/pu/rows/pu_rows.sv
// Idea    pu_region, then for the eight rows pu_row_init, pu_row_unit along the row, and pu_alpha for each pixel.
// Pace    `pu_region_line` is the golden model's innermost loop: about 0.1 us.
#pragma once

#include <span>

#include "cpp_model/pu/rows/pu_alpha.hpp"
#include "cpp_model/pu/rows/pu_region.hpp"
#include "cpp_model/pu/rows/pu_row_unit.hpp"

namespace pipegs {

// What pu_region_line derives from a Config, once.
struct PuRows {
  explicit PuRows(const Config& config) : config(config), alpha(config) {}
  Config config;
  PuAlpha alpha;
};

// codes[8 * dy + dx] of the region at `bit`, a set bit of the job's mask.
void pu_region_line(const PuRows& rows, const RowJob& job, int bit, uint16_t codes[64]);

// The record that travels beside that line.
Alphas pu_rows(const Config& config, const RowJob& job, int bit);

// The line as 32-bit words in memory order: LineW bits, first pixel in the low bits.
void pack_line(const Config& config, const uint16_t codes[64], uint32_t* words);

}  // namespace pipegs
