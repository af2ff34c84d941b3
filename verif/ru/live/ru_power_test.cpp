// SPDX-License-Identifier: Apache-2.0
// ru_power_test: rtl/ru/live/ru_power.sv against cpp_model/ru/ru_quads.hpp and the powers of cpp_model/pu/rows.
#include "cpp_model/pu/rows/pu_alpha.hpp"
#include "cpp_model/pu/rows/pu_region.hpp"
#include "cpp_model/pu/rows/pu_row_unit.hpp"
#include "cpp_model/ru/ru_quads.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/pu/rows/random_row_job.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vru_power.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const PuAlpha kAlpha(kConfig);
const int kGroups = Config::ru_groups();
constexpr uint32_t kHalfOfQuads = 0xff;

// Gives regions, stops quads, takes halves: the groups are ready at different times, each until it takes something.
class Around : public Endpoint {
 public:
  Around(Bench<Vru_power>& bench, Pace in_pace, Pace out_pace, bool stopping)
      : bench_(bench),
        in_(bench, kConfig, bench.dut.region_valid_i, bench.dut.region_ready_o, bench.dut.region_i, in_pace),
        out_pace_(out_pace),
        stopping_(stopping),
        stopped(kConfig.regions() / kConfig.units) {
    bench.add(*this);
    for (uint32_t& slot : stopped) slot = stopping ? bench.rng() & bench.rng() & 0xffff : 0;
  }
  void push(const Region& region) {
    Given given{.region = region, .color = bench_.rng() & ((uint64_t{1} << 3 * kConfig.color_w) - 1)};
    for (int dy = 0; dy < 8; ++dy) {
      Row row = pu_row_init(region, dy);
      for (int dx = 0; dx < 8; ++dx) {
        given.exponents[8 * dy + dx] = kAlpha.exponent(row.power);
        given.visible[8 * dy + dx] = given.exponents[8 * dy + dx].visible != 0;
        row = pu_row_unit(row, region.curve_x);
      }
    }
    given_.push_back(given);
    in_.push(region);
  }
  void drive() override {
    auto& dut = bench_.dut;
    dut.color_i = dut.region_valid_i ? given_[in_.taken].color : 0;
    if (stopping_ && bench_.rng() % 4 == 0) stopped[bench_.rng() % stopped.size()] |= 1u << bench_.rng() % kQuads;
    Words words(port_words<decltype(dut.stopped_i)>() + 2);
    for (size_t slot = 0; slot < stopped.size(); ++slot) {
      for (int i = 0; i < kQuads; ++i) {  // [group, slot, row]
        const int group = i / 4, row = i % 4, at = static_cast<int>(4 * (group * stopped.size() + slot)) + row;
        put_bits(words.data(), at, 1, stopped[slot] >> ru_quad(group, row) & 1);
      }
    }
    write_port(dut.stopped_i, words.data());
    for (int g = 0; g < kGroups; ++g) ready_ |= static_cast<uint32_t>(goes(out_pace_, bench_.rng)) << g;
    dut.out_room_i = ready_;
  }
  void observe() override {
    auto& dut = bench_.dut;
    if (!dut.busy_o) { EXPECT_TRUE(through()) << "not busy with something inside, cycle " << bench_.cycle; }
    for (; taken_ < in_.taken; ++taken_) given_[taken_].stopped = stopped_of(given_[taken_]);
    if (dut.out_push_o) take_half();
    ready_ &= ~dut.out_push_o;
  }
  void take_half() {
    auto& dut = bench_.dut;
    const int half = dut.out_half_o;
    while (place_ < taken_ && (given_[place_].region.index != dut.out_index_o || half < half_)) {
      ASSERT_EQ(still_live(place_, half_), 0u) << "half " << half_ << " of " << place_ << " is missing";
      next_half();
    }
    ASSERT_LT(place_, taken_) << "a half of no region, cycle " << bench_.cycle;
    if (half_ < half) {
      ASSERT_EQ(still_live(place_, half_), 0u) << "half " << half_ << " of " << place_ << " is missing";
      next_half();
    }
    const Given& given = given_[place_];
    ASSERT_EQ(dut.out_region_o, given.region.region) << "cycle " << bench_.cycle;
    ASSERT_EQ(dut.out_color_o, given.color) << "cycle " << bench_.cycle;
    uint32_t live = 0;
    for (int g = 0; g < kGroups; ++g) {
      const uint32_t pair = dut.out_live_o >> 2 * g & 3;
      ASSERT_EQ(dut.out_push_o >> g & 1, pair != 0) << "group " << g << ", cycle " << bench_.cycle;
      for (int j = 0; j < 2; ++j) {
        if (pair >> j & 1) {
          live |= 1u << ru_quad(g, 2 * half + j);
          ASSERT_NO_FATAL_FAILURE(compare_quad(given, g, j, ru_quad(g, 2 * half + j)));
        }
      }
    }
    ASSERT_EQ(dut.out_push_o & ~dut.out_room_i, 0) << "not all groups take the half";
    const uint32_t before = ru_live_quads(given.visible, given.stopped) & kHalfOfQuads << 8 * half;
    ASSERT_EQ(live & ~before, 0u) << "a quad that does not live, cycle " << bench_.cycle;
    ASSERT_EQ(still_live(place_, half) & ~live, 0u) << "a quad that lives is missing, cycle " << bench_.cycle;
    next_half();
    cycles.push_back(bench_.cycle);
  }

