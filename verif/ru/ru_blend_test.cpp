// SPDX-License-Identifier: Apache-2.0
// ru_blend_test: rtl/ru/ru_blend.sv against cpp_model/ru/ru_blend.hpp, and the model against double
// precision.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cpp_model/ru/ru_lanes.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vru_blend.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const BlendConstants kBlend(kConfig);

struct Case {
  PixelState pixel;
  uint32_t code;
  uint32_t color[3];
};

// Feeds one case per cycle (or with holes) and compares each result.
void compare(const std::vector<Case>& cases, bool holes, const BlendConstants& k = kBlend) {
  Bench<Vru_blend> bench;
  auto& dut = bench.dut;
  dut.rest_i = k.rest;
  const size_t n = cases.size();
  size_t stage[3] = {n, n, n};  // the case in each stage, n: none
  for (size_t next = 0, checked = 0; checked < n;) {
    stage[2] = stage[1];
    stage[1] = stage[0];
    stage[0] = next < n && (!holes || bench.rng() % 2) ? next++ : n;
    dut.enable_1_i = stage[0] < n;
    if (stage[0] < n) {
      dut.code_i = cases[stage[0]].code;
      dut.t_i = cases[stage[0]].pixel.t;
      dut.done_i = cases[stage[0]].pixel.done;
    }
    dut.enable_2_i = stage[1] < n;
    if (stage[1] < n) {
      dut.red_i = cases[stage[1]].color[0];
      dut.green_i = cases[stage[1]].color[1];
      dut.blue_i = cases[stage[1]].color[2];
    }
    if (stage[2] < n) {
      const Case& c = cases[stage[2]];
      uint64_t rgb = 0;
      for (int i = 2; i >= 0; --i) rgb = (rgb << kConfig.rgb_w) | c.pixel.rgb[i];
      dut.rgb_i = rgb;
      dut.eval();
      PixelState expected = c.pixel;
      ru_blend(k, expected, c.code, c.color);
      uint64_t expected_rgb = 0;
      for (int i = 2; i >= 0; --i) expected_rgb = (expected_rgb << kConfig.rgb_w) | expected.rgb[i];
      ASSERT_EQ(dut.t_o, expected.t) << "case " << stage[2] << " T " << c.pixel.t << " code " << c.code << " seed "
                                     << bench.seed;
      ASSERT_EQ(dut.done_o, expected.done) << "case " << stage[2] << " T " << c.pixel.t << " code " << c.code;
      ASSERT_EQ(dut.rgb_o, expected_rgb) << "case " << stage[2] << " T " << c.pixel.t << " code " << c.code;
      ++checked;
    }
    bench.step();
  }
}

Case random_case(std::mt19937_64& rng, const BlendConstants& k = kBlend) {
  const auto below = [&](uint64_t n) { return static_cast<uint32_t>(rng() % n); };
  Case c{};
  const uint32_t limit = std::max(k.stop, k.rest);
  c.pixel.t = rng() % 4 == 0   ? std::min(limit - std::min(limit, 4u) + below(8), k.one)
              : rng() % 8 == 0 ? kBlend.one
                               : below(kBlend.one + 1);
  c.pixel.done = rng() % 8 == 0;
  c.code = rng() % 4 == 0 ? below(3) : below(1u << kConfig.alpha_w);
  for (int i = 0; i < 3; ++i) {
    c.pixel.rgb[i] = rng() % 4 == 0 ? kBlend.rgb_max - below(4) : below(kBlend.rgb_max + 1);
    c.color[i] = rng() % 4 == 0 ? (1u << kConfig.color_w) - 1 - below(2) : below(1u << kConfig.color_w);
  }
  return c;
}

TEST(RuBlend, EqualsItsModel) {
  std::mt19937_64 rng(test_seed());
  std::vector<Case> cases(50000);
  for (Case& c : cases) c = random_case(rng);
  compare(cases, false);
  compare(cases, true);
}

// A frame's own limit: the least, INRIA's, a twentieth, nearly all.
TEST(RuBlend, EqualsItsModelAtEveryRest) {
  if (kBlend.stop == 0) GTEST_SKIP() << "no pixel stops";
  std::mt19937_64 rng(test_seed());
  for (const uint32_t rest : {2u, kBlend.stop, kBlend.one / 100, kBlend.one / 20, kBlend.one - 1}) {
    const BlendConstants k(kConfig, rest);
    std::vector<Case> cases(20000);
    for (Case& c : cases) c = random_case(rng, k);
    compare(cases, false, k);
    compare(cases, true, k);
  }
}

// T and the weights are one in all, and what is left has the last one's colour.
TEST(RuBlend, TheLastGaussianTakesAllThatIsLeft) {
  if (kBlend.stop == 0) GTEST_SKIP() << "no pixel stops";
  const BlendConstants k(kConfig, kBlend.one / 20);
  std::mt19937_64 rng(test_seed());
  const uint32_t white[3] = {1u << (kConfig.color_w - 2), 1u << (kConfig.color_w - 2), 1u << (kConfig.color_w - 2)};
  for (int run = 0; run < 1000; ++run) {
    PixelState pixel{.t = k.one};
    uint32_t weights = 0;
    while (!pixel.done)
      weights += ru_blend(k, pixel, 1 + static_cast<uint32_t>(rng() % ((1u << k.alpha_w) - 1)), white);
    EXPECT_EQ(pixel.t, 0u);
    EXPECT_EQ(weights, k.one);
    EXPECT_NEAR(std::ldexp(pixel.rgb[0], 2 - kConfig.rgb_w), 1, 0.01) << "of one colour, so of that one in all";
    EXPECT_EQ(ru_blend(k, pixel, 1u << (k.alpha_w - 1), white), 0u) << "it takes no more";
  }
}

