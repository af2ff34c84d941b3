// SPDX-License-Identifier: Apache-2.0
// profile.cpp: see profile.hpp.
#include "sim/studies/profile/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"
#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTile = 16;  // pixels, Sec. 2.1
constexpr int kTileSizes[] = {8, 16, 32, 64};

// Tiles of the image that a splat of a window touches.
int tiles_of(const Config& config, const Frame& frame, uint64_t window_x, uint64_t window_y, const Splat& splat) {
  const int side = config.part_regions_x(), per_tile = kTile / 8, tiles = std::max(1, side / per_tile);
  const int first = region_number(config, splat.part, 0);  // region of the part
  const uint64_t left = window_x * config.window + 8 * region_x(config, first),
                 top = window_y * config.window + 8 * region_y(config, first);
  int count = 0;
  for (int ty = 0; ty < tiles; ++ty) {
    for (int tx = 0; tx < tiles; ++tx) {
      if (left + static_cast<uint64_t>(tx) * kTile >= frame.raster.width) continue;
      if (top + static_cast<uint64_t>(ty) * kTile >= frame.raster.height) continue;
      bool any = false;
      for (int r = 0; r < per_tile * per_tile; ++r) {
        const int x = tx * per_tile + r % per_tile, y = ty * per_tile + r / per_tile;
        any = any || (splat.mask >> (y * side + x) & 1) != 0;
      }
      count += any;
    }
  }
  return count;
}

double share(double part, double whole) { return whole > 0 ? part / whole : std::nan(""); }

}  // namespace

PixelArithmetic dpc_arithmetic(int tile) {
  const double pixels = static_cast<double>(tile) * tile;
  return {.tile = tile, .multiplications = (4 + 4.0 * tile) / pixels, .additions = (6 + 4.0 * tile) / pixels + 2};
}

ViewProfile view_profile(const Simulation& simulation, const SimulateOptions& options) {
  const GoldenInput& input = simulation.input;
  const Frame& frame = input.frame;
  const Config& config = options.config;
  const uint64_t columns = frame.raster.windows.last_x - frame.raster.windows.first_x + 1,
                 windows = columns * (frame.raster.windows.last_y - frame.raster.windows.first_y + 1);
  ViewProfile profile;
  std::vector<uint32_t> tiles(simulation.packed.scene_gaussians, 0);
  std::mutex mutex;
  uint64_t finished = 0;
  Progress progress("counting");
  parallel_for(windows, 0, [&](size_t i) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const GoldenWindow window =
        golden_window(input, frame.raster.windows.first_x + i % columns, frame.raster.windows.first_y + i / columns);
    const std::lock_guard lock(mutex);
    for (const GoldenLayer& layer : window.layers) {
      for (const GoldenSplat& splat : layer.splats) {
        const int count = tiles_of(config, frame, window.x, window.y, splat.splat);
        tiles[simulation.packed.scene_index(splat.splat.index)] += static_cast<uint32_t>(count);
        profile.window_pairs += count > 0;
      }
    }
    progress.update(static_cast<double>(++finished) / static_cast<double>(windows));
  });
  for (const uint32_t count : tiles) {
    if (count == 0) continue;
    ++profile.visible;
    profile.tile_pairs += count;
    profile.in_two += count >= 2;
    profile.inverse_tiles += 1.0 / count;
    profile.tiles.push_back(count);
  }
  if (profile.visible > 0) profile.inverse_tiles /= static_cast<double>(profile.visible);
  return profile;
}

Json profile_json(const ViewProfile& profile) {
  Json json;
  const auto visible = static_cast<double>(profile.visible), pairs = static_cast<double>(profile.tile_pairs);
  json["gaussians"] = {{"visible", profile.visible},
                       {"tile_pairs", profile.tile_pairs},
                       {"window_pairs", profile.window_pairs},
                       {"mean_tiles", finite_json(share(pairs, visible))},
                       {"share_in_two_or_more", finite_json(share(static_cast<double>(profile.in_two), visible))}};
  json["coefficient_cost"] = {
      {"once_per_gaussian", finite_json(share(visible, pairs))},
      {"once_per_gaussian_and_window", finite_json(share(static_cast<double>(profile.window_pairs), pairs))},
      {"mean_of_inverse_tiles", profile.inverse_tiles}};
  for (const int tile : kTileSizes) {
    const PixelArithmetic cost = dpc_arithmetic(tile);
    json["arithmetic_per_pixel"]["dpc"].push_back(
        {{"tile", tile}, {"multiplications", cost.multiplications}, {"additions", cost.additions}});
  }
  json["arithmetic_per_pixel"]["direct"] = {{"multiplications", kDirectMultiplications},
                                            {"additions", kDirectAdditions}};
  return json;
}

