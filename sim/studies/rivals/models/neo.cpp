// SPDX-License-Identifier: Apache-2.0
// neo.cpp: Neo (Oh et al., ASPLOS 2026, arXiv 2511.12930), after its simulator (github.com/casys-kaist/Neo).
//
// Published  Tiles of 64 px keep the order of the last frame. A list is read, sorted in chunks of 256 keys and written
//            once; what is new in a tile is found by preprocessing, sorted by itself and merged; rasterization writes
//            the new depths back with the list. FP16: 6 B of every Gaussian, two lines of 64 B of those in the frustum,
//            a line for each feature written and for each fetched by a pair, 6 B a key. A raster core takes an 8x8
//            subtile a cycle. The kept lists are sorted beside preprocessing; a tile is rasterized when what is new in
//            it is known, which is after preprocessing. 1 GHz, ASAP7.
// Assumed    Which share of the keys is new: the view is one frame. Subtiles that alpha >= 1/255 reaches, until opaque.
//            Its power is that of 7 nm and stays so: in its favour.
#include "sim/studies/rivals/models/tiles.hpp"

namespace pipegs {
namespace {

constexpr double kChunk = 256;

// Merge sort of chunks from runs of 16: a key a cycle and level.
double chunk_levels(double n) { return std::max(1, split_levels(std::min(n, kChunk), 16, 2)); }

MachineFrame frame(const FrameCounts& counts, const Values& values, PlayedMemory& memory) {
  const std::vector<uint32_t>& lengths = counts.lists[kLists64].lengths.oriented;
  const std::vector<double> subtiles = sums_of_groups(counts, [](const TileCounts& tile) { return tile.exact_8x8; });
  const double key = value(values, "key_bytes"), fetch = value(values, "fetch_bytes"), fresh = value(values, "fresh");
  UnitStage sort{"sorting cores", static_cast<int>(value(values, "sorters")), {}};
  UnitStage raster{"raster cores", static_cast<int>(value(values, "cores")), {}};
  Phase front{"preprocessing and sort", {}, {}, {}}, back{"rasterization", {}, {}, {}};
  double pairs = 0, filled = 0;
  for (size_t t = 0; t < subtiles.size(); ++t) {
    const double n = lengths[t];
    front.shares.push_back(n);
    back.shares.push_back(2 * n * key + n * fetch + kPixelBytes * kGroupSide * kGroupSide);
    sort.cycles.push_back(n * chunk_levels(n));
    raster.cycles.push_back(subtiles[t] * kPartPixels / value(values, "lanes"));
    pairs += n, filled += n > 0;
  }
  front.stages = {sort}, back.stages = {raster};
  const double scene = static_cast<double>(counts.scene), seen = static_cast<double>(counts.listed.square),
               keys = pairs * key, run = filled > 0 ? std::max(keys / filled, 1.0) : kLineOfMemory,
               table = seen * value(values, "feature_bytes"), pixels = kPixelBytes * counts.width * counts.height;
  const Flow read{.kind = "sort", .bytes = keys * (1 + fresh), .run = run, .table = keys},
      written{.kind = "sort", .write = true, .bytes = keys * (1 + fresh), .run = run, .table = keys};
  front.flows = {
      {.kind = "records", .bytes = scene * value(values, "mean_bytes")},
      {.kind = "records", .bytes = seen * value(values, "record_bytes"), .run = 128, .table = scene * 128},
      {.kind = "features", .write = true, .bytes = table},
      {.kind = "keys", .write = true, .bytes = fresh * pairs * value(values, "list_bytes"), .run = kLineOfMemory},
      read,
      written};
  back.flows = {read,
                written,
                {.kind = "fetches", .bytes = pairs * fetch, .run = kLineOfMemory, .table = table},
                {.kind = "pixels", .write = true, .bytes = pixels, .run = kLineOfMemory, .table = pixels}};
  return run_phases({front, back}, 1, value(values, "watts"), memory);
}

std::vector<Parameter> parameters() {
  return {
      {"watts", 0.798, 0.798, 0.798, "W", Mark::kRead, "of its table, 7 nm"},
      {"cores", 4, 4, 4, "", Mark::kRead, "raster cores"},
      {"sorters", 8, 8, 8, "", Mark::kRead, "of 16 sorting cores, for the kept lists: each a key a cycle and level"},
      {"lanes", 64, 16, 64, "pixels/cycle", Mark::kNoted,
       "of a raster core: a subtile a cycle in the simulator; 16 as GSCore's cores have"},
      {"fresh", 0.1, 0, 0.22, "", Mark::kNoted, "share of keys that are new: nine tiles of ten keep more than 78 %"},
      {"mean_bytes", 6, 6, 6, "B", Mark::kRead, "of every Gaussian"},
      {"record_bytes", 128, 128, 128, "B", Mark::kRead, "112 in FP16, two lines, of those in the frustum"},
      {"feature_bytes", 64, 22, 64, "B", Mark::kNoted,
       "22 in FP16, a line each in its simulator; 22 if they were gathered"},
      {"fetch_bytes", 64, 32, 64, "B", Mark::kNoted,
       "a line for each (Gaussian, tile) in its simulator; 32 as one burst"},
      {"key_bytes", 6, 6, 6, "B", Mark::kRead, "depth in FP16, 32-bit index"},
      {"list_bytes", 192, 64, 192, "B", Mark::kNoted,
       "three lines for a new key in its simulator; one if two were kept"},
  };
}

}  // namespace

const Rival& neo() {
  static const Rival rival{"neo",
                           "Neo",
                           "ASPLOS 2026",
                           {"ASAP7",
                            7,
                            {0.031, 0.0583, 0.0875},
                            "NAND2 of the open library, half and whole drive; low: 28 nm by the square of the node"},
                           1,
                           0.387,
                           parameters(),
                           frame};
  return rival;
}

}  // namespace pipegs
