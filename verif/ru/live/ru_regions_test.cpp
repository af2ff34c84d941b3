// SPDX-License-Identifier: Apache-2.0
// ru_regions_test: rtl/ru/live/ru_regions.sv against cpp_model/pu/rows/pu_region.hpp, over splats, ends and windows.
#include "cpp_model/pu/rows/pu_region.hpp"
#include "cpp_model/ru/ru_aovs.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/ru/live/random_splat.hpp"
#include "verif/ru/region_ports.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vru_regions.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
const uint64_t kAll = ~uint64_t{0} >> (64 - kConfig.mask_w());
constexpr uint64_t kNever = ~uint64_t{0}, kLatency = 4;  // cycles from the choice of a region to the output

// Its colours and, where AOVs want it, its depth.
uint64_t color_of(const Sorted& splat, uint64_t range) {
  const uint64_t depth = kConfig.has_depths() ? ru_linear(kConfig, splat.depth, range) : 0;
  return (((((depth << kConfig.color_w) | splat.blue) << kConfig.color_w) | splat.green) << kConfig.color_w) |
         splat.red;
}

// Gives splats and ends, closes regions, hands them over, takes what comes out: in a window regions only close and are
// handed over, and which are open is not known in the cycle after the window's end.
class Around : public Endpoint {
 public:
  Around(Bench<Vru_regions>& bench, Pace in_pace, Pace out_pace, bool closing)
      : bench_(bench),
        in_(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i, in_pace),
        out_(bench, kConfig, bench.dut.region_valid_o, bench.dut.region_ready_i, bench.dut.region_o, out_pace),
        out_pace_(out_pace),
        closing_(closing) {
    bench.dut.range_i = bench.rng() % 64;
    bench.dut.hold_i = 0;
    bench.dut.end_ready_i = 0;
    bench.add(*this);
    start_window();
  }
  void start_window() {
    const uint64_t own = ru_own_mask(kConfig, bench_.rng() % kConfig.units);
    for (uint64_t& part : open_.mask) part = closing_ ? own & (bench_.rng() | bench_.rng()) : own;
    for (uint64_t& when : closed_) when = kNever;
    for (int r = 0; r < kConfig.regions(); ++r)
      if (!open_.has(kConfig, r)) closed_[r] = bench_.cycle;
    for (int part = 0; part < kConfig.parts(); ++part) held_.mask[part] = closing_ ? bench_.rng() & kAll : 0;
    for (int r = 0; r < kConfig.regions(); ++r) handed_[r] = held_.has(kConfig, r) ? kNever : 0;
  }
  void push(const Sorted& splat) {
    in_.push(splat);
    if (splats_.empty()) left_ = splat.mask;
    splats_.push_back({splat, kNever});
  }
  void drive() override {
    auto& dut = bench_.dut;
    if (closing_ && bench_.rng() % 64 == 0) {
      const int r = static_cast<int>(bench_.rng() % kConfig.regions());
      if (open_.has(kConfig, r)) closed_[r] = bench_.cycle;
      RegionSet gone;
      gone.add(kConfig, r);
      open_ = open_ & ~gone;
    }
    if (held_ != RegionSet{} && bench_.rng() % 4 == 0) {
      int r = static_cast<int>(bench_.rng() % static_cast<uint64_t>(kConfig.regions()));
      while (!held_.has(kConfig, r)) r = (r + 1) % kConfig.regions();
      RegionSet one;
      one.add(kConfig, r);
      held_ = held_ & ~one;
      handed_[r] = bench_.cycle;
    }
    dut.hold_i = new_window_ || (closing_ && bench_.rng() % 16 == 0);
    RegionSet any;
    for (uint64_t& part : any.mask) part = bench_.rng() & kAll;
    write_regions(kConfig, dut.open_i, dut.hold_i ? any : open_);
    if (new_window_) start_window();
    new_window_ = false;
    write_regions(kConfig, dut.held_i, held_);
    dut.end_ready_i = goes(out_pace_, bench_.rng);
  }
  void observe() override {
    auto& dut = bench_.dut;
    if (!dut.busy_o) { EXPECT_TRUE(through()) << "not busy with something inside, cycle " << bench_.cycle; }
    if (in_.taken > taken_) splats_[taken_++].taken = bench_.cycle;
    for (; out_seen_ < out_.size(); ++out_seen_) ASSERT_NO_FATAL_FAILURE(take_region(out_.at(out_seen_)));
    if (dut.end_valid_o && dut.end_ready_i) take_end();
  }
  // The next region of the splats in turn; what was passed over had been closed in time.
  void take_region(const Region& found) {
    while (place_ < taken_ && splats_[place_].splat.index != found.index) ASSERT_NO_FATAL_FAILURE(leave_splat());
    ASSERT_LT(place_, taken_) << "a region of no splat, cycle " << bench_.cycle;
    const auto& [splat, taken] = splats_[place_];
    const int region = static_cast<int>(found.region), bit = region_bit(kConfig, region);
    ASSERT_EQ(static_cast<uint64_t>(region_part(kConfig, region)), splat.part) << "cycle " << bench_.cycle;
    uint64_t before = 0;  // what should have come, because it did not wait
    for (int i = 0; i < bit; ++i) {
      const bool waited = handed_[region_number(kConfig, splat.part, i)] > taken;
      if (left_ >> i & 1 && !waited) before |= uint64_t{1} << i;
    }
    ASSERT_TRUE(left_ >> bit & 1) << "region " << region << " is out of order, cycle " << bench_.cycle;
    ASSERT_LE(handed_[region], bench_.cycle - kLatency) << "region " << region << " was held, cycle " << bench_.cycle;
    ASSERT_TRUE(are_closed(splat.part, before))
        << "a region before " << region << " is missing, cycle " << bench_.cycle;
    ASSERT_GT(closed_[region], taken) << "region " << region << " was closed before its splat came";
    left_ &= ~(before | uint64_t{1} << bit);
    Region expected = pu_region(kConfig, job_of(splat), bit);
    expected.address = expected.ext = 0;
    expected.region = found.region;
    ASSERT_EQ(first_difference(kConfig, expected, found), "") << "cycle " << bench_.cycle;
    ASSERT_EQ(bench_.dut.color_o, color_of(splat, bench_.dut.range_i)) << "cycle " << bench_.cycle;
  }
  void take_end() {
    ASSERT_FALSE(bench_.dut.region_valid_o) << "an end is shown before all before it has left";
    while (place_ < taken_ && splats_[place_].splat.kind == kData) ASSERT_NO_FATAL_FAILURE(leave_splat());
    ASSERT_LT(place_, taken_) << "an end too many, cycle " << bench_.cycle;
    ASSERT_EQ(bench_.dut.end_kind_o, splats_[place_].splat.kind) << "cycle " << bench_.cycle;
    new_window_ = splats_[place_].splat.kind == kWindowEnd;
    next_splat();
  }
  void leave_splat() {
    ASSERT_EQ(splats_[place_].splat.kind, kData) << "an end was passed over, cycle " << bench_.cycle;
    ASSERT_TRUE(are_closed(splats_[place_].splat.part, left_))
        << "regions of " << splats_[place_].splat.index << " are missing";
    next_splat();
  }
  void next_splat() {
    if (++place_ < splats_.size()) left_ = splats_[place_].splat.mask;
  }
  bool are_closed(uint64_t part, uint64_t mask) const {
    for (; mask != 0; mask &= mask - 1)
      if (closed_[region_number(kConfig, part, std::countr_zero(mask))] > bench_.cycle) return false;
    return true;
  }
  // Nothing of the splats that were taken is still to come.
  bool through() const {
    for (size_t i = place_; i < taken_; ++i) {
      if (splats_[i].splat.kind != kData) return false;
      if (!are_closed(splats_[i].splat.part, i == place_ ? left_ : splats_[i].splat.mask)) return false;
    }
    return true;
  }
  bool finished() const { return in_.empty() && through() && !bench_.dut.busy_o; }
  const std::vector<uint64_t>& cycles() const { return out_.cycles; }

