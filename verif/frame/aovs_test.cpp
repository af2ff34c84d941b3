// SPDX-License-Identifier: Apache-2.0
// aovs_test: what a frame writes beside its colours (cpp_model/ru/ru_aovs.hpp): by hand, and against the float64 truth
// by bounds that follow from the formats.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/bounds/frame.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kAll = 15;

Config with_aovs(const char* design_point = "fast") {
  Config config = find_design_point(design_point).config;
  config.quads = 1;
  config.pixel_w = 32;
  config.aov_coverage = config.aov_depth = config.aov_median = config.aov_index = 1;
  config_check(config);
  return config;
}

SimulateOptions options_with_aovs(const char* design_point = "fast") {
  SimulateOptions options;
  options.config = with_aovs(design_point);
  options.aovs = kAll;
  return options;
}

// --- a pixel, by hand ------------------------------------------------------------------------------------------------

class Pixel {
 public:
  void add(double alpha, double depth, uint64_t index) {
    const auto code = static_cast<uint32_t>(std::lround(alpha * (1 << config.alpha_w)));
    const uint32_t black[3] = {0, 0, 0};
    const uint32_t before = state.t;
    const bool taken = ru_takes(blend, state, code);
    const uint32_t weight = ru_blend(blend, state, code, black);
    if (taken) ru_add_aovs(config, aovs, before, weight, of(depth), index);
  }
  uint32_t of(double depth) const { return static_cast<uint32_t>(std::lround(std::ldexp(depth, config.linear_w()))); }
  uint64_t word(Aov aov) const { return ru_aov_word(config, aov, state.t, aovs); }
  double depth(Aov aov) const { return std::ldexp(static_cast<double>(word(aov)), -32); }

  const Config config = with_aovs();
  const BlendConstants blend{config};
  PixelState state{.t = blend.one, .rgb = {}, .done = false};
  PixelAovs aovs = ru_fresh_aovs(config);
};

TEST(AovPixel, IsEmptyWithoutAGaussian) {
  const Pixel pixel;
  EXPECT_EQ(pixel.word(Aov::kCoverage), 0x8000u) << "T is 1, nothing is blended";
  EXPECT_EQ(pixel.word(Aov::kDepth), 0u);
  EXPECT_EQ(pixel.word(Aov::kMedian), 0u);
  EXPECT_EQ(pixel.word(Aov::kIndex), 0xffffffffu);
}

TEST(AovPixel, SumsWeightTimesDepth) {
  Pixel pixel;
  pixel.add(0.25, 0.5, 7);
  pixel.add(0.5, 0.75, 3);  // weighs 3/8
  EXPECT_EQ(pixel.word(Aov::kCoverage), 2u << 16 | 0x3000u) << "T is 3/8";
  EXPECT_DOUBLE_EQ(pixel.depth(Aov::kDepth), 0.25 * 0.5 + 0.375 * 0.75);
  EXPECT_DOUBLE_EQ(pixel.depth(Aov::kMedian), 0.75) << "with it T falls below one half";
  EXPECT_EQ(pixel.word(Aov::kIndex), 3u);
}

TEST(AovPixel, HasNoMedianWhileHalfOfTheLightIsLeft) {
  Pixel pixel;
  pixel.add(0.5, 0.25, 1);
  EXPECT_EQ(pixel.word(Aov::kMedian), 0u) << "T is one half, not below";
  pixel.add(1.0 / (1 << pixel.config.alpha_w), 0.5, 2);
  EXPECT_DOUBLE_EQ(pixel.depth(Aov::kMedian), 0.5);
  pixel.add(0.9, 0.75, 3);
  EXPECT_DOUBLE_EQ(pixel.depth(Aov::kMedian), 0.5) << "it falls below once";
}

TEST(AovPixel, OfEqualWeightsTheNearestIsKept) {
  Pixel pixel;
  pixel.add(0.25, 0.1, 9);
  pixel.add(1.0 / 3, 0.2, 4);
  ASSERT_NEAR(pixel.state.t, 0.5 * pixel.blend.one, 0.001 * pixel.blend.one);
  Pixel equal;
  equal.state.t = equal.blend.one;
  equal.add(0.5, 0.1, 9);
  equal.add(0.99, 0.2, 4);  // weighs less
  equal.state.t = equal.blend.one / 2;
  EXPECT_EQ(equal.word(Aov::kIndex), 9u);
  PixelAovs same = ru_fresh_aovs(equal.config);
  ru_add_aovs(equal.config, same, 1000, 100, 1, 5);
  ru_add_aovs(equal.config, same, 900, 100, 2, 6);
  EXPECT_EQ(same.index, 5u);
  ru_add_aovs(equal.config, same, 800, 101, 3, 7);
  EXPECT_EQ(same.index, 7u);
}

TEST(AovPixel, KnowsNothingOfWhatThePixelStopsBefore) {
  Pixel pixel;
  while (!pixel.state.done) pixel.add(0.9, 0.5, 1);
  const PixelAovs before = pixel.aovs;
  pixel.add(0.9, 0.9, 2);
  EXPECT_EQ(pixel.aovs, before);
  EXPECT_EQ(pixel.aovs.blended, 3u) << "T is 1e-3; the fourth would leave 1e-4 or less";
}

TEST(AovPixel, CountAndSumStayAtTheTop) {
  const Config config = with_aovs();
  PixelAovs pixel = ru_fresh_aovs(config);
  const auto most = static_cast<uint32_t>((1u << config.linear_w()) - 1);
  for (int i = 0; i < 70000; ++i) ru_add_aovs(config, pixel, 1u << (config.t_w - 1), 1u << (config.t_w - 1), most, 1);
  EXPECT_EQ(pixel.blended, 65535u);
  EXPECT_EQ(pixel.expected, most);
}

