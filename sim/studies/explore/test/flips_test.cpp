// SPDX-License-Identifier: Apache-2.0
// flips_test: flipped decisions against a count pixel by pixel.
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "sim/compare/simulate.hpp"
#include "sim/studies/explore/flips.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

struct View {
  View(const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) config_set(options.config, setting);
    simulate_pack(scene, camera, options, simulation);
    simulation.golden = golden_frame(simulation.input, {});
  }
  Scene scene = random_scene(5, 250, 0);
  Camera camera = test_camera(100, 80);
  SimulateOptions options;
  Simulation simulation;
};

// Pixel by pixel: every Gaussian of the scene in the machine's order.
Flips brute_force(const View& view) {
  const Config& config = view.options.config;
  const std::vector<uint32_t>& rank = view.simulation.golden.rank;
  std::vector<uint32_t> order(rank.size());
  for (uint32_t i = 0; i < rank.size(); ++i) order[rank[i]] = i;
  std::map<std::pair<uint64_t, uint64_t>, std::map<uint32_t, GoldenSplat>> windows;
  const BlendConstants constants(config);
  const uint64_t side = config.window;
  std::vector<TruthProjection> truth(rank.size());  // not visible: left out
  for (size_t i = 0; i < rank.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(view.scene, i, gaussian) == Cull::kNone)
      truth[i] = project_truth(gaussian, view.scene.gaussians[i].sh_dc, nullptr, 0, view.camera, {});
  }
  Flips flips;
  for (int y = 0; y < view.camera.height; ++y) {
    for (int x = 0; x < view.camera.width; ++x) {
      const std::pair<uint64_t, uint64_t> at{x / side, y / side};
      if (!windows.contains(at)) {
        const GoldenWindow window = golden_window(view.simulation.input, at.first, at.second);
        for (const GoldenLayer& layer : window.layers) {
          for (const GoldenSplat& splat : layer.splats) windows[at][static_cast<uint32_t>(splat.splat.index)] = splat;
        }
        windows[at];
      }
      const int region = static_cast<int>(y % side / 8) * config.part_regions_x() + static_cast<int>(x % side / 8);
      PixelState pixel{.t = constants.one};
      for (const uint32_t index : order) {
        uint16_t codes[64] = {};
        const auto found = windows[at].find(index);
        if (found != windows[at].end() && (found->second.splat.mask >> region & 1) != 0)
          golden_codes(config, found->second.job, region, codes);
        const uint32_t code = codes[y % 8 * 8 + x % 8];
        const TruthProjection& p = truth[index];
        const bool counts =
            p.visible &&
            p.opacity * std::exp(std::min(0.0, power_at(p.conic, p.mean.x - x, p.mean.y - y))) >= kMinAlpha;
        if (!pixel.done) flips.decisions += code != 0 || counts, flips.flipped += (code != 0) != counts;
        if (found == windows[at].end()) continue;
        const uint32_t color[3] = {0, 0, 0};
        ru_blend(constants, pixel, code, color);
      }
    }
  }
  return flips;
}

TEST(Flips, AreThoseOfACountPixelByPixel) {
  for (const std::vector<std::string>& settings : {std::vector<std::string>{},
                                                   {"power_f=12"},
                                                   {"late=1", "order=2", "window=16", "mean_f=6", "t_w=14"},
                                                   {"alpha_cut=64"},
                                                   {"grid=1", "alpha_cut=1023"}}) {
    const View view(settings);
    SCOPED_TRACE(config_difference(view.options.config));
    const FlipCounter counter(view.scene, view.camera, 0.2, {0, 0, 100, 80}, 1000);
    EXPECT_EQ(counter.sampled(), 1);
    const Flips expected = brute_force(view), found = counter.count(view.simulation.input, view.simulation.golden.rank);
    EXPECT_EQ(found.decisions, expected.decisions);
    EXPECT_EQ(found.flipped, expected.flipped);
    EXPECT_GT(expected.decisions, 5000u);
    if (!settings.empty()) EXPECT_GT(expected.flipped, 0u);
  }
}

TEST(Flips, ASampleIsAPartOfTheSquares) {
  const View view({});
  const FlipCounter part(view.scene, view.camera, 0.2, {0, 0, 100, 80}, 2),
      all(view.scene, view.camera, 0.2, {0, 0, 100, 80}, 4);
  EXPECT_LT(part.sampled(), 0.9);
  EXPECT_GT(part.sampled(), 0.1);
  EXPECT_LT(part.count(view.simulation.input, view.simulation.golden.rank).decisions,
            all.count(view.simulation.input, view.simulation.golden.rank).decisions);
}

}  // namespace
}  // namespace pipegs