std::vector<Table> profile_tables(const ViewProfile& profile) {
  const auto visible = static_cast<double>(profile.visible), pairs = static_cast<double>(profile.tile_pairs);
  Table table{.columns = {{.key = "what", .heading = "what", .word = true},
                          {.key = "here", .heading = "here"},
                          {.key = "paper", .heading = "paper", .word = true},
                          {.key = "why", .heading = "why they differ", .word = true, .wrapped = true}}};
  const auto line = [&](const std::string& what, const std::string& here, const std::string& paper,
                        const std::string& why) {
    table.rows.push_back({text_cell(what), text_cell(here), text_cell(paper), text_cell(why)});
  };
  const auto percent = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.1f} %", 100 * value) : std::string("-");
  };
  const auto number = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.2f}", value) : std::string("-");
  };
  line("visible Gaussians", std::to_string(profile.visible), "", "alpha >= 1/255 in some pixel");
  line("mean tiles of 16x16 of a visible Gaussian", number(share(pairs, visible)), "2.6 to 6.7",
       "other scenes; here a tile counts only if alpha >= 1/255 in a pixel of it");
  line("in two tiles or more", percent(share(static_cast<double>(profile.in_two), visible)), "over 70 %",
       "as the mean");
  line("coefficients once per Gaussian, cost", number(share(visible, pairs)) + "x", "0.15 to 0.52x",
       "10 operations a Gaussian against 10 a pair: 1 / mean tiles");
  line("  mean over the Gaussians of 1 / tiles", number(profile.inverse_tiles) + "x", "",
       "the same, every Gaussian weighing equally");
  line("  once per Gaussian and window (as built)",
       number(share(static_cast<double>(profile.window_pairs), pairs)) + "x", "",
       "a window is 4x4 tiles by default; alphas of a frame do not fit on chip");
  Table arithmetic{
      .columns = {{.key = "form", .heading = "operations on a pixel's power", .word = true},
                  {.key = "multiplications", .heading = "multiplications", .digits = 3},
                  {.key = "additions", .heading = "additions", .digits = 3},
                  {.key = "multiplications_saved", .heading = "multiplications saved", .unit = "%", .digits = 1},
                  {.key = "all_saved", .heading = "all saved", .unit = "%", .digits = 1},
                  {.key = "paper", .heading = "paper", .word = true}}};
  arithmetic.rows.push_back({text_cell("Eq. 1 for every pixel"),
                             number_cell(kDirectMultiplications),
                             number_cell(kDirectAdditions),
                             {},
                             {},
                             {}});
  for (const int tile : kTileSizes) {
    const PixelArithmetic cost = dpc_arithmetic(tile);
    arithmetic.rows.push_back(
        {text_cell(fmt::format("differences, tiles of {0}x{0}", tile)), number_cell(cost.multiplications),
         number_cell(cost.additions), number_cell(100 * (1 - cost.multiplications / kDirectMultiplications)),
         number_cell(100 * (1 - (cost.multiplications + cost.additions) / (kDirectMultiplications + kDirectAdditions))),
         text_cell(tile == kTile ? "96.2 %, 76.9 %" : "")});
  }
  return {table, arithmetic};
}

std::vector<Chart> profile_charts(const ViewProfile& profile) {
  Chart tiles{.name = "tiles",
              .form = Chart::Form::kBars,
              .title = "Tiles of 16x16 that a visible Gaussian reaches",
              .x_label = "tiles",
              .y_label = "% of the Gaussians"};
  tiles.series = {{"share", {}}};
  for (int from = 1; from <= 64; from = from < 4 ? from + 1 : 2 * from) {
    const double to = from < 4 ? from + 1 : from == 64 ? HUGE_VAL : 2.0 * from;
    const auto count = std::count_if(profile.tiles.begin(), profile.tiles.end(),
                                     [&](double tile) { return tile >= from && tile < to; });
    tiles.categories.push_back(from < 4     ? std::to_string(from)
                               : from == 64 ? "64+"
                                            : fmt::format("{}-{}", from, 2 * from - 1));
    tiles.series[0].values.push_back(100 * share(static_cast<double>(count), static_cast<double>(profile.visible)));
  }
  tiles.note = fmt::format("mean {:.2f}; paper (Fig. 5b): 2.6 to 6.7",
                           share(static_cast<double>(profile.tile_pairs), static_cast<double>(profile.visible)));
  Chart arithmetic{.name = "arithmetic",
                   .form = Chart::Form::kStacked,
                   .title = "Operations on a pixel's power (paper: Fig. 4)",
                   .y_label = "operations",
                   .categories = {"direct"}};
  arithmetic.series = {{"multiplications", {kDirectMultiplications}}, {"additions", {kDirectAdditions}}};
  for (const int tile : kTileSizes) {
    const PixelArithmetic cost = dpc_arithmetic(tile);
    arithmetic.categories.push_back(fmt::format("{0}x{0}", tile));
    arithmetic.series[0].values.push_back(cost.multiplications);
    arithmetic.series[1].values.push_back(cost.additions);
  }
  return {tiles, arithmetic};
}

}  // namespace pipegs
