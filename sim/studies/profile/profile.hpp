// SPDX-License-Identifier: Apache-2.0
// profile.hpp: what a view asks of the machine: the paper's Fig. 3, 4 and 5b for one view.
//
// Idea    Counts come from the golden model: which Gaussians reach which tiles of 16x16 pixels and which regions of
//         8x8, nothing skipped. Times come from an RTL run when there was one, else from the counts at full rate: one
//         Gaussian fetched, one key, a quarter of a region per cycle and unit.
// Docs    docs/commands.md
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/ladder/ladder.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

// Operations on one pixel's power with differences (DPC, Sec. 3.1) in tiles of n x n pixels: 4 multiplications and
// 6 additions a tile for the coefficients, 4 and 4 a row, 2 additions a pixel.
struct PixelArithmetic {
  int tile = 0;
  double multiplications = 0, additions = 0;
};
PixelArithmetic dpc_arithmetic(int tile);
inline constexpr double kDirectMultiplications = 7, kDirectAdditions = 4;  // of Eq. 1 for every pixel, Sec. 3.1

struct ViewProfile {
  // Counts.
  uint64_t visible = 0;        // Gaussians with alpha >= 1/255 in some pixel of the image
  uint64_t tile_pairs = 0;     // (Gaussian, tile)
  uint64_t window_pairs = 0;   // (Gaussian, window)
  uint64_t in_two = 0;         // Gaussians in two tiles or more
  std::vector<double> tiles;   // of each visible Gaussian
  double inverse_tiles = 0;    // mean over the Gaussians of 1 / tiles
  std::vector<double> ratios;  // raster over sort time of each window that sorts something
  // Time by stage, cycles summed over the units.
  bool measured = false;  // by the RTL; else the counts at full rate
  double preprocess = 0, sort = 0, raster = 0;
  uint64_t cycles = 0;  // of the frame; 0 unless measured
  double bubbles = 0, exposed = 0;
};

// Needs simulate_golden; `watch` and the simulation's RTL figures count when `watch` is not null.
ViewProfile view_profile(const Simulation& simulation, const SimulateOptions& options, const FigureWatch* watch);

nlohmann::ordered_json profile_json(const ViewProfile& profile);
std::vector<Table> profile_tables(const ViewProfile& profile);
std::vector<Chart> profile_charts(const ViewProfile& profile);

}  // namespace pipegs
