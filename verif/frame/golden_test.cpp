// SPDX-License-Identifier: Apache-2.0
// golden_test: the whole golden model against the float64 truth, and what it must not depend on.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "cpp_model/su/su.hpp"
#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "cpp_model/frame_setup.hpp"
#include "sim/compare/background.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

TEST(Golden, ComesCloseToTheTruthInTheSameOrder) {
  // What is measured (docs/numerics/stability.md), less than a decibel below it.
  for (const auto& [alpha_w, color_w, decibel] : {std::tuple{8, 12, 58.0}, {10, 14, 67.5}, {12, 16, 70.5}}) {
    SimulateOptions options;
    options.config.alpha_w = alpha_w;
    options.config.color_w = color_w;
    const Scene scene = random_scene(1, 3000, 3);
    const Camera camera = test_camera(160, 120, 120);
    Simulation result;
    simulate_golden(scene, camera, options, result);
    simulate_truth(scene, camera, options, result);
    EXPECT_GT(result.psnr_numeric, decibel) << "alpha " << alpha_w << " bit";
    RecordProperty("psnr_alpha_" + std::to_string(alpha_w), std::to_string(result.psnr_numeric));
  }
}

// Small Gaussians far away: the dilation adds most of their area, so without the compensation the picture is far too
// dense.
TEST(Golden, AntialiasedScenesComeCloseToTheTruth) {
  Scene scene = random_scene(14, 3000, 1);
  scene.antialiased = true;
  for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale -= 2.0f;
  const Camera camera = test_camera(160, 120, 120);
  SimulateOptions options;
  EXPECT_THROW(
      {
        Simulation refused;
        simulate_golden(scene, camera, options, refused);
      },
      FrameError);
  options.config.antialias = 1;
  Simulation result, sharp;
  simulate_golden(scene, camera, options, result);
  simulate_truth(scene, camera, options, result);
  EXPECT_GT(result.psnr_numeric, 50.0);
  scene.antialiased = false;  // the stage is there and the frame's flag is 0: nothing changes
  simulate_golden(scene, camera, options, sharp);
  simulate_truth(scene, camera, options, sharp);
  EXPECT_GT(sharp.psnr_numeric, 50.0);
  EXPECT_LT(psnr(result.golden.image, sharp.golden.image), 40.0) << "the compensation was meant to matter";
  options.config.antialias = 0;
  Simulation plain;
  simulate_golden(scene, camera, options, plain);
  EXPECT_EQ(plain.golden.pixels, sharp.golden.pixels);
}

TEST(Golden, DoesNotDependOnThreadsUnitsOrStores) {
  const Scene scene = random_scene(2, 2000, 1);
  const Camera camera = test_camera(200, 140);
  SimulateOptions options;
  Simulation first;
  simulate_golden(scene, camera, options, first);
  options.config.units = 1;
  options.config.alpha_lines = 64;
  options.config.pixels_per_row = 1;
  Simulation second;
  simulate_golden(scene, camera, options, second);
  EXPECT_EQ(first.golden.pixels, second.golden.pixels);
  EXPECT_EQ(golden_frame(first.input, {.threads = 1, .progress = {}}).pixels, first.golden.pixels);
}

TEST(Golden, OneWindowIsTheCropOfTheFrame) {
  const Scene scene = random_scene(4, 2000, 0);
  const Camera camera = test_camera(200, 140);
  for (const int order : {0, 1}) {
    SimulateOptions options;
    options.config.order = order;
    Simulation all, one;
    simulate_golden(scene, camera, options, all);
    options.window = {1, 1};
    simulate_golden(scene, camera, options, one);
    EXPECT_EQ(max_abs_error(crop_window(all.golden.image, options), crop_window(one.golden.image, options)), 0)
        << "order " << order;
  }
}