 private:
  struct Given {
    Sorted splat;
    uint64_t taken;  // cycle
  };
  Bench<Vru_regions>& bench_;
  RecordSource<Sorted, decltype(Vru_regions::in_i)> in_;
  RecordSink<Region, decltype(Vru_regions::region_o)> out_;
  Pace out_pace_;
  bool closing_, new_window_ = false;
  RegionSet open_;
  RegionSet held_;
  uint64_t closed_[kRegions] = {}, handed_[kRegions] = {};  // the cycle in which each closed, was handed over
  std::vector<Given> splats_;
  size_t taken_ = 0, place_ = 0, out_seen_ = 0;  // splats taken, the one whose regions come, regions that came
  uint64_t left_ = 0;                            // its regions that may still come
};

Sorted random_splat(std::mt19937_64& rng, uint64_t index, uint64_t kind) {
  Sorted splat = random_record<Sorted>(kConfig, rng);  // any coefficients
  if (rng() % 4 != 0) give_coefficients(kConfig, rng, static_cast<int>(rng() % 3), splat);
  splat.kind = kind;
  splat.index = index;
  switch (rng() % 3) {
    case 0: splat.mask = uint64_t{1} << rng() % kConfig.mask_w(); break;
    case 1: splat.mask &= rng(); break;
    default: break;
  }
  return splat;
}

