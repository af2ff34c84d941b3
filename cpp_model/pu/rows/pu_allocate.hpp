// SPDX-License-Identifier: Apache-2.0
// pu_allocate: gives each Gaussian of a window its lines in the alpha store, and nothing to regions that are opaque.
//
// Paper   "cache the alphas" (Sec. 3); the paper does not say where: docs/units/rows.md.
// RTL     rtl/pu/rows/pu_allocate.sv
// Idea    The alpha store of a lane is a ring. A Gaussian with n regions takes n lines in a row when the lines of its
//         own layer leave room for them (the RTL then waits until the older layer's lines are free: timing, not
//         result); otherwise the lines go to the overflow area in external memory, numbered from 0 in each layer.
// Stream  tiles in; row_job and color_job out, both or neither (a mask without regions left is dropped). Ends pass.
#pragma once

#include <bit>
#include <optional>

#include "cpp_model/records.hpp"

namespace pipegs {

struct PuAllocate {
  struct Out {
    RowJob row_job;
    ColorJob color_job;
    uint64_t overflowed = 0;  // lines that went to the overflow area
  };

  explicit PuAllocate(const Config& config) : config(config) {}

  // `done`: opaque regions of the beat's window. No value: the beat is dropped.
  std::optional<Out> operator()(const Tiles& tiles, const Payload& payload, uint64_t done) {
    Out out;
    out.row_job.kind = out.color_job.kind = tiles.kind;
    out.row_job.parity = parity;
    if (tiles.kind != kData) {
      used = overflow = 0;
      parity ^= 1;
      return out;
    }
    const uint64_t mask = tiles.mask & ~done;
    if (mask == 0) return std::nullopt;
    const auto lines = static_cast<uint64_t>(std::popcount(mask));
    const auto capacity = static_cast<uint64_t>(config.alpha_lines);
    const bool ext = used + lines > capacity;
    const uint64_t address = ext ? overflow : head;
    if (ext) {
      out.overflowed = lines;
      overflow += lines;
    } else {
      used += lines;
      head = (head + lines) & (capacity - 1);
    }
    out.row_job = {kData,   tiles.a, tiles.b, tiles.c, tiles.d, tiles.e,
                   tiles.f, mask,    address, ext,     parity,  payload.index};
    const Payload& p = payload;
    out.color_job = {kData,   p.depth, p.index, p.slot,   mask,     address, ext,
                     p.dir_x, p.dir_y, p.dir_z, p.base_r, p.base_g, p.base_b};
    return out;
  }

  Config config;
  uint64_t head = 0;      // next free line of the ring
  uint64_t used = 0;      // lines of the current layer in the ring
  uint64_t overflow = 0;  // lines of the current layer in the overflow area
  uint64_t parity = 0;    // of the current layer; a new frame starts with a new PuAllocate
};

}  // namespace pipegs