TEST(RuBlend, StopsExactlyAtTheLimit) {
  std::vector<Case> cases;
  for (uint32_t t = kBlend.stop; t < kBlend.stop + 300; ++t) {
    for (uint32_t code = 0; code < (1u << kConfig.alpha_w); code += 5)
      cases.push_back({{t, {0, 0, 0}, false}, code, {1, 2, 3}});
  }
  compare(cases, false);
}

TEST(RuBlend, FullScaleSaturates) {
  const uint32_t code = (1u << kConfig.alpha_w) - 1, white = (1u << kConfig.color_w) - 1;
  compare({{{kBlend.one, {0, 0, 0}, false}, code, {white, white, white}},
           {{kBlend.one, {kBlend.rgb_max, 1, 0}, false}, code, {white, white, white}}},
          false);
  PixelState pixel{kBlend.one, {kBlend.rgb_max, 0, 0}, false};
  const uint32_t color[3] = {white, 0, 0};
  BlendCounts counts;
  ru_blend(kBlend, pixel, code, color, &counts);
  EXPECT_EQ(counts.saturated, 1u);
  if (kConfig.saturation) EXPECT_EQ(pixel.rgb[0], kBlend.rgb_max);
  else EXPECT_LT(pixel.rgb[0], kBlend.rgb_max) << "it wraps";
}

TEST(RuBlend, TransmittancePlusWeightsIsOne) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 2000; ++i) {
    PixelState pixel{kBlend.one, {0, 0, 0}, false};
    uint64_t sum = 0;
    const uint32_t color[3] = {1, 1, 1};
    for (int j = 0; j < 200; ++j) sum += ru_blend(kBlend, pixel, rng() % (1u << kConfig.alpha_w) >> rng() % 6, color);
    ASSERT_EQ(sum + pixel.t, kBlend.one);
    ASSERT_GE(pixel.t, kBlend.stop);
  }
}

// The error that blending adds to given alpha codes and colours.
TEST(RuBlend, StaysCloseToDouble) {
  std::mt19937_64 rng(test_seed());
  double worst_t = 0, worst_color = 0, squares = 0;
  constexpr int kPixels = 20000;
  for (int i = 0; i < kPixels; ++i) {
    PixelState pixel{kBlend.one, {0, 0, 0}, false};
    double t = 1, red = 0;
    const int shift = 1 + static_cast<int>(rng() % 6);
    for (int j = 0; j < 300 && !pixel.done; ++j) {
      const uint32_t code = rng() % (1u << kConfig.alpha_w) >> shift;
      const uint32_t color[3] = {static_cast<uint32_t>(rng() % (1u << (kConfig.color_w - 2))), 0, 0};  // below 1
      ru_blend(kBlend, pixel, code, color);
      if (pixel.done) break;
      const double weight = t * std::ldexp(code, -kConfig.alpha_w);
      red += weight * std::ldexp(color[0], 2 - kConfig.color_w);
      t -= weight;
    }
    worst_t = std::max(worst_t, std::abs(std::ldexp(pixel.t, 1 - kConfig.t_w) - t));
    const double error = std::ldexp(pixel.rgb[0], 2 - kConfig.rgb_w) - red;
    worst_color = std::max(worst_color, std::abs(error));
    squares += error * error;
  }
  std::printf("error of blending: T at most %.2g, colour at most %.2g, rms %.2g\n", worst_t, worst_color,
              std::sqrt(squares / kPixels));
  EXPECT_LT(worst_t, std::ldexp(16, 1 - kConfig.t_w));
  EXPECT_LT(worst_color, std::ldexp(40, 2 - kConfig.rgb_w) + std::ldexp(40, 1 - kConfig.t_w));
}

TEST(RuBlend, TheRegionLoopEqualsThePixel) {
  for (Config config : {kConfig, [] {
                          Config c;
                          c.t_w = 24;
                          c.color_w = 16;
                          c.alpha_w = 12;
                          return c;
                        }()}) {
    const BlendConstants constants(config);
    std::mt19937_64 rng(test_seed());
    RegionState state{};
    PixelState pixels[kRegionPixels];
    for (int i = 0; i < kRegionPixels; ++i) {
      state.t[i] = pixels[i].t = constants.one;
      state.done[i] = pixels[i].done = rng() % 10 == 0;
    }
    for (int j = 0; j < 400; ++j) {
      uint16_t codes[kRegionPixels];
      uint32_t color[3];
      for (uint16_t& code : codes) code = rng() % (1u << config.alpha_w) >> rng() % 8;
      for (uint32_t& channel : color) channel = rng() % (1u << config.color_w);
      BlendCounts expected, found;
      bool all = true;
      for (int i = 0; i < kRegionPixels; ++i) {
        ru_blend(constants, pixels[i], codes[i], color, &expected);
        all = all && pixels[i].done;
      }
      ASSERT_EQ(ru_blend_region(constants, state, codes, color, &found), all);
      ASSERT_EQ(found.blended, expected.blended);
      ASSERT_EQ(found.stopped, expected.stopped);
      ASSERT_EQ(found.saturated, expected.saturated);
      for (int i = 0; i < kRegionPixels; ++i) ASSERT_EQ(state.pixel(i), pixels[i]) << "pixel " << i << " step " << j;
    }
  }
}

}  // namespace
}  // namespace pipegs
