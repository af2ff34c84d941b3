// SPDX-License-Identifier: Apache-2.0
// su.hpp: the order in which a Sorting Unit sends splats.
//
// Idea    The key {depth, index, part} is unique, so the order is total and does not depend on how the splats arrived.
//         What an end releases is sent before it: everything, or, when order is 2 and the end is a layer's, what lies
//         in nearer buckets than its depth.
// Paper   Sec. 4.2.2.        RTL  rtl/su/pipegs_su.sv
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "cpp_model/fixed.hpp"
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

// The octave in which the buckets of a frame begin: with watermarks the near plane's, so that 16 octaves do.
inline int su_octave(const Config& config, const Frame& frame) {
  return config.has_watermarks() ? std::max(bit_length(frame.lens.near_plane) - 1, 0) : 0;
}

// Bucket of a depth key: its octave and leading bits of the mantissa; all that is nearer is in the first one, all that
// is farther in the last one.
inline uint64_t su_bucket(const Config& config, uint64_t depth, int octave) {
  const int64_t step = static_cast<int64_t>(depth >> (config.depth_w - config.step_w()));
  return static_cast<uint64_t>(
      std::clamp<int64_t>(step - (int64_t{octave} << config.bucket_bits), 0, (1 << config.bucket_w()) - 1));
}

// The smallest and the largest depth key of a bucket.
inline std::pair<uint64_t, uint64_t> su_bucket_range(const Config& config, uint64_t bucket, int octave) {
  const int below = config.depth_w - config.step_w();
  const uint64_t step = bucket + (static_cast<uint64_t>(octave) << config.bucket_bits), one = 1;
  const bool last = bucket == (one << config.bucket_w()) - 1;
  return {bucket == 0 ? 0 : step << below, last ? (one << config.depth_w) - 1 : ((step + 1) << below) - 1};
}

// What a Sorting Unit sends for these beats, ends included (their other fields are zero).
inline std::vector<Splat> su_stream(const Config& config, std::span<const Splat> beats, int octave = 0) {
  std::vector<Splat> sent, held;
  for (const Splat& beat : beats) {
    if (beat.kind == kData) {
      held.push_back(beat);
      continue;
    }
    su_sort(held);
    const bool all = !config.has_watermarks() || beat.kind != kLayerEnd;
    const uint64_t mark = su_bucket(config, beat.depth, octave);
    const auto stop = std::find_if(held.begin(), held.end(),
                                   [&](const Splat& s) { return !all && su_bucket(config, s.depth, octave) >= mark; });
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
