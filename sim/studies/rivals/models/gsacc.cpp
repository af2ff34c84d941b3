// SPDX-License-Identifier: Apache-2.0
// gsacc.cpp: GSAcc (Yang et al., DAC 2025, doi 10.1109/DAC63849.2025.11133032).
//
// Published  The depths of the last frame give the order of this one, so nothing waits for a sort; each Gaussian is
//            projected once and rasterized over all its tiles, without lists. Codebooks; a cache of tiles, of which
//            neighbours in depth share 11.4 %; a 32-way bitonic sorter with a 4-way merge for the next frame's order.
//            16 raster cores; 500 MHz, Intel 16, 0.3913 mm2, 0.4085 W. Errors below 1 %.
// Assumed    Its text was not at hand: all of it is from notes. Pixels a cycle: 16 of one core or of all, so from 16 to
//            256, mid the geometric mean; 256 would not fit into its area at GSCore's area of a lane. Bytes of a
//            Gaussian: one line. Tiles that are opaque are not rasterized. Pixels stay on the chip (`spilled` 0): 2 KB
//            of a tile read and written for each that is not in the cache would be GBs a frame.
#include "sim/studies/rivals/models/tiles.hpp"

namespace pipegs {
namespace {

constexpr double kTileBytes = 2048;  // T and RGB of 256 pixels, 16 bits each

MachineFrame frame(const FrameCounts& counts, const Values& values, PlayedMemory& memory) {
  const double visible = static_cast<double>(counts.listed.oriented);
  double pairs = 0;
  for (const TileCounts& tile : counts.tiles) pairs += static_cast<double>(tile.open.oriented);
  const NeighbourCounts& near = counts.neighbours;
  const double shared = near.tiles > 0 ? static_cast<double>(near.shared) / static_cast<double>(near.tiles) : 0;
  const double spilled = value(values, "spilled") * pairs * (1 - shared) * kTileBytes;
  const double scene = static_cast<double>(counts.scene), pixels = kPixelBytes * counts.width * counts.height;
  const double record = value(values, "record_bytes");
  Phase all = even_phase("frame",
                         {{.kind = "records", .bytes = visible * record, .run = record, .table = scene * record},
                          {.kind = "order", .bytes = scene * value(values, "order_bytes")},
                          {.kind = "order", .write = true, .bytes = scene * value(values, "order_bytes")},
                          {.kind = "tiles", .bytes = spilled, .run = kTileBytes, .table = 2 * pixels},
                          {.kind = "tiles", .write = true, .bytes = spilled, .run = kTileBytes, .table = 2 * pixels},
                          {.kind = "pixels", .write = true, .bytes = pixels}},
                         visible, "projection", 1, value(values, "project_rate"));
  const std::vector<double> blocks(all.shares.size(), 1.0 / static_cast<double>(all.shares.size()));
  const auto part = [&](double cycles) { return std::vector<double>(blocks.size(), cycles * blocks.front()); };
  all.stages.push_back({"raster cores", 1, part(pairs * kTilePixels / value(values, "lanes"))});
  all.stages.push_back({"sorter", 1, part(scene / value(values, "sort_rate"))});
  return run_phases({all}, 0.5, value(values, "watts"), memory);
}

std::vector<Parameter> parameters() {
  return {
      {"watts", 0.4085, 0.4085, 0.4085, "W", Mark::kNoted, "Intel 16, 500 MHz"},
      {"lanes", 64, 16, 256, "pixels/cycle", Mark::kNoted, "16 raster cores of 1 to 16 pixels"},
      {"record_bytes", 64, 24, 236, "B", Mark::kAssumed, "of a Gaussian: codebooks, to all in FP32"},
      {"order_bytes", 6, 4, 8, "B", Mark::kAssumed, "of a Gaussian in the order, read and written"},
      {"project_rate", 1, 0.25, 1, "Gaussians/cycle", Mark::kAssumed, "projected"},
      {"sort_rate", 4, 1, 8, "keys/cycle", Mark::kAssumed, "of the sorter for the next frame"},
      {"spilled", 0, 0, 0, "", Mark::kAssumed,
       "share of pixels' tiles that go to memory when not in the cache; 1: all"},
  };
}

}  // namespace

const Rival& gsacc() {
  static const Rival rival{"gsacc",
                           "GSAcc",
                           "DAC 2025",
                           {"Intel 16",
                            16,
                            {0.16, 0.204, 0.204},
                            "a NAND2 of three gate pitches of 108 nm by 630 nm; "
                            "low: 28 nm by the square of the node"},
                           0.5,
                           0.3913,
                           parameters(),
                           frame};
  return rival;
}

}  // namespace pipegs
