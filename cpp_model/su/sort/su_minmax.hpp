// SPDX-License-Identifier: Apache-2.0
// su_minmax.hpp: the range of the keys of a layer.
//
// Paper   Sec. 4.2.2, "MinMax Finder".        RTL  rtl/su/sort/su_minmax.sv
#pragma once

#include <cstdint>
#include <span>

namespace pipegs {

struct KeyRange {
  uint64_t min = 0, max = 0;  // both keys of the set
  bool operator==(const KeyRange&) const = default;
};

// `keys` must not be empty.
inline KeyRange su_minmax(std::span<const uint64_t> keys) {
  KeyRange range{keys.front(), keys.front()};
  for (const uint64_t key : keys) {
    if (key < range.min) range.min = key;
    if (key > range.max) range.max = key;
  }
  return range;
}

}  // namespace pipegs