// A crop is pixels of the whole frame, whatever it cuts through, and only the windows that hold it are rendered.
TEST(Golden, ACropIsPixelsOfTheFrame) {
  const Scene scene = random_scene(4, 2000, 1);
  const Camera camera = test_camera(300, 211);
  for (const char* design_point : {"dop", "baseline", "fast"}) {
    SCOPED_TRACE(design_point);
    SimulateOptions options;
    options.config = find_design_point(design_point).config;
    Simulation all;
    simulate_golden(scene, camera, options, all);
    for (const PixelRect& crop :
         {PixelRect{0, 0, 300, 211}, {299, 210, 300, 211}, {127, 1, 130, 128}, {5, 64, 70, 66}}) {
      options.crop = crop;
      Simulation part;
      simulate_golden(scene, camera, options, part);
      const int side = options.config.window;
      EXPECT_EQ(part.golden.work.windows,
                ((crop.x1 - 1) / side - crop.x0 / side + 1ull) * ((crop.y1 - 1) / side - crop.y0 / side + 1ull));
      size_t unlike = 0;
      for (int y = crop.y0; y < crop.y1; ++y) {
        for (int x = crop.x0; x < crop.x1; ++x) {
          const size_t at = all.golden.image.at(x, y);
          unlike += part.golden.pixels[at] != all.golden.pixels[at];
        }
      }
      EXPECT_EQ(unlike, 0u) << crop.x0 << "," << crop.y0;
      const Image image = crop_window(part.golden.image, options);
      EXPECT_EQ(image.width, crop.x1 - crop.x0);
      EXPECT_EQ(max_abs_error(image, crop_window(all.golden.image, options)), 0);
    }
  }
  for (const PixelRect& crop : {PixelRect{-1, 0, 5, 5}, {0, 0, 301, 5}, {0, 0, 5, 212}, {7, 7, 7, 9}, {9, 9, 8, 10}}) {
    SimulateOptions options;
    options.crop = crop;
    EXPECT_THROW(asked_pixels(300, 211, options), ConfigError);
  }
}

// The host adds what lies behind by the T of each pixel: over black it is the 8-bit picture, over any colour what real
// numbers give.
TEST(Golden, AFrameOverABackground) {
  SimulateOptions options;
  Simulation result;
  simulate_golden(random_scene(6, 2000, 0), test_camera(150, 90), options, result);
  const PixelRect all{0, 0, 150, 90};
  EXPECT_EQ(over_background(result.golden.pixels, 150, all, {0, 0, 0}).data,
            to_rgb8(result.golden.image, glm::dvec3(0)).data);
  const Background orange = {255, 128, 3};
  const Rgb8 picture = over_background(result.golden.pixels, 150, all, orange);
  size_t lit = 0;
  for (size_t i = 0; i < picture.data.size(); ++i) {
    const uint64_t pixel = result.golden.pixels[i / 3], t = pixel >> 48, color = pixel >> 16 * (i % 3) & 0xffff;
    const double exact =
        255 * std::ldexp(static_cast<double>(color), -14) + orange[i % 3] * std::ldexp(static_cast<double>(t), -15);
    EXPECT_EQ(picture.data[i], std::min(std::floor(exact + 0.5), 255.0)) << i;
    lit += t > 0 && t < 0x8000;
  }
  EXPECT_GT(lit, 1000u) << "nothing to see";
  const Rgb8 part = over_background(result.golden.pixels, 150, {7, 9, 8, 10}, orange);
  EXPECT_EQ(part.data,
            (std::vector<uint8_t>(picture.data.begin() + 3 * (9 * 150 + 7), picture.data.begin() + 3 * (9 * 150 + 8))));
}

// Lists and watermarks give every window the one global order, so they give the same pixels, whatever is cached.
TEST(Golden, ListsGiveThePixelsOfTheExactOrder) {
  for (uint64_t seed = 60; seed < 66; ++seed) {
    const Scene scene = random_scene(seed, 2000, static_cast<int>(seed % 4));
    const Camera camera = test_camera(260, 200, 90);
    std::vector<uint64_t> exact;
    for (const auto& [late, order, quadratic] : {std::tuple{1, 2, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}}) {
      SimulateOptions options;
      options.config.late = late, options.config.order = order, options.config.quadratic = quadratic;
      Simulation result;
      simulate_golden(scene, camera, options, result);
      if (exact.empty()) exact = result.golden.pixels;
      EXPECT_EQ(result.golden.pixels, exact) << "order " << order << ", late " << late << ", seed " << seed;
      EXPECT_GT(result.golden.work.blended, 0u);
      if (order != 1) continue;
      EXPECT_EQ(
          golden_frame({.packed = &result.packed, .frame = result.input.frame}, {.threads = 1, .progress = {}}).pixels,
          exact)
          << "one thread";
      EXPECT_LE(result.golden.work.fetched, scene.gaussians.size()) << "each Gaussian is fetched once";
      EXPECT_LE(result.golden.work.layers, result.golden.work.windows) << "at most one layer a window";
    }
  }
}

