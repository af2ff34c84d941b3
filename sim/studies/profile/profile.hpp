// SPDX-License-Identifier: Apache-2.0
// profile.hpp: how often the Gaussians of a view could be reused: the paper's Fig. 3b, 4 and 5b for one view.
//
// Idea    Counts come from the golden model: which Gaussians reach which tiles of 16x16 pixels, nothing skipped.
// Docs    docs/commands.md
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
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
  uint64_t visible = 0;       // Gaussians with alpha >= 1/255 in some pixel of the image
  uint64_t tile_pairs = 0;    // (Gaussian, tile)
  uint64_t window_pairs = 0;  // (Gaussian, window)
  uint64_t in_two = 0;        // Gaussians in two tiles or more
  std::vector<double> tiles;  // of each visible Gaussian
  double inverse_tiles = 0;   // mean over the Gaussians of 1 / tiles
};

// Needs simulate_golden.
ViewProfile view_profile(const Simulation& simulation, const SimulateOptions& options);

nlohmann::ordered_json profile_json(const ViewProfile& profile);
std::vector<Table> profile_tables(const ViewProfile& profile);
std::vector<Chart> profile_charts(const ViewProfile& profile);

}  // namespace pipegs