  std::vector<uint64_t> cycles;  // of each half
  uint64_t taken() const { return in_.taken; }
  bool finished() const { return in_.empty() && through() && !bench_.dut.busy_o; }

 private:
  struct Given {
    Region region;
    uint64_t color;
    Exponent exponents[kRegionPixels] = {};
    uint16_t visible[kRegionPixels] = {};
    uint32_t stopped = 0;  // when it was taken
  };
  uint32_t stopped_of(const Given& given) const {
    return stopped[ru_slot(kConfig, static_cast<int>(given.region.region))];
  }
  // The quads of a half that live whenever one looks.
  uint32_t still_live(size_t i, int half) const {
    return ru_live_quads(given_[i].visible, stopped_of(given_[i])) & kHalfOfQuads << 8 * half;
  }
  void next_half() {
    place_ += half_;
    half_ = 1 - half_;
  }
  bool through() const {
    for (size_t i = place_; i < taken_; ++i) {
      for (int half = i == place_ ? half_ : 0; half < 2; ++half)
        if (still_live(i, half) != 0) return false;
    }
    return true;
  }
  void compare_quad(const Given& given, int group, int j, int quad) const {
    const int width = record_width<Exponent>(kConfig);
    Words words(port_words<decltype(Vru_power::out_o)>() + 2), wanted(2);
    read_port(bench_.dut.out_o, words.data());
    for (int i = 0; i < kQuadPixels; ++i) {
      const Exponent& expected = given.exponents[ru_quad_pixel(quad, i)];
      put_bits(wanted.data(), 0, width, get_bits(words.data(), (8 * group + 4 * j + i) * width, width));
      ASSERT_EQ(first_difference(kConfig, expected, unpack<Exponent>(kConfig, wanted.data())), "")
          << "quad " << quad << " pixel " << i << " of " << place_ << ", cycle " << bench_.cycle;
    }
  }

  Bench<Vru_power>& bench_;
  RecordSource<Region, decltype(Vru_power::region_i)> in_;
  Pace out_pace_;
  bool stopping_;
  std::vector<Given> given_;
  size_t taken_ = 0, place_ = 0;  // regions taken, the one whose half comes next
  int half_ = 0;
  uint32_t ready_ = 0;

 public:
  std::vector<uint32_t> stopped;  // of each slot
};

Region random_region(std::mt19937_64& rng, uint64_t index) {
  RowJob job = gaussian_row_job(kConfig, rng);
  const int r = static_cast<int>(rng() % kConfig.regions());
  Region region = pu_region(kConfig, job, r);
  if (rng() % 8 == 0) {  // as large as coefficients in range can make it: docs/units/pu.md
    region = random_record<Region>(kConfig, rng);
    region.power /= 2, region.slope_x /= 2, region.slope_y /= 2;
    region.curve_x /= 2, region.curve_y /= 2, region.twist /= 2;
  }
  region.kind = kData;
  region.region = static_cast<uint64_t>(r);
  region.index = index;
  return region;
}

// A region of which all pixels are visible.
Region flat_region(std::mt19937_64& rng, uint64_t index) {
  Region region = random_region(rng, index);
  region.power = -1;
  region.slope_x = region.slope_y = region.curve_x = region.curve_y = region.twist = 0;
  return region;
}

TEST(RuPower, EqualsItsModelAtEveryPairOfPaces) {
  for (const Pace in_pace : kPaces) {
    for (const Pace out_pace : kPaces) {
      for (const bool stopping : {false, true}) {
        Bench<Vru_power> bench;
        Around around(bench, in_pace, out_pace, stopping);
        for (uint64_t i = 0; i < 300; ++i) around.push(random_region(bench.rng, i));
        bench.reset();
        bench.run_until([&] { return around.finished() || HasFailure(); });
        if (HasFailure())
          FAIL() << "in " << to_text(in_pace) << ", out " << to_text(out_pace) << ", seed " << bench.seed;
      }
    }
  }
}

// Regions with no, one or two living halves: a cycle for each half, and one for a region without.
TEST(RuPower, TakesACycleForEachLivingHalf) {
  for (const uint32_t stopped : {0x0000u, 0x00ffu, 0xff00u, 0xfe7fu, 0xffffu}) {
    Bench<Vru_power> bench;
    Around around(bench, Pace::kAlways, Pace::kAlways, false);
    for (uint32_t& slot : around.stopped) slot = stopped;
    const uint64_t regions = 100, halves = ((stopped & 0xff) != 0xff) + ((stopped >> 8) != 0xff);
    for (uint64_t i = 0; i < regions; ++i) around.push(flat_region(bench.rng, i));
    bench.reset();
    const uint64_t start = bench.cycle;
    bench.run_until([&] { return around.taken() == regions || HasFailure(); });
    EXPECT_LE(bench.cycle - start, regions * std::max<uint64_t>(halves, 1)) << "stopped " << stopped;
    bench.run_until([&] { return around.finished() || HasFailure(); });
    ASSERT_EQ(around.cycles.size(), regions * halves) << "stopped " << stopped;
    if (halves == 0) continue;
    EXPECT_EQ(around.cycles.front(), start + 2) << "latency";
    EXPECT_EQ(around.cycles.back() - around.cycles.front(), around.cycles.size() - 1) << "stopped " << stopped;
  }
}

}  // namespace
}  // namespace pipegs
