// SPDX-License-Identifier: Apache-2.0
// random_open: what might be closed of a walk, for the tests of those who listen to pipegs_open.
#pragma once

#include "cpp_model/open.hpp"

namespace pipegs {

// A rectangle of at least one region is left open.
template <class Rng>
Closed random_closed(const Config& config, uint64_t walk, Rng& rng) {
  const auto side = static_cast<uint64_t>(walk_square(config, walk).side) / 8;
  const auto pair = [&](uint64_t& low, uint64_t& high) {
    low = rng() % 2 == 0 ? 0 : rng() % side;
    high = rng() % 2 == 0 ? 0 : rng() % (side - low);
  };
  Closed closed;
  pair(closed.left, closed.right);
  pair(closed.top, closed.bottom);
  return closed;
}

template <class Rng>
Open random_open(const Config& config, uint64_t window_x, uint64_t window_y, Rng& rng) {
  Open open{.known = 1, .window_x = window_x, .window_y = window_y};
  for (const uint64_t walk : all_walks(config)) close_walk(config, open, walk, random_closed(config, walk, rng));
  return open;
}

}  // namespace pipegs
