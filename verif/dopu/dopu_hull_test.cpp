// SPDX-License-Identifier: Apache-2.0
// dopu_hull_test: rtl/dopu/dopu_hull.sv against its bit-accurate model; the model against what it bounds, in double.
#include "Vdopu_hull.h"
#include "cpp_model/dopu/dopu_hull.hpp"
#include "cpp_model/pack/pack.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

// A scale, and a step of depth: anywhere, or about as far away as the scale reaches.
struct Draw {
  uint64_t scale = 0;
  int step = 0;
  template <class Rng>
  Draw(const Config& config, Rng& rng) : scale(rng() & ((uint64_t{1} << config.scale_w()) - 1)) {
    if (rng() % 16 == 0) scale &= (uint64_t{1} << config.scale_m_w) - 1;  // zero
    const auto most = (1 << config.step_w()) - 1, octave = 1 << config.bucket_bits;
    const int reach = (static_cast<int>(scale >> config.scale_m_w) - 8) * octave;
    step = std::clamp(rng() % 2 == 0 ? static_cast<int>(rng() % (1u << config.step_w()))
                                     : reach + static_cast<int>(rng() % static_cast<uint64_t>(4 * octave)),
                      0, most);
  }
};

TEST(DopuHull, EqualsItsModel) {
  const Config config = test_config();
  Bench<Vdopu_hull> bench;
  for (int i = 0; i < 200000; ++i) {
    const Draw draw(config, bench.rng);
    Node node = random_record<Node>(config, bench.rng);
    node.scale_max = draw.scale;
    Words words(static_cast<size_t>(record_words<Node>(config)) + 1);
    pack(config, node, words.data());
    write_port(bench.dut.node_i, words.data());
    const int bucket = std::min(draw.step, static_cast<int>(bench.rng() & ((uint64_t{1} << config.bucket_w()) - 1)));
    bench.dut.near_step_i = static_cast<SData>(draw.step - bucket);
    bench.dut.parent_i = static_cast<SData>(bucket);
    bench.dut.eval();
    const Hull expected = dopu_hull(config, draw.scale, draw.step);
    ASSERT_EQ(bench.dut.tight_o, expected.tight) << draw.scale << ", step " << draw.step << ", seed " << bench.seed;
    ASSERT_EQ(bench.dut.scale_o, expected.scale) << draw.scale << ", step " << draw.step << ", seed " << bench.seed;
  }
}

TEST(DopuHullModel, BoundsTheShareThatIsLeftOfTheReach) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  double most = 0, mean = 0;
  int tight = 0;
  for (int i = 0; i < 200000; ++i) {
    const Draw draw(config, rng);
    const Hull hull = dopu_hull(config, draw.scale, draw.step);
    const double scale = scale_value(config, draw.scale), edge = std::ldexp(1.0, -config.bucket_bits);
    const int octave = draw.step >> config.bucket_bits;
    const double depth = std::ldexp(1 + edge * (draw.step & ((1 << config.bucket_bits) - 1)), octave);
    const double ratio = std::sqrt(2 * std::log(config.alpha_cut)) * scale / depth;
    if (!hull.tight) {
      ASSERT_EQ(hull.scale, draw.scale);
      ASSERT_GT(ratio, 0.7) << "far enough for the box of the ellipsoids";
      continue;
    }
    ASSERT_LT(ratio, 1.0);
    ASSERT_GE(scale_value(config, hull.scale), scale * ratio);
    ASSERT_LE(hull.scale, draw.scale | ((uint64_t{1} << (config.scale_m_w - 6)) - 1));
    if (hull.scale >> config.scale_m_w < 2) continue;  // the smallest one
    const double given = scale_value(config, hull.scale) / (scale * ratio);
    most = std::max(most, given);
    mean += given;
    ++tight;
  }
  EXPECT_GT(tight, 10000);
  EXPECT_LT(most, 1.35);
  fmt::print("dopu_hull: {} tight ones, given away {:.1f} % in the mean, {:.1f} % at most\n", tight,
             100 * (mean / tight - 1), 100 * (most - 1));
}

}  // namespace
}  // namespace pipegs
