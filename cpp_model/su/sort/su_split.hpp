// SPDX-License-Identifier: Apache-2.0
// su_split.hpp: the pivot-based splitter: cuts keys into groups of at most sixteen, nearest group first.
//
// Idea    bucket = (key - min) >> shift, four bits; buckets are chains, newest key first; neighbours are joined from
//         far to near while they fit; groups that are still too large are cut again by the next four bits.
// Paper   Sec. 4.2.2.        RTL  rtl/su/sort/su_split.sv
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cpp_model/su/sort/su_minmax.hpp"

namespace pipegs {

struct SplitStats {
  int passes = 0;       // groups that were cut
  uint64_t visits = 0;  // keys read in these passes
};

// Groups of slots (indices into `keys`) in the order in which the splitter sends them. `keys` are unique, not empty.
std::vector<std::vector<uint32_t>> su_split(std::span<const uint64_t> keys, const KeyRange& range,
                                            SplitStats* stats = nullptr);

}  // namespace pipegs
