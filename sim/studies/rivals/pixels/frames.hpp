// SPDX-License-Identifier: Apache-2.0
// frames.hpp: orders that come from the frame before: GSAcc's depth speculation, Neo's reuse-and-update sorting.
//
// GSAcc   DAC'25, doi 10.1109/DAC63849.2025.11133032: a frame is sorted by the depths of the frame before, beside its
//         preprocessing. What a Gaussian does that was not there was not found, so both ends are measured: `kAll`, it
//         has its depth in the last camera; `kSeen`, it comes behind all others, in its own depth order.
// Neo     arXiv 2511.12930, Algorithm 1: each tile of 64 pixels keeps its sorted table. Chunks of 256 are sorted by the
//         depths of the frame before, every second frame the first one is half as long; Gaussians that enter the tile
//         are sorted by their present depths and merged in. Here tables hold a Gaussian by alpha >= 1/255, and it
//         leaves its table in the frame in which it leaves the tile; theirs keep it for one frame more. `kEven` is not
//         theirs: those that enter are merged by their depths in the last camera, as old as those of the table.
#pragma once

#include <vector>

#include "sim/studies/rivals/pixels/view.hpp"

namespace pipegs {

enum class Newcomers { kAll, kSeen };

// Places of `now` by their depths in the camera of `last`.
std::vector<uint32_t> stale_order(const Scene& scene, const PixelView& now, const PixelView& last, Newcomers rule);
// Share of those with a pixel to reach in `now` that touch no tile of `last`.
double newcomers(const PixelView& now, const PixelView& last, size_t gaussians);

enum class Ages { kMixed, kEven };  // of the depths that a merge compares

inline constexpr int kTableSide = 64;      // of a tile with a table, pixels
inline constexpr size_t kChunkSize = 256;  // entries that are sorted at once

class SortedTables {
 public:
  explicit SortedTables(const Scene& scene, Ages ages = Ages::kMixed, size_t chunk = kChunkSize)
      : scene_(scene), ages_(ages), chunk_(chunk) {}
  // One frame more. The first one is sorted in full. `exact`: of exact_sequences for kTableSide.
  Sequences next(const PixelView& view, const Sequences& exact, unsigned threads);

 private:
  struct Entry {
    uint32_t index;
    double depth;  // in the frame before
  };
  std::vector<uint32_t> update(const PixelView& view, const std::vector<uint32_t>& exact,
                               std::vector<Entry>& table) const;

  const Scene& scene_;
  Ages ages_;
  size_t chunk_;
  int frame_ = 0;
  Camera last_ = {};
  std::vector<std::vector<Entry>> tables_;
};

}  // namespace pipegs
