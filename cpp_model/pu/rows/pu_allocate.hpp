// SPDX-License-Identifier: Apache-2.0
// pu_allocate: gives each Gaussian of a window its lines in the alpha store, and nothing to regions that are opaque.
//
// Paper   "cache the alphas" (Sec. 3); the paper does not say where: docs/units/pu.md.
// RTL     rtl/pu/rows/pu_allocate.sv
// Idea    A Gaussian with n regions takes n addresses in a row of a lane's alpha store when the lines of its own layer
//         leave room for them (the RTL then waits until older layers have left it: timing, not result); otherwise its
//         lines go to external memory, numbered from 0 in each layer. The layers of which lines go there use the unit's
//         two overflow areas in turn.
// Stream  tiles in; row_job and color_job out, both or neither (a mask without regions left is dropped). Ends pass.
#pragma once

#include <bit>
#include <optional>

#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_walk.hpp"

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
    if (tiles.kind != kData) {
      if (overflow != 0) area ^= 1;
      own = overflow = 0;
      return out;
    }
    const uint64_t mask = tiles.mask & ~done;
    if (mask == 0) return std::nullopt;
    const auto lines = static_cast<uint64_t>(std::popcount(mask));
    const bool ext = own + lines > static_cast<uint64_t>(config.alpha_lines);
    const uint64_t address = ext ? area << ru_number_w(config) | overflow : head;
    if (ext) {
      out.overflowed = lines;
      overflow += lines;
    } else {
      own += lines;
      head = (head + lines) & static_cast<uint64_t>(config.alpha_addresses() - 1);
    }
    out.row_job = {kData, tiles.a, tiles.b, tiles.c, tiles.d, tiles.e, tiles.f, mask, address, ext, payload.index};
    const Payload& p = payload;
    out.color_job = {kData,   p.depth, p.index, p.slot,   mask,     address, ext,
                     p.dir_x, p.dir_y, p.dir_z, p.base_r, p.base_g, p.base_b};
    return out;
  }

  Config config;
  uint64_t head = 0;      // next address of the store
  uint64_t own = 0;       // lines of the current layer in the store
  uint64_t overflow = 0;  // lines of the current layer in external memory
  uint64_t area = 0;      // where these lie; a new frame starts with a new PuAllocate
};

}  // namespace pipegs
