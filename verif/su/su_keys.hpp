// SPDX-License-Identifier: Apache-2.0
// su_keys.hpp: sets of unique sort keys in the arrangements that a sorter may find hard.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

enum class Arrangement { kRandom, kNarrow, kEqualDepth, kAscending, kDescending, kClustered, kOutlier, kExtremes };
inline constexpr Arrangement kArrangements[] = {
    Arrangement::kRandom,     Arrangement::kNarrow,    Arrangement::kEqualDepth, Arrangement::kAscending,
    Arrangement::kDescending, Arrangement::kClustered, Arrangement::kOutlier,    Arrangement::kExtremes};
inline const char* to_text(Arrangement arrangement) {
  constexpr const char* kNames[] = {"random",     "narrow",    "equal depth", "ascending",
                                    "descending", "clustered", "outlier",     "extremes"};
  return kNames[static_cast<int>(arrangement)];
}

// `count` different keys of depth_w + index_w bits.
template <class Rng>
std::vector<uint64_t> su_keys(const Config& config, Arrangement arrangement, size_t count, Rng& rng) {
  const uint64_t depths = uint64_t{1} << config.depth_w, indices = uint64_t{1} << config.index_w;
  std::set<uint64_t> seen;
  std::vector<uint64_t> keys;
  const uint64_t one_depth = rng() % depths;
  while (keys.size() < count) {
    uint64_t depth = rng() % depths, index = rng() % indices;
    const double coin = static_cast<double>(rng() % (1 << 20) + 1) / (1 << 20);
    switch (arrangement) {
      case Arrangement::kNarrow: depth = depths / 2 - 32 + rng() % 64; break;
      case Arrangement::kEqualDepth: depth = one_depth; break;
      case Arrangement::kClustered:  // distances from the first key halve again and again
        depth = static_cast<uint64_t>(static_cast<double>(depths - 1) * std::exp2(-30 * coin));
        break;
      case Arrangement::kOutlier: depth = keys.empty() ? depths - 1 : 5, index %= 4 * count + 16; break;
      case Arrangement::kExtremes:
        depth = rng() % 2 ? depths - 1 - rng() % 2 : rng() % 2,
        index = rng() % 2 ? indices - 1 - index % (8 + count) : index % (8 + count);
        break;
      default: break;
    }
    const uint64_t key = depth << config.index_w | index;
    if (seen.insert(key).second) keys.push_back(key);
  }
  if (arrangement == Arrangement::kAscending) std::sort(keys.begin(), keys.end());
  if (arrangement == Arrangement::kDescending) std::sort(keys.rbegin(), keys.rend());
  return keys;
}

}  // namespace pipegs
