// SPDX-License-Identifier: Apache-2.0
// flicker.cpp: FLICKER (Ou et al., DATE 2026, arXiv 2603.01158).
//
// Published  GSCore's order of work, with half of its lanes: 32 VRUs in four cores. Before them four units test each
//            (Gaussian, 8x8 subtile) in a cycle and name the 4x4 mini-tiles to which it adds; only these are
//            rasterized, two lanes to a mini-tile. FP16, tests in FP8. 28 nm, 3.47 mm2, 1 GHz, LPDDR4 of 51.2 GB/s.
// Assumed    The test passes what alpha >= 1/255 reaches, and `passes_more` of it, because it looks at leading pixels
//            only. Subtiles by the oriented box, which are fewer than by the printed axis-aligned one: in its favour.
//            Preprocessing, lists and sort are GSCore's. Power is not published.
#include "sim/studies/rivals/models/tiles.hpp"

namespace pipegs {
namespace {

constexpr double kMiniPixels = 16;

MachineFrame frame(const FrameCounts& counts, const Values& values, PlayedMemory& memory) {
  const int cores = static_cast<int>(value(values, "cores"));
  const std::vector<uint32_t>& lengths = counts.lists[kLists16].lengths.axis;
  UnitStage split{"splitter", cores, {}}, sort{"sorter", cores, {}}, test{"CTU", cores, {}}, raster{"VRU", cores, {}};
  std::vector<ListWork> tiles;
  for (size_t t = 0; t < lengths.size(); ++t) {
    const TileCounts& tile = counts.tiles[t];
    const double n = lengths[t], open = static_cast<double>(tile.open.axis);
    const double mini = static_cast<double>(tile.exact_4x4) * value(values, "passes_more");
    tiles.push_back({n, open, kTilePixels});
    split.cycles.push_back(n * split_levels(n) / value(values, "splitters"));
    sort.cycles.push_back(ceil_div(open, 16) * value(values, "chunk_cycles"));
    test.cycles.push_back(static_cast<double>(tile.oriented_8x8) / value(values, "test_rate"));
    raster.cycles.push_back(mini * kMiniPixels / value(values, "lanes"));
  }
  return list_frame(counts, values, memory, static_cast<double>(counts.listed.axis), "preprocessing cores", "tiles",
                    tiles, {split, sort, test, raster});
}

std::vector<Parameter> parameters() {
  return tile_parameters({
      {"watts", 0.6, 0.5, 0.87, "W", Mark::kAssumed,
       "not published; low: 0.87 W x 1.5 / 2.6, from its speed and energy over GSCore; high: GSCore's"},
      {"cores", 4, 4, 4, "", Mark::kRead, "each for preprocessing, sorting, tests and rendering"},
      {"splitters", 2, 1, 4, "keys/cycle", Mark::kAssumed, "of a core, GSCore's"},
      {"lanes", 8, 8, 8, "pixels/cycle", Mark::kRead, "VRUs of a core"},
      {"test_rate", 1, 1, 1, "subtiles/cycle", Mark::kRead, "of a core's test unit"},
      {"passes_more", 1.05, 1, 1.2, "", Mark::kAssumed, "mini-tiles that pass, over those that are reached"},
  });
}

}  // namespace

const Rival& flicker() {
  static const Rival rival{"flicker", "FLICKER", "DATE 2026", kNode28, 1, 3.47, parameters(), frame};
  return rival;
}

}  // namespace pipegs
