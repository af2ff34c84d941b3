// SPDX-License-Identifier: Apache-2.0
// lists.cpp: see lists.hpp.
//
// Idea    Blocks of the depth order run on all threads, each with sums of its own; lengths of lists are shared and
//         raised atomically. The entries of the blocks are put into the tiles block by block, so lists need no sort.
#include "sim/studies/rivals/count/lists.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

constexpr size_t kBlock = 2048;  // Gaussians that a thread takes at a time

struct Block {
  ByCover<uint64_t> listed = {};
  NeighbourCounts neighbours = {};
  std::vector<std::pair<uint32_t, Entry>> items = {};  // tile, and what its list gets
};

class Lister {
 public:
  Lister(const std::vector<SeenGaussian>& seen, const Camera& camera, FrameCounts& counts)
      : seen_(seen), camera_(camera), counts_(counts) {}

  void run(size_t first, size_t last, Block& block) {
    find_before(first);
    for (size_t place = first; place < last; ++place) {
      const SeenGaussian& s = seen_[place];
      reached_spans(s, spans_);
      for (size_t side = 0; side < kListSides.size(); ++side) {
        for (const Cover cover : kAllCovers) {
          covered(s, spans_, TileGrid(camera_, kListSides[side]), cover, sets_[side][cover]);
          count_lengths(counts_.lists[side], sets_[side][cover], cover);
        }
      }
      count_gaussian(block);
      list_tiles(static_cast<uint32_t>(place), block);
    }
  }

 private:
  // The oriented tiles of the last Gaussian before `place` that has any.
  void find_before(size_t place) {
    while (place-- > 0) {
      covered(seen_[place], spans_, TileGrid(camera_, kTileSide), Cover::kOriented, before_);
      if (before_.count() > 0) return;
    }
    before_.clear({});
  }

  static void count_lengths(ListCounts& lists, const TileSet& set, Cover cover) {
    set.for_each([&](int x, int y) {
      const auto tile = static_cast<size_t>(y) * static_cast<size_t>(lists.columns) + static_cast<size_t>(x);
      std::atomic_ref(lists.lengths[cover][tile]).fetch_add(1, std::memory_order_relaxed);
    });
  }

  void count_gaussian(Block& block) {
    const ByCover<TileSet>& tiles = sets_[kLists16];
    for (const Cover cover : kAllCovers) block.listed[cover] += tiles[cover].count() > 0;
    const uint64_t own = tiles.oriented.count();
    if (own == 0) return;
    if (before_.count() > 0) {
      block.neighbours.tiles += own;
      tiles.oriented.for_each([&](int x, int y) { block.neighbours.shared += before_.has(x, y); });
    }
    before_ = tiles.oriented;
  }

  void list_tiles(uint32_t place, Block& block) const {
    const ByCover<TileSet>& tiles = sets_[kLists16];
    const TileGrid grid(camera_, kTileSide);
    const auto list = [&](int x, int y) {
      uint32_t covers = 0;
      for (const Cover cover : kAllCovers)
        covers |= static_cast<uint32_t>(tiles[cover].has(x, y)) << static_cast<int>(cover);
      block.items.push_back({static_cast<uint32_t>(grid.at(x, y)), {place, covers}});
    };
    tiles.square.for_each(list);
    tiles.exact.for_each([&](int x, int y) {
      if (!tiles.square.has(x, y)) list(x, y);
    });
  }

  const std::vector<SeenGaussian>& seen_;
  const Camera& camera_;
  FrameCounts& counts_;
  std::vector<PixelSpan> spans_;
  std::array<ByCover<TileSet>, kListSides.size()> sets_;
  TileSet before_;
};

}  // namespace

TileLists count_lists(const std::vector<SeenGaussian>& seen, const Camera& camera, const CountOptions& options,
                      FrameCounts& counts) {
  const size_t count = seen.size();
  for (size_t side = 0; side < kListSides.size(); ++side) {
    const TileGrid grid(camera, kListSides[side]);
    ListCounts& lists = counts.lists[side];
    lists.side = grid.side, lists.columns = grid.columns, lists.rows = grid.rows;
    for (const Cover cover : kAllCovers) lists.lengths[cover].assign(grid.count(), 0);
  }
  std::vector<Block> blocks((count + kBlock - 1) / kBlock);
  parallel_for(blocks.size(), options.threads, [&](size_t b) {
    if (interrupted()) throw std::runtime_error("interrupted");
    Lister(seen, camera, counts).run(b * kBlock, std::min(count, (b + 1) * kBlock), blocks[b]);
  });
  TileLists tile_lists(TileGrid(camera, kTileSide).count());
  for (const Block& block : blocks) {
    for (const auto& [tile, entry] : block.items) tile_lists[tile].push_back(entry);
    for (const Cover cover : kAllCovers) counts.listed[cover] += block.listed[cover];
    counts.neighbours.tiles += block.neighbours.tiles;
    counts.neighbours.shared += block.neighbours.shared;
  }
  return tile_lists;
}

}  // namespace pipegs
