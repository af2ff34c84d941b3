// SPDX-License-Identifier: Apache-2.0
// su.hpp: the order in which a Sorting Unit sends splats.
//
// Idea    The key {depth, index, part} is unique, so the order is total and does not depend on how the splats arrived.
//         What an end releases is sent before it: everything, or, when order is 2 and the end is a layer's, what lies
//         in nearer buckets than its depth.
// Paper   Sec. 4.2.2.        RTL  rtl/su/su.sv
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

#include "cpp_model/records.hpp"

namespace pipegs {

// Sort key: depth above index above part; without IndexTies no index.
inline uint64_t splat_key(const Config& config, uint64_t depth, uint64_t index, uint64_t part) {
  return (config.index_ties ? depth << config.index_w | index : depth) << config.part_w() | part;
}

inline bool splat_before(const Splat& a, const Splat& b) {
  return std::tie(a.depth, a.index, a.part) < std::tie(b.depth, b.index, b.part);
}

// Sorts the splats of one layer (data beats only), nearest first.
inline void su_sort(std::vector<Splat>& splats) { std::sort(splats.begin(), splats.end(), splat_before); }

// Bucket of a depth key: its leading bits.
inline uint64_t su_bucket(const Config& config, uint64_t depth) {
  return depth >> (config.depth_w - config.bucket_w());
}

// What a Sorting Unit sends for these beats, ends included (their other fields are zero).
inline std::vector<Splat> su_stream(const Config& config, std::span<const Splat> beats) {
  std::vector<Splat> sent, held;
  for (const Splat& beat : beats) {
    if (beat.kind == kData) {
      held.push_back(beat);
      continue;
    }
    su_sort(held);
    const bool all = !config.has_watermarks() || beat.kind == kWindowEnd;
    const uint64_t mark = su_bucket(config, beat.depth);
    const auto stop = std::find_if(held.begin(), held.end(),
                                   [&](const Splat& s) { return !all && su_bucket(config, s.depth) >= mark; });
    sent.insert(sent.end(), held.begin(), stop);
    held.erase(held.begin(), stop);
    sent.emplace_back();
    sent.back().kind = beat.kind;
  }
  return sent;
}

// A splat as it leaves the merge: the lane that sorted it beside it.
inline Sorted su_sorted(const Config& config, const Splat& s, uint64_t unit) {
  return {s.kind,
          s.depth,
          s.part,
          s.index,
          s.mask,
          s.address,
          s.ext,
          s.red,
          s.green,
          s.blue,
          s.a,
          s.b,
          s.c,
          s.d,
          s.e,
          s.f,
          config.caches_alphas() ? unit : 0};
}

}  // namespace pipegs