TEST(RuRegions, EqualsItsModelAtEveryPairOfPaces) {
  for (const Pace in_pace : kPaces) {
    for (const Pace out_pace : kPaces) {
      for (const bool closing : {false, true}) {
        Bench<Vru_regions> bench;
        Around around(bench, in_pace, out_pace, closing);
        for (uint64_t i = 0; i < 600; ++i) {
          const uint64_t dice = bench.rng() % 40;
          around.push(random_splat(bench.rng, i, dice == 0 ? kWindowEnd : dice < 3 ? kLayerEnd : kData));
        }
        bench.reset();
        bench.run_until([&] { return around.finished() || HasFailure(); });
        if (HasFailure())
          FAIL() << "in " << to_text(in_pace) << ", out " << to_text(out_pace) << ", seed " << bench.seed;
      }
    }
  }
}

// Splats of one region and of many, one behind the other.
TEST(RuRegions, GivesARegionEveryCycle) {
  Bench<Vru_regions> bench;
  Around around(bench, Pace::kAlways, Pace::kAlways, false);
  for (uint64_t i = 0; i < 200; ++i) {
    Sorted splat = random_splat(bench.rng, i, kData);
    splat.mask = i % 3 == 0 ? kAll : kAll >> (kConfig.mask_w() - kConfig.units);  // of those each unit owns one
    around.push(splat);
  }
  bench.reset();
  bench.run_until([&] { return around.finished() || HasFailure(); });
  const std::vector<uint64_t>& cycles = around.cycles();
  ASSERT_GE(cycles.size(), 200u);
  EXPECT_EQ(cycles.back() - cycles.front(), cycles.size() - 1);
}

// The first region of a splat comes five cycles after it was taken.
TEST(RuRegions, TakesFiveCycles) {
  Bench<Vru_regions> bench;
  Around around(bench, Pace::kAlways, Pace::kAlways, false);
  Sorted splat = random_splat(bench.rng, 0, kData);
  splat.mask = kAll;
  around.push(splat);
  bench.reset();
  const uint64_t start = bench.cycle;
  bench.run_until([&] { return around.finished() || HasFailure(); });
  ASSERT_FALSE(around.cycles().empty());
  EXPECT_EQ(around.cycles().front(), start + 5);
}

}  // namespace
}  // namespace pipegs
