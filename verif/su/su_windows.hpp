// SPDX-License-Identifier: Apache-2.0
// su_windows.hpp: windows with watermarks, as the DOPU sends them: after a mark nothing nearer than it follows.
#pragma once

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "cpp_model/su/su.hpp"

namespace pipegs {

// A window, or a walk of a part, of about `count` splats with `marks` watermarks, its end included. The depths lie in a
// random part of the range. With `layers` every mark ends a layer and depths are random in each.
template <class Rng>
std::vector<Splat> su_window(const Config& config, size_t count, int marks, bool layers, Rng& rng,
                             const auto& random_splat) {
  const uint64_t depths = uint64_t{1} << config.depth_w;
  const uint64_t span = std::max<uint64_t>(depths >> rng() % (config.depth_w - 4), 16),
                 base = rng() % (depths - span + 1);
  std::vector<uint64_t> cuts;
  for (int i = 0; i < marks; ++i) cuts.push_back(base + rng() % span);
  std::sort(cuts.begin(), cuts.end());
  cuts.push_back(base);
  std::vector<Splat> beats;
  std::set<uint64_t> seen;
  uint64_t low = base;
  for (int i = 0; i <= marks; ++i) {
    size_t here = rng() % (2 * count / (static_cast<size_t>(marks) + 1) + 1);
    if (rng() % 8 == 0) here = 0;
    if (rng() % 8 == 0) here *= 2;
    const uint64_t room = base + span - low, reach = rng() % 2 ? room : std::max<uint64_t>(room >> rng() % 8, 1);
    for (size_t n = 0; n < here; ++n) {
      Splat splat = random_splat(rng);
      splat.kind = kData;
      splat.depth = layers ? base + rng() % span : low + rng() % reach;
      do {
        splat.index = rng() % (uint64_t{1} << config.index_w);
      } while (!seen.insert(splat_key(config, splat.depth, splat.index, splat.part)).second);
      beats.push_back(splat);
    }
    Splat end = random_splat(rng);
    const bool part = config.has_watermarks() && rng() % 3 == 0;  // not its window's last walk
    end.kind = i != marks ? kLayerEnd : part ? kPartEnd : kWindowEnd;
    end.depth = cuts[i];
    beats.push_back(end);
    low = cuts[i];
  }
  return beats;
}

}  // namespace pipegs
