// SPDX-License-Identifier: Apache-2.0
// gs_tg.cpp: GS-TG (Jo and Park, DAC 2025, arXiv 2509.00911).
//
// Published  Sorts a list for each group of 4x4 tiles of 16 px. While a group is sorted, another module tests its
//            Gaussians against the sixteen tiles and gives each a mask of 16 bits; rasterization of a tile takes from
//            the sorted list what has its bit. Ellipse tests. Lossless. 1 GHz, 28 nm.
// Assumed    Numbers of units: GSCore's, four cores with a group each, so that what differs is the algorithm. Without
//            subtiles: the paper names none. A feature and a mask are fetched once for a (Gaussian, group), not for
//            each tile; a core looks at `masks` entries of the list in a cycle while its lanes work.
#include "sim/studies/rivals/models/tiles.hpp"

namespace pipegs {
namespace {

MachineFrame frame(const FrameCounts& counts, const Values& values, PlayedMemory& memory) {
  const int cores = static_cast<int>(value(values, "cores"));
  const std::vector<uint32_t>& lengths = counts.lists[kLists64].lengths.exact;
  const std::vector<double> tiles = sums_of_groups(counts, [](const TileCounts&) { return 1; }),
                            open = sums_of_groups(counts, [](const TileCounts&tile) { return tile.open.exact; });
  UnitStage split{"GSM", cores, {}}, mask{"BGM", cores, {}}, raster{"RM", cores, {}};
  std::vector<ListWork> groups;
  for (size_t g = 0; g < lengths.size(); ++g) {
    const double n = lengths[g];
    groups.push_back({n, n, kTilePixels * tiles[g]});
    split.cycles.push_back(
        std::max(n * split_levels(n) / value(values, "splitters"), ceil_div(n, 16) * value(values, "chunk_cycles")));
    mask.cycles.push_back(n / value(values, "mask_rate"));
    raster.cycles.push_back(
        std::max(kTilePixels * open[g] / value(values, "lanes"), n * tiles[g] / value(values, "masks")));
  }
  return list_frame(counts, values, memory, static_cast<double>(counts.listed.exact), "preprocessing", "groups", groups,
                    {split, mask, raster});
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = tile_parameters({
      {"watts", 1.063, 1.063, 1.063, "W", Mark::kNoted, "28 nm, 1 GHz"},
      {"cores", 4, 4, 4, "", Mark::kAssumed, "GSCore's"},
      {"splitters", 2, 1, 4, "keys/cycle", Mark::kAssumed, "GSCore's, of a core"},
      {"lanes", 16, 16, 32, "pixels/cycle", Mark::kAssumed,
       "of a core: GSCore's; twice as many are what 1.54x over GSCore would ask for"},
      {"masks", 2, 1, 16, "entries/cycle", Mark::kAssumed, "of a sorted list that a core looks at for a tile"},
      {"mask_rate", 1, 0.25, 1, "Gaussians/cycle", Mark::kAssumed, "that get their mask, of a core"},
  });
  for (Parameter& one : all) {
    if (one.name == "fetch_bytes")
      one = {"fetch_bytes", 34, 32, 64, "B", Mark::kAssumed, "feature and mask of a (Gaussian, group)"};
  }
  return all;
}

}  // namespace

const Rival& gs_tg() {
  static const Rival rival{"gs_tg", "GS-TG", "DAC 2025", kNode28, 1, 3.984, parameters(), frame};
  return rival;
}

}  // namespace pipegs
