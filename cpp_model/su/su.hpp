// su.hpp: the order in which a Sorting Unit sends the splats of a layer.
//
// Idea    The key {depth, index} is unique, so the order is total and does not depend on how the splats arrived.
// Paper   Sec. 4.2.2.        RTL  rtl/su/su.sv
#pragma once

#include <algorithm>
#include <vector>

#include "cpp_model/records.hpp"

namespace pipegs {

// Sort key of a splat: depth above index.
inline uint64_t splat_key(const Config& config, const Splat& splat) { return splat.depth << config.index_w | splat.index; }

inline bool splat_before(const Splat& a, const Splat& b) { return a.depth != b.depth ? a.depth < b.depth : a.index < b.index; }

// Sorts the splats of one layer (data beats only), nearest first.
inline void su_sort(std::vector<Splat>& splats) { std::sort(splats.begin(), splats.end(), splat_before); }

// A splat as it leaves the merge: the lane that sorted it beside it.
inline Sorted su_sorted(const Config& config, const Splat& s, uint64_t unit) {
  return {s.kind, s.depth, s.index, s.mask, s.address, s.ext, s.red, s.green, s.blue, s.a, s.b, s.c, s.d, s.e, s.f, config.late ? 0 : unit};
}

}  // namespace pipegs
