// SPDX-License-Identifier: Apache-2.0
// lists.hpp: every Gaussian of a view into the lists of the tiles that it covers, by each test and side.
#pragma once

#include <span>
#include <vector>

#include "sim/studies/rivals/count/cover.hpp"

namespace pipegs {

// A Gaussian in the list of a 16-px tile: its place in depth order, and by which tests it is there.
class Entry {
 public:
  Entry(uint32_t place, uint32_t covers) : bits_(place << kCovers | covers) {}
  uint32_t place() const { return bits_ >> kCovers; }
  bool by(Cover cover) const { return (bits_ >> static_cast<int>(cover) & 1) != 0; }

 private:
  uint32_t bits_;
};

// The 16-px tiles' lists, each in depth order.
struct TileLists {
  std::vector<size_t> first = {};  // per tile, one more at the end
  std::vector<Entry> entries = {};
  std::span<const Entry> of(size_t tile) const {
    return std::span(entries).subspan(first[tile], first[tile + 1] - first[tile]);
  }
};

// Counts lists, listed Gaussians and neighbours; returns the lists to walk.
TileLists count_lists(const std::vector<SeenGaussian>& seen, const Camera& camera, const CountOptions& options,
                      FrameCounts& counts);

}  // namespace pipegs