// A window of four parts is four windows of their size: the same pixels, and a Gaussian is fetched once for all four.
TEST(Golden, FourPartsGiveThePixelsOfTheirOwnWindows) {
  for (uint64_t seed = 70; seed < 74; ++seed) {
    const Scene scene = random_scene(seed, 2000, static_cast<int>(seed % 4));
    const Camera camera = test_camera(260, 200, 90);
    SimulateOptions options;
    options.config.late = options.config.quads = 1;
    options.config.order = 2;
    Simulation alone, parts;
    simulate_golden(scene, camera, options, alone);
    options.config.window = 128;
    simulate_golden(scene, camera, options, parts);
    EXPECT_EQ(parts.golden.pixels, alone.golden.pixels) << "seed " << seed;
    EXPECT_EQ(parts.golden.work.records, alone.golden.work.records);
    EXPECT_EQ(parts.golden.work.blended, alone.golden.work.blended);
    EXPECT_EQ(parts.golden.work.quads, alone.golden.work.quads);
    EXPECT_LT(parts.golden.work.fetched, alone.golden.work.fetched);
  }
}

// What pu_reach drops has no region: fewer Gaussians behind the cull, and the same picture.
TEST(Golden, TheTighterCullGivesTheSamePixels) {
  for (const int order : {0, 2}) {
    for (uint64_t seed = 80; seed < 84; ++seed) {
      const Scene scene = random_scene(seed, 2000, 1);
      const Camera camera = test_camera(260, 200, 90);
      SimulateOptions options;
      options.config.late = 1;
      options.config.order = order;
      Simulation loose, tight;
      simulate_golden(scene, camera, options, loose);
      options.config.tight_cull = 1;
      simulate_golden(scene, camera, options, tight);
      EXPECT_EQ(tight.golden.pixels, loose.golden.pixels) << "order " << order << ", seed " << seed;
      EXPECT_EQ(tight.golden.work.records, loose.golden.work.records);
      EXPECT_EQ(tight.golden.work.blended, loose.golden.work.blended);
      EXPECT_LT(tight.golden.work.visible, loose.golden.work.visible);
    }
  }
}

SimulateOptions with_tight_boxes() {
  SimulateOptions options;
  options.config.late = 1;
  options.config.order = 2;
  options.config.tight_boxes = 1;
  options.config.chunk = 8;
  return options;
}

// What the box of the ellipsoids drops, no window misses: with the largest scale in every node all boxes pass, because
// all are nearer than they reach.
TEST(Golden, TheBoxOfTheEllipsoidsGivesTheSamePixels) {
  for (uint64_t seed = 90; seed < 98; ++seed) {
    Scene scene = random_scene(seed, 4000, 1);
    for (Gaussian& gaussian : scene.gaussians) {
      if (seed % 2 == 0) gaussian.log_scale += glm::vec3(-1.5f, 0.5f, -1.0f);  // long and small ones
    }
    const Camera camera = test_camera(260, 200, seed % 4 < 2 ? 90 : 300);
    const SimulateOptions options = with_tight_boxes();
    Simulation tight;
    simulate_golden(scene, camera, options, tight);
    PackedScene open = *tight.input.packed;
    for (std::vector<Node>* nodes : {&open.cells, &open.groups, &open.chunks}) {
      for (Node& node : *nodes) node.scale_max = (uint64_t{1} << open.config.scale_w()) - 1;
    }
    GoldenInput input = tight.input;
    input.packed = &open;
    const GoldenFrame all = golden_frame(input, {});
    EXPECT_EQ(tight.golden.pixels, all.pixels) << "seed " << seed;
    EXPECT_EQ(tight.golden.work.blended, all.work.blended);
    EXPECT_LT(tight.golden.work.fetched, all.work.fetched);
  }
}