TEST(AovDepth, IsAFractionOfTheRange) {
  const Config config = with_aovs();
  const int mantissa_w = config.depth_w - config.exp_w();
  const auto key = [&](uint64_t exponent, uint64_t mantissa) { return exponent << mantissa_w | mantissa; };
  const uint64_t half = uint64_t{1} << (mantissa_w - 1), all = (uint64_t{1} << mantissa_w) - 1;
  const uint32_t one = 1u << config.linear_w();
  EXPECT_EQ(ru_linear(config, key(10, 0), 10), one / 2) << "2^10 of 2^11 world units";
  EXPECT_EQ(ru_linear(config, key(10, half), 10), one / 4 * 3);
  EXPECT_EQ(ru_linear(config, key(8, 0), 10), one / 8);
  EXPECT_EQ(ru_linear(config, key(11, 0), 10), one - 1) << "beyond the range";
  EXPECT_EQ(ru_linear(config, key(10, all), 10), one - 1 - ((one >> (mantissa_w + 1)) - 1));
  EXPECT_EQ(ru_linear(config, key(0, 0), 63), 0u) << "nearer than half a unit";
  EXPECT_EQ(ru_linear(config, key(10, 0), 10 + static_cast<uint64_t>(config.linear_w())), 1u) << "half a unit";
}

// --- frames ----------------------------------------------------------------------------------------------------------

TEST(AovFrame, SaysWhatThereIsToBeSeen) {
  const Scene scene = scene_of({gaussian_at({0, 0, 3}, 0.2f, 0.99), gaussian_at({0, 0, 9}, 3.0f, 0.99)});
  Simulation result;
  simulate_golden(scene, test_camera(64, 64), options_with_aovs(), result);
  const Image& image = result.golden.image;
  const size_t middle = image.at(32, 32), corner = image.at(0, 0);
  EXPECT_NEAR(image.median[middle], 3, 1e-3);
  EXPECT_NEAR(image.depth[middle] / (1 - image.transmittance[middle]), 3, 0.1) << "nearly all of it is the first one's";
  EXPECT_EQ(image.index[middle], 0u);
  EXPECT_EQ(image.blended[middle], 2u);
  EXPECT_EQ(image.index[corner], 1u) << "the first one does not reach it";
  EXPECT_EQ(image.blended[corner], 1u);
}

// What is asked for beside the colours changes none, and is the same whatever the units and windows.
TEST(AovFrame, ChangesNoPixelAndDependsOnNone) {
  const Scene scene = random_scene(80, 1500, 1);
  const Camera camera = test_camera(150, 90);
  SimulateOptions plain = options_with_aovs(), asked = plain, other = plain;
  plain.config.aov_coverage = plain.config.aov_depth = plain.config.aov_median = plain.config.aov_index = 0;
  other.config.units = 2;
  other.config.records = 64;
  Simulation a, b, c;
  simulate_golden(scene, camera, plain, a);
  simulate_golden(scene, camera, asked, b);
  simulate_golden(scene, camera, other, c);
  EXPECT_EQ(a.golden.pixels, b.golden.pixels);
  EXPECT_EQ(b.golden.aovs, c.golden.aovs);
  for (const auto& words : a.golden.aovs) EXPECT_TRUE(words.empty());
  for (const auto& words : b.golden.aovs) EXPECT_EQ(words.size(), b.golden.pixels.size());
}

// A Gaussian twice at the same place: that with the lower index is in front, and of equal weights the nearest counts.
TEST(AovFrame, EqualDepthsAreOrderedByIndex) {
  const Scene scene = scene_of({gaussian_at({0, 0, 3}, 0.5f, 0.7), gaussian_at({0, 0, 3}, 0.5f, 0.7)});
  Simulation result;
  simulate_golden(scene, test_camera(64, 64), options_with_aovs(), result);
  const Image& image = result.golden.image;
  for (size_t i = 0; i < image.index.size(); ++i) {
    if (image.blended[i] > 0) { ASSERT_EQ(image.index[i], 0u) << "pixel " << i; }
  }
}

// Every pixel's AOVs lie where the truth, in the same order, and the errors of the formats allow; mostly that is one
// Gaussian.
TEST(AovFrame, KeepsItsBounds) {
  for (const char* design_point : {"fast", "exact"}) {
    for (uint64_t seed = 81; seed < 85; ++seed) {
      Scene scene = random_scene(seed, 2500, 2);
      for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale += 0.3f * static_cast<float>(seed - 81);
      SimulateOptions options = options_with_aovs(design_point);
      options.config.depth_w = seed % 2 == 0 ? 30 : options.config.depth_w;
      const Camera camera = test_camera(120, 80);
      Simulation result;
      simulate_golden(scene, camera, options, result);
      const BudgetReport report = budget_frame(scene, camera, options, result);
      EXPECT_TRUE(report.holds()) << *report.first << "; " << design_point << ", seed " << seed;
      const size_t pixels = result.golden.pixels.size();
      EXPECT_GT(report.indices, pixels / 2) << "seed " << seed;
      EXPECT_GT(report.medians, pixels / 10) << "seed " << seed;
      EXPECT_LT(report.expected.error, 3e-3) << "of the range; alphas of 8 bits";
    }
  }
}

}  // namespace
}  // namespace pipegs
