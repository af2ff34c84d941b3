// SPDX-License-Identifier: Apache-2.0
// tiles.hpp: what machines share that project all Gaussians first and then sort and rasterize list by list.
//
// Idea    Records are read in the order of the file; what is visible leaves its feature in a table and a key in the
//         list of each tile. A list is read and written `passes` times before it is read in order, and each pair
//         fetches its feature from the table by index: scattered.
// Units   Bytes, pixels.
#pragma once

#include <algorithm>
#include <iterator>

#include "sim/studies/rivals/models/rival.hpp"

namespace pipegs {

inline constexpr double kPixelBytes = 4;  // written for each pixel, as our machines do
inline constexpr double kTilePixels = kTileSide * kTileSide, kPartPixels = 64;
inline constexpr double kLineOfMemory = 64;

// Of each 64-px group, in doubles the sum of what `of` says of its 16-px tiles.
template <class Of>
std::vector<double> sums_of_groups(const FrameCounts& counts, Of of) {
  constexpr size_t kTiles = kGroupSide / kTileSide;
  const auto columns = static_cast<size_t>(counts.lists[kLists16].columns),
             group_columns = static_cast<size_t>(counts.lists[kLists64].columns);
  std::vector<double> sums(group_columns * static_cast<size_t>(counts.lists[kLists64].rows), 0);
  for (size_t t = 0; t < counts.tiles.size(); ++t)
    sums[t / columns / kTiles * group_columns + t % columns / kTiles] += static_cast<double>(of(counts.tiles[t]));
  return sums;
}

// Records in order, features of `visible` and the keys of `pairs`, which leave for as many places as there are lists.
inline Phase project(const FrameCounts& counts, const Values& values, double visible, double pairs,
                     const std::string& unit) {
  const double records = static_cast<double>(counts.scene);
  return even_phase(
      "preprocessing",
      {{.kind = "records", .bytes = records * value(values, "record_bytes")},
       {.kind = "features", .write = true, .bytes = visible * value(values, "feature_bytes")},
       {.kind = "keys", .write = true, .bytes = pairs * value(values, "list_bytes"), .run = kLineOfMemory}},
      records, unit, static_cast<int>(value(values, "cores")), value(values, "cull_rate"));
}

// What a list asks for: its keys, the features that it fetches, and the pixels that it draws.
struct ListWork {
  double keys, fetches, pixels;
};

// A frame of a machine whose preprocessing, units of this name, is followed by `stages`, list by list.
inline MachineFrame list_frame(const FrameCounts& counts, const Values& values, PlayedMemory& memory, double visible,
                               const std::string& preprocessing, const std::string& phase,
                               const std::vector<ListWork>& lists, const std::vector<UnitStage>& stages) {
  const double key = value(values, "key_bytes"), fetch = value(values, "fetch_bytes"), passes = value(values, "passes"),
               pixels = kPixelBytes * counts.width * counts.height;
  Phase work{phase, {}, {}, stages};
  double keys = 0, filled = 0, fetches = 0;
  for (const ListWork& list : lists) {
    work.shares.push_back(list.keys * key * (2 * passes + 1) + list.fetches * fetch + kPixelBytes * list.pixels);
    keys += list.keys, filled += list.keys > 0, fetches += list.fetches;
  }
  const double bytes = keys * key, run = filled > 0 ? std::max(bytes / filled, 1.0) : kLineOfMemory;
  work.flows = {{.kind = "sort", .bytes = bytes * (passes + 1), .run = run, .table = bytes},
                {.kind = "sort", .write = true, .bytes = bytes * passes, .run = run, .table = bytes},
                {.kind = "fetches",
                 .bytes = fetches * fetch,
                 .run = kLineOfMemory,
                 .table = visible * value(values, "feature_bytes")},
                {.kind = "pixels", .write = true, .bytes = pixels, .run = kLineOfMemory, .table = pixels}};
  return run_phases({project(counts, values, visible, keys, preprocessing), work}, 1, value(values, "watts"), memory);
}

// A machine's own parameters, and behind them those that all of these machines have. The sources are GSCore's; others
// take them over where their papers say nothing else.
inline std::vector<Parameter> tile_parameters(std::vector<Parameter> own) {
  const Parameter shared[] = {
      {"record_bytes", 236, 236, 236, "B", Mark::kRead, "59 parameters in FP32; 78.8 MB are read for Lego"},
      {"cull_rate", 1, 0.25, 1, "Gaussians/cycle", Mark::kAssumed, "of one unit of preprocessing"},
      {"feature_bytes", 32, 22, 32, "B", Mark::kNoted,
       "of a projected Gaussian in its table: 9.5 MB for Lego; FP16 as in Neo's simulator: 22"},
      {"fetch_bytes", 32, 32, 64, "B", Mark::kAssumed,
       "read for the feature of a pair: one burst of 32 B, or a line of 64 B as in Neo's simulator"},
      {"key_bytes", 6, 6, 8, "B", Mark::kNoted, "depth in FP16 and a 32-bit index, as in Neo's simulator"},
      {"list_bytes", 6, 6, 64, "B", Mark::kAssumed,
       "written for a pair when lists are made: keys gathered into lines, or a line each (Neo's simulator: three)"},
      {"passes", 2, 0, 3, "", Mark::kNoted,
       "times that a list is written and read again: 3 in Neo's simulator of this sort, 0 if lists stay on the chip"},
      {"chunk_cycles", 1, 1, 4, "cycles", Mark::kAssumed, "of a bitonic sorter for 16 keys, one after the other"},
  };
  own.insert(own.end(), std::begin(shared), std::end(shared));
  return own;
}

}  // namespace pipegs
