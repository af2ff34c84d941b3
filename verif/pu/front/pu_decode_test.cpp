// SPDX-License-Identifier: Apache-2.0
// pu_decode_test: rtl/pu/front/pu_decode.sv against its bit-accurate model, and the model, with the packer's codes,
// against double precision.
#include "cpp_model/pu/front/pu_decode.hpp"

#include "Vpu_decode.h"
#include "cpp_model/float/projection.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

// What pu_cull gets of a code.
Fetched decoded(const Config& config, const Coded& in) {
  Chunk chunk{.kind = in.kind,
              .window_x = in.window_x,
              .window_y = in.window_y,
              .walk = in.walk,
              .origin_x = in.origin_x,
              .origin_y = in.origin_y,
              .origin_z = in.origin_z,
              .view_exp = in.view_exp,
              .offset_exp = in.offset_exp};
  if (in.kind == kData) return golden_fetched(chunk, pu_decode(config, in.code, in.scale_exp, in.slot), in.slot);
  Fetched end = golden_fetched(chunk, {}, 0);
  end.kind = in.kind;
  return end;
}

// Any bits of a code, and often the extremes of a field.
Coded random_coded(const Config& config, std::mt19937_64& rng) {
  Coded coded = random_record<Coded>(config, rng);
  if (rng() % 6 == 0) {
    coded.kind = 1 + rng() % 3;
    coded.code = {};
    coded.slot = 0;
    return coded;
  }
  coded.kind = kData;
  for (uint64_t* scale : {&coded.code.scale_0, &coded.code.scale_1, &coded.code.scale_2}) {
    if (rng() % 8 == 0) *scale = kNoScale - rng() % 2;
  }
  if (rng() % 8 == 0) coded.scale_exp = rng() % 4;
  if (rng() % 8 == 0) coded.code.opacity = rng() % 2 * kMostOpacity;
  if (rng() % 8 == 0) coded.code.turn_0 = coded.code.turn_1 = coded.code.turn_2 = 0;
  return coded;
}

TEST(PuDecode, EqualsItsModelAtEveryPace) {
  const Config config = test_config();
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      if (sink_pace == Pace::kLazy) continue;  // its taker waits for no valid
      Bench<Vpu_decode> bench;
      Vpu_decode& dut = bench.dut;
      RecordSource<Coded, decltype(dut.coded_i)> in(bench, config, dut.coded_valid_i, dut.coded_ready_o, dut.coded_i,
                                                    source_pace);
      RecordSink<Fetched, decltype(dut.fetched_o)> out(bench, config, dut.fetched_valid_o, dut.fetched_ready_i,
                                                       dut.fetched_o, sink_pace);
      bench.reset();
      std::vector<Fetched> expected;
      for (int i = 0; i < 2000; ++i) {
        const Coded coded = random_coded(config, bench.rng);
        expected.push_back(decoded(config, coded));
        in.push(coded);
      }
      ASSERT_TRUE(bench.run_until([&] { return out.size() == expected.size(); }));
      for (size_t i = 0; i < expected.size(); ++i)
        ASSERT_EQ(first_difference(config, expected[i], out.at(i)), "") << "beat " << i << ", seed " << bench.seed;
      for (int i = 0; i < 20; ++i) bench.step();
      EXPECT_EQ(out.size(), expected.size()) << "a beat too many";
      EXPECT_EQ(dut.busy_o, 0);
    }
  }
}

TEST(PuDecode, TakesACodeInEveryCycleAndStandsStillWithItsTaker) {
  const Config config = test_config();
  Bench<Vpu_decode> bench;
  Vpu_decode& dut = bench.dut;
  RecordSource<Coded, decltype(dut.coded_i)> in(bench, config, dut.coded_valid_i, dut.coded_ready_o, dut.coded_i,
                                                Pace::kAlways);
  RecordSink<Fetched, decltype(dut.fetched_o)> out(bench, config, dut.fetched_valid_o, dut.fetched_ready_i,
                                                   dut.fetched_o, Pace::kAlways);
  bool stands = true;
  const Beside beside(
      bench, [&] { EXPECT_EQ(dut.coded_ready_o, dut.fetched_ready_i); },
      [&] {
        if (stands) dut.fetched_ready_i = 0;
      });
  bench.reset();
  for (int i = 0; i < 100; ++i) in.push(random_coded(config, bench.rng));
  for (int i = 0; i < 20; ++i) bench.step();
  EXPECT_EQ(dut.busy_o, 0) << "nothing is taken into an empty pipeline whose taker stands";
  stands = false;
  ASSERT_TRUE(bench.run_until([&] { return out.size() == 100; }));
  EXPECT_EQ(out.cycles.back() - out.cycles.front(), 99u);
}