// The boxes of the ellipsoids pass chunks beyond the image's edges that those of the means drop, and the other way
// round. The golden window holds what the machine sends: that of the walk which the machine makes.
TEST(Golden, AWindowHasTheChunksOfTheWalkThatTheMachineMakes) {
  uint64_t other = 0;  // chunks that the boxes of the means drop
  for (uint64_t seed = 90; seed < 98; ++seed) {
    Scene scene = random_scene(seed, 4000, 1);
    for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale += glm::vec3(-1.5f, 0.5f, -1.0f);
    const SimulateOptions options = with_tight_boxes();
    Simulation simulation;
    simulate_golden(scene, test_camera(260, 200, 300), options, simulation);
    const auto& [packed, frame, picture, lists] = simulation.input;
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 5; ++x) {
        uint64_t sent = 0;
        std::set<uint64_t> means;
        const auto keep = [&](int, const Chunk&, uint64_t number) { means.insert(number); };
        dopu_window(packed->config, frame, *packed, x, y, keep);
        dopu_nearest(packed->config, frame, *packed, x, y, kWholeWalk, [&](int, const Chunk&, uint64_t number) {
          ++sent;
          other += !means.contains(number);
        });
        const GoldenWindow window = golden_window(simulation.input, static_cast<uint64_t>(x), static_cast<uint64_t>(y));
        EXPECT_EQ(window.work.chunks, sent) << "window " << x << "," << y << ", seed " << seed;
      }
    }
  }
  EXPECT_GT(other, 0u) << "no window in which the difference shows";
}

// What a frame's `rest` may change: of a pixel the share of its light that was left, from one colour to another.
TEST(Golden, ARestChangesAPixelByLessThanItself) {
  for (const char* point : {"fast", "dop", "exact"}) {
    SimulateOptions options;
    options.config = find_design_point(point).config;
    Scene scene = random_scene(51, 3000, 1);
    const Camera camera = test_camera(200, 150);
    Simulation all;
    simulate_golden(scene, camera, options, all);
    uint64_t blended = all.golden.work.blended;
    for (const double rest : {0.001, 0.02, 0.1, 0.5}) {
      SCOPED_TRACE(fmt::format("{}, rest {}", point, rest));
      options.rest = rest;
      Simulation early;
      simulate_golden(scene, camera, options, early);
      EXPECT_LE(early.golden.work.blended, blended);
      blended = early.golden.work.blended;
      double most = 0, brightest = 0;
      for (size_t i = 0; i < all.golden.image.rgb.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
          most = std::max(most, std::abs(early.golden.image.rgb[i][c] - all.golden.image.rgb[i][c]));
          brightest = std::max(brightest, all.golden.image.rgb[i][c]);
        }
      }
      EXPECT_LE(most, rest * 4 + 0.01) << "a colour is below 4";
      if (rest >= 0.1) EXPECT_GT(most, 0.001) << "nothing was left out";
      EXPECT_GT(brightest, 0.2);
    }
    EXPECT_LT(blended, all.golden.work.blended * 9 / 10);
    options.rest = 0;
    Simulation again;
    simulate_golden(scene, camera, options, again);
    EXPECT_EQ(again.golden.pixels, all.golden.pixels);
  }
}

// Walked whole, part by part, or some so and some so: the same pixels, from the same pairs.
TEST(Golden, WindowsWalkedPartByPartGiveTheSamePixels) {
  SimulateOptions options;
  options.config = find_design_point("fast").config;
  uint64_t split = 0, whole = 0;
  for (uint64_t seed = 40; seed < 44; ++seed) {
    Scene scene = random_scene(seed, 4000, 1);
    for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale -= 1.5f;
    const Camera camera = test_camera(300, 323, seed % 2 == 0 ? 90 : 300);
    Simulation never;
    options.walk_most = 0;
    simulate_golden(scene, camera, options, never);
    for (const uint64_t most : {1, 1500, 2500, 3500}) {
      SCOPED_TRACE(fmt::format("seed {}, at most {}", seed, most));
      options.walk_most = most;
      Simulation parts;
      simulate_golden(scene, camera, options, parts);
      EXPECT_EQ(parts.golden.pixels, never.golden.pixels);
      EXPECT_EQ(parts.golden.stopped, never.golden.stopped);
      EXPECT_EQ(parts.golden.image.depth, never.golden.image.depth);
      EXPECT_EQ(parts.golden.work.blended, never.golden.work.blended);
      EXPECT_LE(parts.golden.work.records, never.golden.work.records);  // none beyond the picture
      EXPECT_GE(parts.golden.work.fetched, never.golden.work.fetched);
      for (uint64_t i = 0; i < 9; ++i) {
        const GoldenWindow window = golden_window(parts.input, i % 3, i / 3);
        (window.in_parts() ? split : whole) += !window.layers.empty();
        // 300 pixels are 2 windows and 44 of a part, 323 are 2 windows, a part and 3 of the next one.
        const size_t walks = !window.in_parts() ? 1 : i % 3 == 2 ? 2 : 4;
        EXPECT_EQ(window.walks.size(), walks) << "window " << i;
        for (const GoldenLayer& layer : window.layers) {
          EXPECT_TRUE(std::is_sorted(layer.splats.begin(), layer.splats.end(), [&](const auto& a, const auto& b) {
            if (window.in_parts() && a.splat.part != b.splat.part) return a.splat.part < b.splat.part;
            return splat_before(a.splat, b.splat);
          }));
        }
      }
    }
  }
  EXPECT_GT(split, 20u);
  EXPECT_GT(whole, 20u);
}

