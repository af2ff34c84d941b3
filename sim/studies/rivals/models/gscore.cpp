// SPDX-License-Identifier: Apache-2.0
// gscore.cpp: GSCore (Lee et al., ASPLOS 2024).
//
// Published  Projects every Gaussian once and puts it into the lists of the 16-px tiles that its oriented box touches,
//            with a 4-bit map of their 8x8 subtiles. Preprocessing ends before anything else begins. Then tile by tile:
//            splits by pivots (8 QSUs), sorts chunks of 16 (4 BSUs) and rasterizes the chunks that are done (64 VRUs of
//            one pixel a cycle); subtiles that are not in the map, and those that are opaque, cost nothing. 1 GHz.
// Assumed    Units belong to four cores (Neo scales GSCore by these); a core has one tile. Keys beyond the one that
//            makes a tile opaque are split but neither sorted nor fetched. How often a list goes to memory: `passes`.
#include "sim/studies/rivals/models/tiles.hpp"

namespace pipegs {
namespace {

MachineFrame frame(const FrameCounts& counts, const Values& values, PlayedMemory& memory) {
  const bool boxed = value(values, "box") != 0, subtiles = boxed && value(values, "subtiles") != 0;
  const Cover cover = boxed ? Cover::kOriented : Cover::kSquare;
  const int cores = static_cast<int>(value(values, "cores"));
  const std::vector<uint32_t>& lengths = counts.lists[kLists16].lengths[cover];
  UnitStage split{"QSU", cores, {}}, sort{"BSU", cores, {}}, raster{"VRU", cores, {}};
  std::vector<ListWork> tiles;
  for (size_t t = 0; t < lengths.size(); ++t) {
    const double n = lengths[t], open = static_cast<double>(counts.tiles[t].open[cover]);
    const double pixels =
        subtiles ? kPartPixels * static_cast<double>(counts.tiles[t].oriented_8x8) : kTilePixels * open;
    tiles.push_back({n, open, kTilePixels});
    split.cycles.push_back(n * split_levels(n) / value(values, "splitters"));
    sort.cycles.push_back(ceil_div(open, 16) * value(values, "chunk_cycles"));
    raster.cycles.push_back(pixels / value(values, "lanes"));
  }
  return list_frame(counts, values, memory, static_cast<double>(counts.listed[cover]), "CCU", "tiles", tiles,
                    {split, sort, raster});
}

std::vector<Parameter> parameters() {
  return tile_parameters({
      {"watts", 0.87, 0.87, 0.87, "W", Mark::kRead, "its Table 7, 28 nm"},
      {"cores", 4, 4, 4, "", Mark::kRead, "4 CCUs, 4 BSUs, 8 QSUs and 64 VRUs"},
      {"splitters", 2, 1, 4, "keys/cycle", Mark::kNoted, "QSUs of a core, each one key a cycle and level"},
      {"lanes", 16, 16, 16, "pixels/cycle", Mark::kRead, "VRUs of a core"},
      {"box", 1, 1, 1, "", Mark::kRead, "1: lists by the oriented box; 0: by the square of 3 sigma"},
      {"subtiles", 1, 1, 1, "", Mark::kRead, "1: only subtiles in the map; 0: all 256 pixels"},
  });
}

}  // namespace

const Rival& gscore() {
  static const Rival rival{"gscore", "GSCore", "ASPLOS 2024", kNode28, 1, 3.95, parameters(), frame};
  return rival;
}

}  // namespace pipegs
