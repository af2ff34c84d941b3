// SPDX-License-Identifier: Apache-2.0
// pu_intersect_test: rtl/pu/conic/pu_intersect.sv against its bit-accurate model, and the model against all
// pixels as the Row Units compute them.
#include "cpp_model/pu/conic/pu_intersect.hpp"

#include <bit>
#include <deque>

#include "cpp_model/pu/rows/pu_region.hpp"
#include "cpp_model/pu/rows/pu_row_init.hpp"
#include "verif/pu/box/float_box.hpp"
#include "verif/pu/random_splat.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_intersect.h"

namespace pipegs {
namespace {

// Numbers the Gaussians that come in, follows them as pu_payload does, and notes who is shown when a beat is taken.
class Numbers : public Endpoint {
 public:
  explicit Numbers(Bench<Vpu_intersect>& bench) : bench_(bench) { bench.add(*this); }
  void drive() override {}
  void observe() override {
    const auto& dut = bench_.dut;
    if (dut.tiles_valid_o && dut.tiles_ready_i) taken.push_back(shown_);
    if (dut.leave_o) {
      ASSERT_FALSE(walking_.empty()) << "cycle " << bench_.cycle;
      shown_ = walking_.front();
      walking_.pop_front();
    }
    if (dut.walk_o) walking_.push_back(came);
    EXPECT_LE(walking_.size(), 2u) << "cycle " << bench_.cycle;
    came += dut.drop_o + dut.walk_o;
  }
  uint64_t came = 0;
  std::vector<uint64_t> taken;

 private:
  Bench<Vpu_intersect>& bench_;
  std::deque<uint64_t> walking_;
  uint64_t shown_ = 0;
};

struct Stage {
  Config config = test_config();
  Bench<Vpu_intersect> bench;
  Numbers numbers{bench};
  RecordSource<Coeff, decltype(bench.dut.coeff_i)> in{bench, config, bench.dut.coeff_valid_i, bench.dut.coeff_ready_o,
                                                      bench.dut.coeff_i};
  RecordSink<Tiles, decltype(bench.dut.tiles_o)> out{bench, config, bench.dut.tiles_valid_o, bench.dut.tiles_ready_i,
                                                     bench.dut.tiles_o};
  void compare(const std::vector<Coeff>& records) {
    std::vector<Tiles> expected;
    std::vector<uint64_t> numbers_of;
    uint64_t came = 0;
    for (const Coeff& record : records) {
      const Tiles tiles = pu_intersect(config, Frame{}, record);
      if (tiles.kind != kData || tiles.mask != 0) {
        expected.push_back(tiles);
        numbers_of.push_back(came);
      }
      came += record.kind == kData;
    }
    for (const Coeff& record : records) in.push(record);
    bench.reset();
    bench.run_until([&] { return out.size() >= expected.size() && in.empty(); }, 2000000);
    for (int i = 0; i < 100; ++i) bench.step();
    ASSERT_EQ(out.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(first_difference(config, expected[i], out.at(i)), "")
          << "beat " << i << " in cycle " << out.cycles[i] << ", seed " << bench.seed << "\nexpected "
          << to_text(config, expected[i]);
    }
    EXPECT_EQ(numbers.came, came);
    ASSERT_EQ(numbers.taken.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
      if (expected[i].kind == kData) { ASSERT_EQ(numbers.taken[i], numbers_of[i]) << "beat " << i; }
    }
  }
  Coeff coeff() { return coeff_of(config, random_covariance(config, bench.rng)); }
};

TEST(PuIntersect, EqualsItsModelAtEveryPairOfPaces) {
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      SCOPED_TRACE(std::string(to_text(source)) + " to " + to_text(sink));
      Stage s;
      s.in.pace = source, s.out.pace = sink;
      std::vector<Coeff> records;
      for (int i = 0; i < 2000; ++i) records.push_back(s.coeff());
      s.compare(records);
      if (HasFatalFailure()) return;
    }
  }
}

// Coefficients that no Gaussian has: the module must still equal its bit-accurate model.
TEST(PuIntersect, EqualsItsModelForAnyConcaveCoefficients) {
  Stage s;
  auto& rng = s.bench.rng;
  std::vector<Coeff> records;
  for (int i = 0; i < 10000; ++i) {
    Coeff q = random_record<Coeff>(s.config, rng);
    q.kind = kData, q.dead = 0;
    const int small = static_cast<int>(rng() % static_cast<uint64_t>(s.config.def_w()));
    q.d = -(std::abs(q.d) >> small), q.e = -(std::abs(q.e) >> small), q.f >>= small;
    q.b >>= rng() % s.config.bc_w(), q.c >>= rng() % s.config.bc_w(), q.a >>= rng() % s.config.a_w();
    q.mean_x >>= 10 + rng() % 6, q.mean_y >>= 10 + rng() % 6;
    records.push_back(q);
  }
  s.compare(records);
}

TEST(PuIntersect, TakesOneCyclePerStepOfTheBoxAndAtLeastThree) {
  Stage s;
  std::vector<Coeff> records;
  Covariance round;  // as large as reaches one region from its middle, four from the corner of four
  const double variance = s.config.oriented() ? 0.5 : 4;
  to_float(variance, s.config.mantissa_w, round.a_m, round.a_e);
  to_float(variance, s.config.mantissa_w, round.c_m, round.c_e);
  to_float(variance * variance, s.config.mantissa_w, round.det_m, round.det_e);
  round.opacity = static_cast<uint64_t>(std::ldexp(std::log2(s.config.alpha_cut) - 2, s.config.opacity_f));
  for (int i = 0; i < 100; ++i) {
    round.mean_x = round.mean_y = int64_t{i < 50 ? 4 : 8} << s.config.mean_f;
    records.push_back(coeff_of(s.config, round));
  }
  for (int i = 0; i < 50; ++i) records.push_back({.kind = kLayerEnd});
  s.compare(records);
  EXPECT_EQ(s.out.cycles.at(40) - s.out.cycles.at(10), 30u * 3);
  EXPECT_EQ(s.out.cycles.at(90) - s.out.cycles.at(60), 30u * std::max(3, 4 / s.config.tests));
  EXPECT_EQ(s.out.cycles.at(140) - s.out.cycles.at(110), 30u);
}