// The rank of lists is the order of depth: of two Gaussians that are drawn, the nearer one comes first.
TEST(Golden, ListsRankByDepth) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 40; ++i) gaussians.push_back(gaussian_at({0.01f * (i % 3), 0, 5 - 0.1f * i}));
  SimulateOptions options;
  options.config.order = 1;
  Simulation result;
  simulate_golden(scene_of(gaussians), test_camera(64, 64), options, result);
  for (uint32_t i = 0; i < 40; ++i) EXPECT_EQ(result.golden.rank[i], 39 - i);
}

// A region that holds no pixel that counts blends nothing: without the test there is more work, and the same picture.
TEST(Golden, TheRegionsOfTheWholeBoxGiveTheSamePixels) {
  const Scene scene = random_scene(9, 2000, 1);
  const Camera camera = test_camera(200, 140);
  for (const int alpha_cut : {32, 255, 1023}) {
    SimulateOptions options;
    options.config.alpha_cut = alpha_cut;
    Simulation tested, box;
    simulate_golden(scene, camera, options, tested);
    options.config.tile_test = 0;
    simulate_golden(scene, camera, options, box);
    EXPECT_EQ(tested.golden.pixels, box.golden.pixels) << "cut at 1/" << alpha_cut;
    EXPECT_GT(box.golden.work.regions, tested.golden.work.regions);
    EXPECT_EQ(box.golden.work.blended, tested.golden.work.blended);
  }
}

// The truth keeps 1/255 and 1e-4: what the machine cuts away besides shows in the picture, and only there.
TEST(Golden, CutsOfAlphaAndTransmittanceMoveThePictureAwayFromTheTruth) {
  const Scene scene = random_scene(10, 3000, 0);
  const Camera camera = test_camera(160, 120, 120);
  const auto run = [&](int alpha_cut, int t_cut) {
    SimulateOptions options;
    options.config.alpha_cut = alpha_cut, options.config.t_cut = t_cut;
    Simulation result;
    simulate_golden(scene, camera, options, result);
    simulate_truth(scene, camera, options, result);
    return std::pair{result.psnr_numeric, result.golden.work.blended};
  };
  const auto standard = run(255, 10000), opaque = run(255, 100), faint = run(1023, 10000), coarse = run(32, 10000);
  EXPECT_LT(opaque.first, standard.first);
  EXPECT_LT(coarse.first, standard.first);
  EXPECT_LT(opaque.second, standard.second);
  EXPECT_LT(coarse.second, standard.second);
  EXPECT_GT(faint.second, standard.second);
}

