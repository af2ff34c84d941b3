// SPDX-License-Identifier: Apache-2.0
// box_models_test: the bit-accurate models of pu_axes and pu_box against double precision, in the default widths, in
// coarse and in fine ones. Their RTL is compared in pu_shape_test.
#include "verif/pu/box/float_box.hpp"
#include "verif/pu/random_splat.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

class BoxModels : public testing::TestWithParam<const char*> {
 protected:
  const Config config = config_with(GetParam());
  std::mt19937_64 rng{test_seed()};
};
INSTANTIATE_TEST_SUITE_P(, BoxModels,
                         testing::Values("tile_test=2", "tile_test=2 mantissa_w=18 antialias=1",
                                         "tile_test=2 mantissa_w=28"));

// Also round covariances, and those that are nearly so.
Covariance any_covariance(const Config& config, std::mt19937_64& rng) {
  Covariance r = random_covariance(config, rng);
  if (rng() % 8 == 0) {
    r.c_m = r.a_m, r.c_e = r.a_e, r.b_e = r.a_e + config.mantissa_w - (config.slope_w() - 1);
    r.b_m = static_cast<int64_t>(rng() % 3) - 1;
    if (rng() % 2 == 0) r.c_m ^= rng() % 4;
    if (rng() % 2 == 0) r.b_m *= int64_t{1} << (rng() % 18);
  }
  return r;
}

TEST_P(BoxModels, AxesAgreeWithDouble) {
  double tilt = 0, stretch = 0, shrink = 0, larger = 0, larger_round = 0, inverse = 0;
  int rounds = 0;
  for (int i = 0; i < 200000; ++i) {
    Covariance r = any_covariance(config, rng);
    r.kind = kData;
    const Axes k = pu_axes(config, Frame{}, r);
    const FloatBox exact = float_box(r);
    const double long_m = static_cast<double>(k.long_m);
    double& error = exact.round ? larger_round : larger;
    error = std::max(error, std::abs(std::ldexp(long_m, static_cast<int>(k.long_e)) / exact.larger - 1));
    inverse = std::max(inverse, std::abs(std::ldexp(static_cast<double>(k.inverse_m), -2 * kAxisM + 1) * long_m - 1));
    if (exact.round) {
      ASSERT_EQ(k.tilt, 0) << to_text(config, r);
      ASSERT_EQ(k.stretch, uint64_t{1} << (kShareF - 1));
      ASSERT_EQ(k.shrink, uint64_t{1} << kShareF);
      ++rounds;
      continue;
    }
    ASSERT_EQ(k.swap != 0, exact.swap);
    tilt = std::max(tilt, std::abs(std::ldexp(static_cast<double>(k.tilt), -kTiltF) - exact.tilt));
    stretch = std::max(stretch, std::abs(std::ldexp(static_cast<double>(k.stretch), -kShareF) / exact.stretch - 1));
    shrink = std::max(shrink, std::abs(std::ldexp(static_cast<double>(k.shrink), -kShareF) * 2 * exact.stretch - 1));
  }
  std::printf("pu_axes, %s: error of tilt %.3g; relative, of stretch %.3g, of shrink %.3g, of the eigenvalue %.3g\n",
              GetParam(), tilt, stretch, shrink, larger);
  EXPECT_GT(rounds, 1000);
  EXPECT_LE(tilt, std::exp2(-15.5));
  EXPECT_LE(stretch, std::exp2(-16.4));
  EXPECT_LE(shrink, std::exp2(-14.9));
  EXPECT_LE(larger, std::exp2(-16.5));
  // d and 2b below 2^10 units of the larger variance are taken as zero: half of their hypotenuse is left out at most.
  EXPECT_LE(larger_round, std::exp2(10.5 - config.mantissa_w));
  EXPECT_LE(inverse, std::exp2(-22));
}

// Never too small, and by how much too large: 2^-12 of the longest, and units.
TEST_P(BoxModels, ABoxHoldsThatOfDouble) {
  double side = 0, extent = 0;
  for (int i = 0; i < 200000; ++i) {
    const Covariance in = random_splat(config, rng, i % 2 == 0 ? 10 : 5000).record;
    const Covariance out = pu_box(config, Frame{}, pu_axes(config, Frame{}, in));
    const FloatBox exact = float_box(in);
    if (exact.round) continue;
    const auto pixels = [](uint64_t x, int fraction) { return std::ldexp(static_cast<double>(x), -fraction); };
    const double u = exact.swap ? exact.side_long : exact.side_short,
                 v = exact.swap ? exact.side_short : exact.side_long;
    const double x = exact.swap ? exact.along : exact.across, y = exact.swap ? exact.across : exact.along;
    for (const auto& [found, wanted] : {std::pair{pixels(out.side_u, kSideF), u}, {pixels(out.side_v, kSideF), v}}) {
      ASSERT_GE(found, wanted) << to_text(config, in);
      side = std::max(side, (found - wanted - 3.0 / 256) / exact.side_long);
    }
    for (const auto& [found, wanted] : {std::pair{pixels(out.box_x, 4), x}, {pixels(out.box_y, 4), y}}) {
      ASSERT_GE(found, wanted) << to_text(config, in);
      extent = std::max(extent, (found - wanted - 1.5 / 16) / exact.side_long);
    }
  }
  std::printf("pu_box, %s: sides too large by 3/256 px and %.3g, extents by 3/32 px and %.3g of the longest side\n",
              GetParam(), side, extent);
  EXPECT_LE(side, std::exp2(-12));
  EXPECT_LE(extent, std::exp2(-11.5));
}

}  // namespace
}  // namespace pipegs