// A Gaussian of any kind: its code, decoded, is what it was within the stated bounds.
TEST(PuDecode, WhatThePackerCodesComesBackWithinItsBounds) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  Scene scene;
  scene.gaussians.resize(1);
  double worst_turn = 0, worst_scale = 0, worst_opacity = 0, worst_base = 0;
  for (int run = 0; run < 20000; ++run) {
    ActivatedGaussian gaussian;
    glm::dvec4 q(draw_normal(rng), draw_normal(rng), draw_normal(rng), draw_normal(rng));
    if (run % 5 == 0) {  // all components alike: what rounding adds to three makes the largest less than one half
      for (int i = 0; i < 4; ++i) q[i] = (rng() % 2 == 0 ? 0.5 : -0.5) + 0.003 * q[i];
    }
    if (run % 7 == 0) q = glm::dvec4(run % 4 == 0, run % 4 == 1, run % 4 == 2, run % 4 == 3);
    gaussian.rotation = q / std::sqrt(glm::dot(q, q));
    const double size = std::exp2(draw_uniform(rng, 8, 40));
    gaussian.scale = size * glm::dvec3(1, std::exp2(-draw_uniform(rng, 0, 12)), std::exp2(-draw_uniform(rng, 0, 12)));
    gaussian.opacity = draw_uniform(rng, 1.0 / config.alpha_cut, 1);
    for (int i = 0; i < 3; ++i) scene.gaussians[0].sh_dc[i] = static_cast<float>(draw_uniform(rng, -1.7, 1.7));
    PackCounts counts;
    const uint64_t scale_exp = chunk_scale_exp(config, {&gaussian, 1}, 0);
    const GaussianRecord found =
        pu_decode(config, encode(config, scene, gaussian, 0, 0, scale_exp, counts), scale_exp, 17);
    ASSERT_EQ(counts.saturated_scale + counts.flushed_scale + counts.saturated_base, 0u) << "run " << run;
    EXPECT_EQ(found.index, 17u);
    const double one = std::ldexp(1, config.quat_w - 1);
    const glm::dvec4 turned(found.qw / one, found.qx / one, found.qy / one, found.qz / one);
    const double same = glm::dot(turned, gaussian.rotation) < 0 ? -1 : 1;
    const glm::dvec4 off = turned - same * gaussian.rotation;
    worst_turn = std::max(worst_turn, std::sqrt(glm::dot(off, off)));
    EXPECT_NEAR(glm::dot(turned, turned), 1, std::ldexp(8, -config.quat_w)) << "run " << run;
    for (int i = 0; i < 3; ++i) {
      const uint64_t field = i == 0 ? found.scale_0 : i == 1 ? found.scale_1 : found.scale_2;
      worst_scale = std::max(worst_scale, std::abs(std::log2(scale_value(config, field) / gaussian.scale[i])));
    }
    const double opacity = std::exp2(-std::ldexp(static_cast<double>(found.opacity), -config.opacity_f));
    worst_opacity = std::max(worst_opacity, std::abs(opacity - gaussian.opacity));
    const double base = std::ldexp(static_cast<double>(found.base_g), 3 - config.base_w);
    worst_base = std::max(worst_base, std::abs(base - 0.5 - kSh0 * static_cast<double>(scene.gaussians[0].sh_dc.y)));
  }
  std::printf("pu_decode: quaternion %.4f, scale %.4f octaves, opacity %.4f, base %.4f\n", worst_turn, worst_scale,
              worst_opacity, worst_base);
  // Half a unit each of three components, of which the fourth may lose as much as the three together.
  EXPECT_LT(worst_turn, std::sqrt(12.0) * std::ldexp(1, -9) / std::sqrt(2.0) + std::ldexp(1, 2 - config.quat_w));
  EXPECT_LT(worst_scale, 1.0 / 32 + std::ldexp(1.5, -config.scale_m_w));
  EXPECT_LT(worst_opacity, 0.5 / kMostOpacity + std::ldexp(1, -config.opacity_f));
  EXPECT_LT(worst_base, 1.0 / 256 + 1e-9);
}

TEST(PuDecode, WhatIsLargerThanTheChunkSaysIsCutAndCounted) {
  const Config config = test_config();
  Scene scene;
  scene.gaussians.resize(1);
  ActivatedGaussian gaussian{.mean = {}, .scale = {1 << 20, 1 << 20, 1}, .rotation = {1, 0, 0, 0}, .opacity = 1};
  const uint64_t scale_exp = chunk_scale_exp(config, {&gaussian, 1}, 0);
  gaussian.scale = {std::ldexp(1, 25), 0, std::ldexp(1, -30)};
  PackCounts counts;
  const GaussianRecord found =
      pu_decode(config, encode(config, scene, gaussian, 0, 0, scale_exp, counts), scale_exp, 0);
  EXPECT_EQ(counts.saturated_scale, 2u) << "one cut, one raised to the smallest there is";
  EXPECT_EQ(scale_value(config, found.scale_0), std::ldexp(1, 23));
  EXPECT_EQ(found.scale_1, 0u) << "none stays none";
  EXPECT_GT(found.scale_2, 0u);
}

}  // namespace
}  // namespace pipegs