// Brute force: every pixel of the window as pu_region and pu_row_init give it to the Row Units.
TEST(PuIntersect, LosesNoPixelAndKeepsFewRegionsWithoutOne) {
  const Config config = test_config();
  if (config.oriented()) GTEST_SKIP() << "the oriented box loses pixels";
  std::mt19937_64 rng(test_seed());
  for (double longest : {1.0, 3.0, 10.0, 100.0, 1000.0, 5000.0}) {
    int64_t needed = 0, kept = 0, boxes = 0;
    for (int i = 0; i < 4000; ++i) {
      const RandomSplat s = random_splat(config, rng, longest);
      const Coeff q = pu_coeff(config, Frame{}, pu_conic(config, Frame{}, s.record));
      const Tiles tiles = pu_intersect(config, Frame{}, q);
      uint64_t need = 0, box = 0;
      const double reach_x = std::ldexp(static_cast<double>(q.extent_x), -4),
                   reach_y = std::ldexp(static_cast<double>(q.extent_y), -4);
      for (int r = 0; r < config.regions() && !q.dead; ++r) {
        const Region region =
            pu_region(config, {.a = q.a, .b = q.b, .c = q.c, .d = q.d, .e = q.e, .f = q.f, .mask = ~uint64_t{0}}, r);
        for (int y = 0; y < 8; ++y) {
          Row row = pu_row_init(region, y);
          for (int x = 0; x < 8; ++x) {
            if (row.power >= -config.power_cut()) need |= uint64_t{1} << r;
            row.power += row.slope, row.slope += 2 * region.curve_x;
            if (std::abs(r % config.part_regions_x() * 8 + x - s.mean_x) <= reach_x &&
                std::abs(r / config.part_regions_x() * 8 + y - s.mean_y) <= reach_y)
              box |= uint64_t{1} << r;
          }
        }
      }
      ASSERT_EQ(need & ~tiles.mask, 0u) << to_text(config, q);
      needed += std::popcount(need), kept += std::popcount(tiles.mask), boxes += std::popcount(box);
    }
    std::printf(
        "pu_intersect: sigma up to %4.0f px: %6.2f regions per splat hold a pixel that counts, %+.2f %% kept beyond, "
        "boxes %.2f\n",
        longest, static_cast<double>(needed) / 4000,
        100.0 * static_cast<double>(kept - needed) / static_cast<double>(needed), static_cast<double>(boxes) / 4000);
    if (config.tile_test) EXPECT_LE(static_cast<double>(kept), 1.03 * static_cast<double>(needed));
    else EXPECT_GE(kept, boxes) << "every region of the box";
  }
}

// The regions that the oriented box of double precision touches, and few others.
TEST(PuIntersect, KeepsWhatTheOrientedBoxTouches) {
  const Config config = test_config();
  if (!config.oriented()) GTEST_SKIP() << "regions by alpha";
  std::mt19937_64 rng(test_seed());
  for (double longest : {1.0, 3.0, 10.0, 100.0, 1000.0, 5000.0}) {
    int64_t touched = 0, kept = 0, far = 0, lost = 0;
    for (int i = 0; i < 4000; ++i) {
      const RandomSplat s = random_splat(config, rng, longest);
      const FloatBox box = float_box(s.record);
      if (box.round) continue;
      const Coeff q = coeff_of(config, s.record);
      const Tiles tiles = pu_intersect(config, Frame{}, q);
      uint64_t within = 0, beyond = 0, counts = 0;
      for (int r = 0; r < config.mask_w() && !q.dead; ++r) {
        const int x = r % config.part_regions_x() * 8, y = r / config.part_regions_x() * 8;
        const uint64_t bit = uint64_t{1} << r;
        if (touches(box, s.mean_x, s.mean_y, x, y, 8, 0)) within |= bit;
        if (!touches(box, s.mean_x, s.mean_y, x, y, 8, 1.0 / 8 + std::ldexp(box.side_long, -11))) beyond |= bit;
        for (int k = 0; k < 64; ++k) {
          if (s.power(x + k % 8, y + k / 8) > -std::log2(config.alpha_cut) + 0.01) counts |= bit;
        }
      }
      ASSERT_EQ(within & ~tiles.mask, 0u) << to_text(config, q);
      ASSERT_EQ(beyond & tiles.mask, 0u) << to_text(config, q);
      touched += std::popcount(within), kept += std::popcount(tiles.mask);
      lost += std::popcount(counts & ~tiles.mask), far += std::popcount(tiles.mask & ~counts);
    }
    std::printf(
        "pu_intersect: sigma up to %4.0f px: the oriented box touches %6.2f regions per splat, %+.2f %% kept "
        "beyond; %.2f %% of the kept hold no pixel that counts, %.3f %% are lost\n",
        longest, static_cast<double>(touched) / 4000,
        100.0 * static_cast<double>(kept - touched) / static_cast<double>(touched),
        100.0 * static_cast<double>(far) / static_cast<double>(kept),
        100.0 * static_cast<double>(lost) / static_cast<double>(kept));
    EXPECT_LE(static_cast<double>(kept), 1.03 * static_cast<double>(touched));
    EXPECT_GT(far, 0);
  }
}

}  // namespace
}  // namespace pipegs