// A part that nothing calls for changes no pixel when it is left out.
TEST(Golden, PartsThatNothingCallsForChangeNoPixel) {
  Scene scene = random_scene(12, 300, 1);
  for (Gaussian& gaussian : scene.gaussians) {
    gaussian.mean.z = std::abs(gaussian.mean.z) + 0.5f;
    gaussian.mean.x = 0.3f * gaussian.mean.z * std::sin(gaussian.mean.x),
    gaussian.mean.y = 0.3f * gaussian.mean.z * std::sin(gaussian.mean.y);
    gaussian.log_scale -= glm::vec3(2), gaussian.opacity_logit = std::min(gaussian.opacity_logit, -2.0f);
  }
  SimulateOptions options;
  Simulation all, none;
  simulate_golden(scene, test_camera(100, 80), options, all);
  const Called& called = all.golden.called;
  ASSERT_EQ(called.near + called.guard + called.stopped + called.ties + all.golden.saturations.accumulated +
                all.golden.saturations.color,
            0u);
  for (const char* part :
       {"near_test", "guard_band", "saturation", "early_stop", "index_ties", "overflow", "large_groups"}) {
    config_set(options.config, std::string(part) + "=0");
  }
  simulate_golden(scene, test_camera(100, 80), options, none);
  EXPECT_EQ(none.golden.pixels, all.golden.pixels);
}

// What a part does when it is called for, counted, and the other picture without it.
TEST(Golden, CountsWhatPartsAreCalledFor) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 40; ++i) gaussians.push_back(gaussian_at({0.001f * i, 0, 2 + 0.05f * i}, 2.0f, 0.9, {4, 4, 4}));
  gaussians.push_back(gaussian_at({0, 0, 2}, 2.0f, 0.9));  // as deep as the first one
  for (const float z : {0.19f, 0.21f})
    gaussians.push_back(gaussian_at({0.01f, 0, z}, 0.02f));  // before the near plane and behind it
  gaussians.push_back(gaussian_at({3, 0, 0.5f}, 2.0f));      // far beside the image
  const Scene scene = scene_of(gaussians);
  const auto run = [&](const char* setting) {
    SimulateOptions options;
    config_set(options.config, setting);
    Simulation result;
    simulate_golden(scene, test_camera(64, 64), options, result);
    return std::pair{result.golden.pixels, result.golden.called};
  };
  const auto [pixels, called] = run("taps=1");
  EXPECT_GT(called.near, 0u);
  EXPECT_GT(called.guard, 0u);
  EXPECT_GT(called.stopped, 0u);
  EXPECT_GT(called.ties, 0u);
  EXPECT_GT(called.layers, 1u);
  for (const char* setting : {"near_test=0", "guard_band=0", "early_stop=0"})
    EXPECT_NE(run(setting).first, pixels) << setting;
  EXPECT_EQ(run("layered=0").second.layers, 1u);
  EXPECT_EQ(run("early_stop=0").second.stopped, 0u);
}

TEST(Golden, RanksEveryGaussianEvenWhenTheLastOnesAreLeftOut) {
  Scene scene = random_scene(8, 300, 0);
  for (size_t i = 290; i < 300; ++i) scene.gaussians[i].opacity_logit = -20;  // below 1/255: not packed
  SimulateOptions options;
  Simulation result;
  simulate_golden(scene, test_camera(64, 64), options, result);
  EXPECT_EQ(result.golden.rank.size(), scene.gaussians.size());
  simulate_truth(scene, test_camera(64, 64), options, result);
  EXPECT_GT(result.psnr_numeric, 50);
}

TEST(Golden, TransmittanceAndWeightsSumToOne) {
  // A white scene: every colour is 1, so accumulated colour = sum of weights = 1 - T up to the colour's own rounding.
  Scene scene = random_scene(6, 1500, 0);
  for (Gaussian& gaussian : scene.gaussians) gaussian.sh_dc = glm::vec3(0.5f / 0.28209479177387814f);
  Simulation result;
  simulate_golden(scene, test_camera(128, 128), SimulateOptions{}, result);
  for (size_t i = 0; i < result.golden.image.rgb.size(); ++i) {
    ASSERT_NEAR(result.golden.image.rgb[i].r, 1 - result.golden.image.transmittance[i], 0.01) << "pixel " << i;
  }
}

TEST(Golden, EveryWindowSideGivesThePictureWithinTheRoundingOfItsAnchors) {
  const Scene scene = random_scene(7, 1500, 0);
  const Camera camera = test_camera(130, 100);
  SimulateOptions options;
  Simulation reference;
  simulate_golden(scene, camera, options, reference);
  for (const int side : {16, 32}) {
    options.config.window = side;
    Simulation result;
    simulate_golden(scene, camera, options, result);
    EXPECT_GT(psnr(result.golden.image, reference.golden.image), 60) << "window " << side;
  }
}

}  // namespace
}  // namespace pipegs
