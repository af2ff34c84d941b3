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
  Phase tiles{"tiles", {}, {}, {}};
  double fetches = 0, pairs = 0, lists = 0;
  for (size_t t = 0; t < lengths.size(); ++t) {
    const double n = lengths[t], open = static_cast<double>(counts.tiles[t].open[cover]);
    const double pixels =
        subtiles ? kPartPixels * static_cast<double>(counts.tiles[t].oriented_8x8) : kTilePixels * open;
    tiles.shares.push_back(n * value(values, "key_bytes") * (2 * value(values, "passes") + 1) +
                           open * value(values, "fetch_bytes") + kPixelBytes * kTilePixels);
    split.cycles.push_back(n * split_levels(n) / value(values, "splitters"));
    sort.cycles.push_back(ceil_div(open, 16) * value(values, "chunk_cycles"));
    raster.cycles.push_back(pixels / value(values, "lanes"));
    fetches += open, pairs += n, lists += n > 0;
  }
  tiles.stages = {split, sort, raster};
  const double visible = static_cast<double>(counts.listed[cover]);
  tiles.flows = sort_and_fetch(counts, values, pairs, lists, fetches, visible);
  return run_phases({project(counts, values, visible, pairs, "CCU"), tiles}, 1, value(values, "watts"), memory);
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = {
      {"watts", 0.87, 0.87, 0.87, "W", Mark::kRead, "its Table 7, 28 nm"},
      {"cores", 4, 4, 4, "", Mark::kRead, "4 CCUs, 4 BSUs, 8 QSUs and 64 VRUs"},
      {"splitters", 2, 1, 4, "keys/cycle", Mark::kNoted, "QSUs of a core, each one key a cycle and level"},
      {"lanes", 16, 16, 16, "pixels/cycle", Mark::kRead, "VRUs of a core"},
      {"box", 1, 1, 1, "", Mark::kRead, "1: lists by the oriented box; 0: by the square of 3 sigma"},
      {"subtiles", 1, 1, 1, "", Mark::kRead, "1: only subtiles in the map; 0: all 256 pixels"},
  };
  for (const Parameter& one : tile_parameters()) all.push_back(one);
  return all;
}

}  // namespace

const Rival& gscore() {
  static const Rival rival{"gscore", "GSCore", "ASPLOS 2024", kNode28, 1, 3.95, parameters(), frame};
  return rival;
}

}  // namespace pipegs
