// SPDX-License-Identifier: Apache-2.0
// pack_order: the order of a cell's Gaussians, such that consecutive ones make tight chunks and groups of chunks.
//
// Idea    A chunk is fetched whole when its box, grown by the reach of its largest scale, touches a window. So a chunk
//         should be small AND of one size. Split recursively along one of four dimensions x, y, z, size, at a multiple
//         of the chunk (of the group while there are several), wherever the surface heuristic of ray tracing is least:
//           cost = sum over both parts of count * (surface of the box grown by reach and by a typical window)
//         Measured against median splits: see docs/units/dopu.md.
// Pace    n log n: each dimension is sorted once and the four orders are split stably. Cells are independent, and so
//         are the parts of a large one (threads); the order does not depend on their number.
// Memory  at most 32 bytes an item beside the items while it runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pipegs {

struct OrderItem {
  float value[4];               // position in scene units from any origin; effective scale in scene units
  float extent[3] = {0, 0, 0};  // half extents of what is boxed around the position
  uint32_t index;
};

// Reorders `items`, which come by rising index, in place. `chunk` and `group` count items; `window` is the side of a
// window at a typical distance, `reach` how many times its scale a Gaussian reaches. threads = 0: all.
void pack_order(std::span<OrderItem> items, std::size_t chunk, std::size_t group, float window, float reach,
                unsigned threads);

}  // namespace pipegs
