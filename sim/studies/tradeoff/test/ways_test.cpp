// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/tradeoff/ways: every way is a legal machine, what is measured together was worth it alone, and
// nobody beats the front.
#include "sim/studies/tradeoff/ways.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

size_t count(const std::vector<Way>& ways, const std::string& knob) {
  return static_cast<size_t>(std::count_if(ways.begin(), ways.end(), [&](const Way& way) { return way.knob == knob; }));
}

TEST(Ways, AreLegalOnEveryDesignPointForEverySceneAndDifferFromEachOther) {
  for (const DesignPoint& point : design_points()) {
    for (int degree = 0; degree <= 3; ++degree) {
      SCOPED_TRACE(std::string(point.name) + ", SH degree " + std::to_string(degree));
      const Config base = point.config;
      const std::vector<Way> ways = ways_alone(base, random_scene(1, 3, degree));
      std::set<std::string> seen;
      for (const Way& way : ways) {
        EXPECT_NO_THROW(config_of(base, way)) << way.knob << " " << way.label;
        const std::string what = config_difference(config_of(base, way)) + " " + std::to_string(way.scale) + " " +
                                 std::to_string(way.without);
        EXPECT_TRUE(seen.insert(what).second) << way.knob << " " << way.label << " changes nothing";
      }
      EXPECT_EQ(ways.front().knob, "base");
      EXPECT_EQ(count(ways, "SH degree"), static_cast<size_t>(degree));
      EXPECT_EQ(count(ways, "order"), base.order == 1 ? 0u : base.order == 0 ? 2u : 3u);
      // All of them at once, too.
      Way all{.knob = "together", .label = ""};
      for (const Way& way : ways) all.settings.insert(all.settings.end(), way.settings.begin(), way.settings.end());
      EXPECT_NO_THROW(config_of(base, all));
    }
  }
}

TEST(Ways, ASceneOrAMachineThatHasItAlreadyIsNotAskedAgain) {
  Config base;
  base.sh_degree = 1;
  base.t_cut = 1000;
  base.alpha_cut = 64;
  const std::vector<Way> ways = ways_alone(base, random_scene(1, 3, 3));
  EXPECT_EQ(count(ways, "SH degree"), 1u);
  EXPECT_EQ(count(ways, "T cut"), 2u);
  EXPECT_EQ(count(ways, "alpha cut"), 2u);
}

TradeoffPoint point(const std::string& knob, const std::string& label, uint64_t cycles, double psnr) {
  TradeoffPoint result;
  result.way = {.knob = knob, .label = label, .settings = {}};
  result.cycles = cycles, result.psnr = psnr;
  return result;
}

// Half the time each: together a quarter, and both errors: 43.0 dB of two of 46 dB.
TEST(Ways, WhatSavesTimeAloneIsTriedTogether) {
  std::vector<TradeoffPoint> alone = {point("base", "all", 1000, 80),
                                      point("resolution", "1/2", 500, 46),
                                      point("resolution", "3/4", 900, 32),
                                      point("T cut", "1/1000", 500, 46),
                                      point("order", "layers of grid 4", 1100, 60),
                                      point("order", "none", 600, 25)};
  alone[1].way.scale = 0.5;
  alone[3].way.settings = {"t_cut=1000"};
  const std::vector<Way> ways = ways_together(alone, 10);
  ASSERT_EQ(ways.size(), 1u) << "3/4 is worse than 1/2, layers save nothing, without order there are fewer than 30 dB";
  EXPECT_EQ(ways[0].knob, "together");
  EXPECT_EQ(ways[0].label, "resolution 1/2, T cut 1/1000");
  EXPECT_EQ(ways[0].scale, 0.5);
  EXPECT_EQ(ways[0].without, 0);
  EXPECT_EQ(ways[0].settings, alone[3].way.settings);
  EXPECT_TRUE(ways_together(alone, 0).empty());
  EXPECT_TRUE(ways_together({alone[0]}, 10).empty());
  EXPECT_TRUE(ways_together({alone[0], alone[1], alone[2]}, 10).empty()) << "two values of one thing are no two things";
}

TEST(Ways, AFewOfManyAreSpreadOverTheirDecibels) {
  std::vector<TradeoffPoint> alone = {point("base", "all", 1000, 70)};
  for (const char* knob : {"resolution", "contribution", "alpha cut", "T cut"}) {
    for (int i = 1; i <= 4; ++i) alone.push_back(point(knob, std::to_string(i), 1000 - 100 * i, 65 - 7 * i));
  }
  const size_t all = ways_together(alone, 1000).size();
  EXPECT_GT(all, 8u);
  for (const int most : {1, 2, 5}) {
    const std::vector<Way> ways = ways_together(alone, most);
    EXPECT_EQ(ways.size(), static_cast<size_t>(most));
    std::set<std::string> labels;
    for (const Way& way : ways) EXPECT_TRUE(labels.insert(way.label).second) << way.label;
  }
}

TEST(Ways, NobodyBeatsTheFrontAndAllOthersAreBeaten) {
  std::mt19937 rng(1);
  std::vector<TradeoffPoint> points;
  for (int i = 0; i < 300; ++i) {  // more time is often, not always, more accuracy; some points are equal
    const uint64_t cycles = 1 + rng() % 50;
    points.push_back(point("a", "b", cycles, static_cast<double>(cycles + rng() % 20)));
  }
  find_front(points);
  const auto beats = [](const TradeoffPoint& a, const TradeoffPoint& b) {
    return a.cycles <= b.cycles && a.psnr >= b.psnr && (a.cycles < b.cycles || a.psnr > b.psnr);
  };
  for (const TradeoffPoint& one : points) {
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const auto& other) { return beats(other, one); });
    EXPECT_EQ(one.front > 0, !beaten);
  }
  const std::vector<const TradeoffPoint*> front = front_of(points);
  ASSERT_GT(front.size(), 3u);
  for (size_t i = 0; i < front.size(); ++i) EXPECT_EQ(front[i]->front, static_cast<int>(i + 1));
  for (size_t i = 1; i < front.size(); ++i) {
    EXPECT_LE(front[i]->psnr, front[i - 1]->psnr);
    EXPECT_LE(front[i]->cycles, front[i - 1]->cycles);
  }
}

}  // namespace
}  // namespace pipegs
