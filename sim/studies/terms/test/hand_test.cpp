// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/terms: a frame of two tiles and three layers, worked by hand under each assumption; a view's
// sums; the closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/studies/terms/closed.hpp"
#include "verif/frame/scenes.hpp"
#include "sim/studies/terms/test/view.hpp"

namespace pipegs {
namespace {

class Hand : public testing::Test {
 protected:
  RungTimes of(const Terms& terms, Rung rung) { return TermsModel(view_, rates_).ladder(terms)[rung]; }
  RungTimes base(const Terms& terms) { return of(terms, Rung::kBaseline); }
  RungTimes hgr(const Terms& terms) { return of(terms, Rung::kHgr); }
  RungTimes dop(const Terms& terms) { return of(terms, Rung::kDop); }

  TermsView view_ = hand_view();
  MemoryRates rates_{0.1, 0.2, 0.1, 0.5, 0.25, 0.125};
  Terms t_ = hand_terms();
};

// Preprocessing 40 x 4 / 4. Each tile has an SU and an RU: A 20 x 5 comparisons, 2560 / 16 pixels; B 2 x 1, 256 / 16.
TEST_F(Hand, BaselineWaitsForPreprocessingThenForItsLongerTile) {
  const RungTimes times = base(t_);
  EXPECT_EQ(times.front, 40);
  EXPECT_EQ(times.cycles, 40 + 100 + 160);
  EXPECT_EQ(times.sort, (100 + 2) / 4.0);
  EXPECT_EQ(times.raster, (160 + 16) / 4.0);
  EXPECT_EQ(times.ratio, (1.6 + 8) / 2);
  EXPECT_EQ(times.stall, 40);
  EXPECT_DOUBLE_EQ(times.idle(), 1 - (40 + 25.5 + 44) / 900);
  EXPECT_DOUBLE_EQ(times.gap(), (44 - 25.5) / 300);
}

TEST_F(Hand, Lanes) {
  for (const Rung rung : {Rung::kBaseline, Rung::kDpc, Rung::kHgr})
    EXPECT_EQ(of(t_, rung).cycles - of(t_, rung).front, 260);  // a pixel a cycle: DPC saves none
  t_.lane = LanePace::kSerial, t_.exp = 16;
  EXPECT_EQ(base(t_).cycles, 40 + 100 + 160 * 36);
  EXPECT_DOUBLE_EQ(of(t_, Rung::kDpc).cycles, 40 + 100 + 160 * (2.5 + 10.0 / 256 + 25));
  EXPECT_EQ(hgr(t_).cycles - hgr(t_).front, 100 + 160 * 9);
  t_.lane = LanePace::kArea;
  EXPECT_EQ(base(t_).cycles, 40 + 100 + 160 * 4);
  EXPECT_EQ(hgr(t_).cycles - hgr(t_).front, 260);
  t_.exp = 4;
  EXPECT_DOUBLE_EQ(base(t_).cycles, 40 + 100 + 160 * 24 / 9.0);
}

TEST_F(Hand, PixelsAndEarlyStop) {
  const auto raster = [&](PixelSet set, bool stop) {
    t_.raster = set, t_.stop = stop;
    return base(t_).cycles - 40 - 100;
  };
  EXPECT_EQ(raster(PixelSet::kSquareTiles, false), 5120 / 16);
  EXPECT_EQ(raster(PixelSet::kOrientedTiles, false), 5120 / 16);
  EXPECT_EQ(raster(PixelSet::kOrientedParts, true), 1920 / 16);
  EXPECT_EQ(raster(PixelSet::kExactParts, false), 1280 / 16);
  EXPECT_EQ(raster(PixelSet::kReached, true), 600 / 16.0);
  t_.active = PixelSet::kExactParts, t_.stop = false;  // 1408 alphas a pixel a cycle on 32 Row Units
  EXPECT_EQ(hgr(t_).cycles, 44 + 100 + 80);
}

TEST_F(Hand, Sorters) {
  EXPECT_EQ(sort_cycles(SortPace::kWide, 20), 2 * (2 + 1));
  EXPECT_EQ(sort_cycles(SortPace::kSplitter, 20), 20 * 2 + 10 * 2);
  EXPECT_EQ(sort_cycles(SortPace::kCompare, 20), 20 * 5);
  EXPECT_EQ(sort_cycles(SortPace::kNetwork, 20), 16 * 15 / 8);
  EXPECT_EQ(sort_cycles(SortPace::kExchange, 20), 16 * 15);
  EXPECT_EQ(sort_cycles(SortPace::kRecords, 20), 60 + 3 * 20);
  EXPECT_EQ(sort_cycles(SortPace::kSplitter, 16), 16 + 10);
  EXPECT_EQ(sort_cycles(SortPace::kSplitter, 1025), 1025 * 4 + 10 * 65);
  EXPECT_EQ(sort_cycles(SortPace::kExchange, 1), 1);
  EXPECT_EQ(sort_cycles(SortPace::kCompare, 0), 0);
  t_.sort = SortPace::kExchange;  // now B's list waits for nothing and A's for its sort
  EXPECT_EQ(base(t_).cycles, 40 + 240 + 160);
}

// 2816 alphas on 32 Row Units, beside 40 cycles of projections or after them.
TEST_F(Hand, AlphasInThePus) {
  EXPECT_EQ(hgr(t_).front, 88);
  EXPECT_EQ(hgr(t_).pre, 88);
  EXPECT_EQ(hgr(t_).alpha_bytes, 2816);
  t_.in_turn = true;
  EXPECT_EQ(hgr(t_).front, 40 + 88);
  t_.rows = RowPace::kTwo;
  EXPECT_EQ(hgr(t_).front, 40 + 44);
  t_.rows = RowPace::kSerial, t_.exp = 4;
  EXPECT_EQ(hgr(t_).front, 40 + 88 * 6.5);
  t_.opaque = false;  // without layers nothing is known to be opaque
  EXPECT_EQ(hgr(t_).front, 40 + 88 * 6.5);
  EXPECT_EQ(base(t_).front, 40);
}

TEST_F(Hand, Preprocessing) {
  t_.all = false;
  EXPECT_EQ(base(t_).front, 24);
  t_.pre = 16;
  EXPECT_EQ(base(t_).front, 96);
  t_.turns = true;
  EXPECT_EQ(base(t_).front, 100);
}

// PU 0-40, 40-88, 160-168; SUs and RUs 40-160, 160-280, 280. A PU begins a layer when the one before is taken.
TEST_F(Hand, LayersOfTheFrame) {
  RungTimes times = dop(t_);
  EXPECT_EQ(times.cycles, 280);
  EXPECT_EQ(times.front, 40);
  EXPECT_EQ(times.stall, 40);
  EXPECT_EQ(times.pre, 40 + 48 + 8);
  t_.opaque = false;  // 960 and 1152 alphas
  times = dop(t_);
  EXPECT_EQ(times.pre, 30 + 36 + 8);
  EXPECT_EQ(times.cycles, 270);
  t_.grid = 8;  // one layer: as HGR, but with alphas of what is not opaque
  EXPECT_EQ(dop(t_).cycles, 66 + 260);
}

// Lists in turn, all units on one: PU 0-40, 40-80, B 106-114; a list is sorted in quarters, then blended by 64 lanes.
TEST_F(Hand, LayersListByList) {
  t_.by_window = true;
  EXPECT_EQ(dop(t_).cycles, 119);
  EXPECT_EQ(dop(t_).raster, 20 + 20 + 4);
  EXPECT_EQ(dop(t_).sort, 6 + 6 + 1);
  t_.list = 64, t_.turns = true;  // one window: 200 / 4 for each of two layers, 12 keys of a list at most
  const RungTimes times = dop(t_);
  EXPECT_EQ(times.pre, 50 + 50 + 0);
  EXPECT_EQ(times.sort, 6 + 6);
  EXPECT_EQ(times.raster, 20 + 24);
  EXPECT_EQ(times.cycles, 100 + 6 + 24);
}

// A window has the four SUs and RUs: 20 keys in quarters, 5 x 3 comparisons; 2816 / 64 pixels.
TEST_F(Hand, ListsOfWindows) {
  t_.list = 64;
  EXPECT_EQ(base(t_).cycles, 40 + 15 + 44);
  EXPECT_EQ(base(t_).ratio, 44 / 15.0);
}

// 40 x 236 bytes of scene, 22 x 8 + 24 x 32 of lists there, 22 x 40 back, 512 x 4 of pixels.
TEST_F(Hand, Memory) {
  t_.dram = true;
  EXPECT_DOUBLE_EQ(base(t_).front, 944 + 188.8);
  EXPECT_DOUBLE_EQ(base(t_).cycles, 944 + 188.8 + 88 + 256);
  EXPECT_EQ(base(t_).bytes, 9440 + 944 + 880 + 2048);
  EXPECT_EQ(hgr(t_).bytes, base(t_).bytes);
  t_.packed = true;
  EXPECT_EQ(base(t_).bytes, 40 * 96 + 2 * 22 * 64 + 512 * 8);
  t_.packed = false, t_.store = AlphaStore::kMemory, t_.alpha_bytes = 2;
  EXPECT_DOUBLE_EQ(hgr(t_).front, 944 + 188.8 + 5632 * 0.5);
  EXPECT_DOUBLE_EQ(hgr(t_).cycles - hgr(t_).front, 88 + 256 + 5632 * 0.25);
  t_.stop = true;  // an RU reads what is not opaque
  EXPECT_DOUBLE_EQ(hgr(t_).cycles - hgr(t_).front, 88 + 256 + 4224 * 0.25);
  t_.dram = false;
  EXPECT_EQ(hgr(t_).front, 88);
}

// 1000 bytes more than the store holds. Without a store all of them pass beside the work.
TEST_F(Hand, WhatTheStoreDoesNotHold) {
  const ListWork list = list_work(1, 0, kChipBytes + 1000, 0, 0), none = list_work(0, 0, 0, 0, 0);
  view_ = {.frame = slice_of_lists(0, 0, list, none, 1, 0)};
  view_.frame.valid = 1;
  view_.grids[4] = {view_.frame};
  rates_ = {.alpha_write = 0.5, .alpha_read = 0.25};
  t_.dram = true, t_.pre = 0, t_.store = AlphaStore::kChip;
  const double alphas = (kChipBytes + 1000) / 32, raster = 1 + (kChipBytes + 1000) / 16;
  EXPECT_DOUBLE_EQ(dop(t_).cycles, alphas + 500 + raster + 250);
  EXPECT_EQ(dop(t_).bytes, 2 * 1000 + 236 + 8 + 40);  // and a Gaussian, its key, its key and feature
  EXPECT_DOUBLE_EQ(hgr(t_).cycles, alphas + raster);
  t_.store = AlphaStore::kMemory;
  EXPECT_DOUBLE_EQ(dop(t_).cycles, (kChipBytes + 1000) * 0.5 + (kChipBytes + 1000) * 0.25);
  t_.store = AlphaStore::kFree;
  EXPECT_DOUBLE_EQ(dop(t_).cycles, alphas + raster);
}

TEST(TermsView, HasTheSumsOfItsCounts) {
  const FrameCounts counts = count_frame(random_scene(21, 3000, 0), test_camera(150, 100), {.grids = {4, 8}});
  const TermsView view = terms_view(counts);
  EXPECT_EQ(view.pixels, 150 * 100);
  EXPECT_EQ(view.frame.tiles.size(), 10u * 7);
  EXPECT_EQ(view.frame.windows.size(), 3u * 2);
  const auto is = [](const Slice& slice, PixelSet set, bool stop, uint64_t wanted) {
    EXPECT_EQ(slice.all_tiles.pixels(set, stop), static_cast<double>(wanted));
    EXPECT_EQ(slice.all_windows.pixels(set, stop), static_cast<double>(wanted));
  };
  const TileCounts& total = counts.total;
  is(view.frame, PixelSet::kReached, false, total.reached);
  is(view.frame, PixelSet::kReached, true, total.blends + total.stops);
  is(view.frame, PixelSet::kOrientedParts, false, 64 * total.oriented_8x8.all);
  is(view.frame, PixelSet::kOrientedParts, true, 64 * total.oriented_8x8.open);
  is(view.frame, PixelSet::kExactParts, true, 64 * total.exact_8x8.open);
  is(view.frame, PixelSet::kSquareTiles, false, 256 * list_sums(counts.lists[kLists16].lengths.square).pairs);
  is(view.frame, PixelSet::kOrientedTiles, true, 256 * total.walk.oriented.open);
  EXPECT_EQ(view.frame.all_windows.keys.exact, list_sums(counts.lists[kLists64].lengths.exact).pairs);
  for (const auto& [cells, layers] : view.grids) {
    double valid = 0, turns = 0, keys = 0;
    for (const Slice& layer : layers) {
      valid += layer.valid, turns += layer.all_windows.turns, keys += layer.all_tiles.keys.oriented;
    }
    EXPECT_EQ(layers.size(), static_cast<size_t>(cells));
    EXPECT_EQ(valid, view.frame.valid);
    EXPECT_EQ(turns, view.frame.all_windows.turns);
    EXPECT_EQ(keys, view.frame.all_tiles.keys.oriented);
  }
  EXPECT_THROW(terms_view(count_frame(scene_of({}), test_camera(16, 16), {})), std::invalid_argument);
}

TEST(TermsRates, AreThoseOfTheDramAndNoneForNothing) {
  const TermsView view = terms_view(count_frame(random_scene(22, 20000, 0), test_camera(400, 300), {.grids = {4}}));
  const MemoryRates rates = memory_rates(view, "lpddr5-6400x4", 1.0);
  for (const double rate : {rates.scene, rates.list_write, rates.list_read, rates.alpha_write, rates.alpha_read})
    EXPECT_GT(rate, 1 / 51.2);
  EXPECT_LT(rates.scene, 1.3 / 51.2);
  EXPECT_GT(rates.list_write, rates.list_read);  // scattered lines
  const TermsView empty = terms_view(count_frame(scene_of({}), test_camera(16, 16), {.grids = {4}}));
  EXPECT_EQ(memory_rates(empty, "lpddr5-6400x4", 1.0).scene, 0);
}

// The figures that operations give by themselves, and those that cannot be together.
TEST(TermsClosed, SaysWhatFollowsAndWhatContradicts) {
  std::set<std::string> equations;
  for (const ClosedRow& row : closed_form()) {
    EXPECT_TRUE(std::isfinite(row.residue())) << row.figure;
    equations.insert(row.equation);
    if (row.figure.starts_with("power,")) EXPECT_NEAR(row.value, row.paper, 0.0005) << row.figure;
    if (row.figure.starts_with("raster / sort")) EXPECT_LT(std::abs(row.residue()), 0.025) << row.figure;
    if (row.figure == "DOP over HGR") EXPECT_GT(row.residue(), 0.2) << row.equation;
  }
  EXPECT_EQ(equations.size(), closed_form().size());
  // By hand: x = 8.4609 / 0.30998 - 2.5391.
  EXPECT_NEAR(closed_form()[2].value, 24.76, 0.01);
}

}  // namespace
}  // namespace pipegs
