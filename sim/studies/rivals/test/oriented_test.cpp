// SPDX-License-Identifier: Apache-2.0
// oriented_test: the machine of design point gscore against GSCore's tests in float64: which tiles of 16 pixels and
// which of their four subtiles the oriented box of each Gaussian touches.
//
// Idea    Our own scene, its Gaussians that have alpha >= 1/255 at a pixel: the machine drops others that its cull
//         sees. A tile counts when one of its subtiles is touched, also where a corner of the box reaches beyond
//         INRIA's square.
// Rule    The machine's box is never too small and at most a few hundredths of a pixel too large (pu_box), and records
//         are rounded: pairs agree within a fifth of a percent.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "scenes/generate/generate.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "sim/studies/rivals/count/cover.hpp"

namespace pipegs {
namespace {

constexpr int kSubtile = kTileSide / 2;

struct Pairs {
  uint64_t tiles = 0, subtiles = 0;
  void add(uint64_t touched) { tiles += touched != 0, subtiles += touched; }
};

// Subtiles of tile (x, y) that the box touches.
uint64_t touched(const SeenGaussian& s, int x, int y) {
  uint64_t count = 0;
  for (int part = 0; part < 4; ++part) {
    const glm::dvec2 middle = middle_of(kSubtile, 2 * x + part % 2, 2 * y + part / 2);
    count += box_touches(s, middle, half_of(kSubtile));
  }
  return count;
}

// The tiles of a row or column that have pixels between two coordinates.
std::pair<int, int> tiles_between(double low, double high, int tiles) {
  const auto tile = [&](double at) {
    return static_cast<int>(std::clamp(std::floor(at / kTileSide), -1.0, 1.0 * tiles));
  };
  return {std::max(tile(low), 0), std::min(tile(high) + 1, tiles)};
}

bool visible(const SeenGaussian& s) {
  std::vector<PixelSpan> spans;
  reached_spans(s, spans);
  return std::ranges::any_of(spans, [](const PixelSpan& span) { return !span.empty(); });
}

TEST(Oriented, TheMachineFindsThePairsOfTheFloat) {
  const Scene scene = generate_scene(1);
  const Camera camera = generated_cameras()[0];
  SimulateOptions options;
  options.config = find_design_point("gscore").config;
  Simulation simulation;
  simulate_golden(scene, camera, options, simulation);
  const TileGrid grid(camera, kTileSide);
  ASSERT_TRUE(camera.width % kTileSide == 0 && camera.height % kTileSide == 0);

  Pairs wanted, found;
  std::vector<bool> counts(scene.gaussians.size());
  for (const SeenGaussian& s : see(scene, camera, {})) {
    if (!visible(s)) continue;
    counts[s.index] = true;
    const double reach = std::hypot(s.half_long, s.half_short) + 1;  // to the corners of the box
    const auto [x0, x1] = tiles_between(s.mean.x - reach, s.mean.x + reach, grid.columns);
    const auto [y0, y1] = tiles_between(s.mean.y - reach, s.mean.y + reach, grid.rows);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) wanted.add(touched(s, x, y));
    }
  }
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      const GoldenWindow window = golden_window(simulation.input, static_cast<uint64_t>(x), static_cast<uint64_t>(y));
      for (const GoldenLayer& layer : window.layers) {
        for (const GoldenSplat& one : layer.splats) {
          if (counts[one.splat.index]) found.add(static_cast<uint64_t>(std::popcount(one.splat.mask)));
        }
      }
    }
  }
  EXPECT_GT(wanted.tiles, 300000u);
  EXPECT_NEAR(static_cast<double>(found.tiles) / static_cast<double>(wanted.tiles), 1, 0.002);
  EXPECT_NEAR(static_cast<double>(found.subtiles) / static_cast<double>(wanted.subtiles), 1, 0.002);
}

}  // namespace
}  // namespace pipegs
