// SPDX-License-Identifier: Apache-2.0
// su_bitonic.hpp: the network of the 16-channel bitonic sorter, stage by stage.
//
// Idea    Stage (size, distance): channels a and a + 2^distance are compared and exchanged, downwards where bit `size`
//         of a is set. A batch of n keys passes the sizes 1 .. ceil(log2(n)); unused channels are void, above every
//         key.
// Paper   Sec. 4.2.2.        RTL  rtl/su/sort/su_bitonic.sv
#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace pipegs {

inline constexpr int kChannels = 16;

struct SortItem {
  bool is_void = true;
  uint64_t key = 0;
  uint32_t slot = 0;
  bool operator==(const SortItem&) const = default;
};
using SortItems = std::array<SortItem, kChannels>;

// One stage of eight compare-exchange cells.
inline void su_bitonic_stage(SortItems& items, int size, int distance) {
  for (int a = 0; a < kChannels; ++a) {
    if (a >> distance & 1) continue;
    SortItem& low = items[a];
    SortItem& high = items[a + (1 << distance)];
    const bool above = std::pair(low.is_void, low.key) > std::pair(high.is_void, high.key);
    const bool down = a >> size & 1;
    if (above != down) std::swap(low, high);
  }
}

// Sorts the first `count` channels; the others must be void. Returns the number of stages.
inline int su_bitonic(SortItems& items, int count) {
  int stages = 0;
  for (int size = 1; 1 << (size - 1) < count; ++size) {
    for (int distance = size - 1; distance >= 0; --distance, ++stages) su_bitonic_stage(items, size, distance);
  }
  return stages;
}

}  // namespace pipegs
