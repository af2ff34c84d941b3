// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/explore/tradeoff: every point is a legal machine, what is measured together saved time alone,
// nobody beats the front, and a decibel's price is that of its step.
#include "sim/studies/explore/tradeoff.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "sim/design/design_point.hpp"
#include "sim/studies/explore/report.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

size_t count(const std::vector<Point>& points, const std::string& knob) {
  return static_cast<size_t>(
      std::count_if(points.begin(), points.end(), [&](const Point& point) { return point.knob == knob; }));
}

TEST(Tradeoff, PointsAreLegalOnEveryDesignPointForEverySceneAndDifferFromEachOther) {
  for (const DesignPoint& design_point : design_points()) {
    for (int degree = 0; degree <= 3; ++degree) {
      SCOPED_TRACE(std::string(design_point.name) + ", SH degree " + std::to_string(degree));
      const Config base = design_point.config;
      const std::vector<Point> points = less_alone(base, random_scene(1, 3, degree));
      std::set<std::string> seen;
      KnobValue all;  // of them at once, too
      for (const Point& point : points) {
        const Less& less = point.value.less;
        const std::string what = config_difference(point.config) +
                                 fmt::format(" {} {} {} {}", less.scale, less.without, less.rest, less.lod);
        EXPECT_TRUE(seen.insert(what).second) << point.knob << " " << point.value.label << " changes nothing";
        all.settings.insert(all.settings.end(), point.value.settings.begin(), point.value.settings.end());
      }
      EXPECT_NO_THROW(with_value(base, all));
      EXPECT_EQ(points.front().knob, kBase);
      EXPECT_EQ(points.front().config, base);
      EXPECT_EQ(count(points, "SH degree"), static_cast<size_t>(degree));
      EXPECT_EQ(count(points, "proxies"), base.order == 2 ? 4u : 0u);
      EXPECT_EQ(count(points, "record"), 1u);
      EXPECT_EQ(count(points, "order"), base.order == 1 ? 0u : base.order == 0 ? 2u : 3u);
    }
  }
}

TEST(Tradeoff, ASceneOrAMachineThatHasItAlreadyIsNotAskedAgain) {
  Config base;
  base.sh_degree = 1;
  base.alpha_cut = 64;
  const std::vector<Point> points = less_alone(base, random_scene(1, 3, 3));
  EXPECT_EQ(count(points, "SH degree"), 1u);
  EXPECT_EQ(count(points, "rest"), 5u);
  base.early_stop = 0;
  EXPECT_EQ(count(less_alone(base, random_scene(1, 3, 3)), "rest"), 0u);
  EXPECT_EQ(count(points, "alpha cut"), 2u);
}

Point point(const std::string& knob, const std::string& label, uint64_t cycles, double psnr) {
  Point result{.knob = knob, .value = {.label = label}, .config = {}};
  result.figures.cycles = cycles, result.figures.total = {.psnr = psnr, .ssim = 0.9};
  return result;
}

// Half the time each: together a quarter, and both errors: 43.0 dB of two of 46 dB.
TEST(Tradeoff, WhatSavesTimeAloneIsTriedTogether) {
  std::vector<Point> alone = {point("base", "all", 1000, 80),
                              point("resolution", "1/2", 500, 46),
                              point("resolution", "3/4", 900, 32),
                              point("rest", "1/1000", 500, 46),
                              point("order", "layers of grid 4", 1100, 60),
                              point("order", "none", 600, 25)};
  alone[1].value.less.scale = 0.5;
  alone[3].value.less.rest = 0.001;
  const std::vector<Point> points = less_together(alone, 10);
  ASSERT_EQ(points.size(), 1u)
      << "3/4 is worse than 1/2, layers save nothing, without order there are fewer than 30 dB";
  EXPECT_EQ(points[0].knob, kTogether);
  EXPECT_EQ(points[0].value.label, "resolution 1/2, rest 1/1000");
  EXPECT_EQ(points[0].value.less.scale, 0.5);
  EXPECT_EQ(points[0].value.less.without, 0);
  EXPECT_EQ(points[0].value.less.rest, 0.001);
  EXPECT_TRUE(less_together(alone, 0).empty());
  EXPECT_TRUE(less_together({alone[0]}, 10).empty());
  EXPECT_TRUE(less_together({alone[0], alone[1], alone[2]}, 10).empty()) << "two values of one thing are no two things";
}

TEST(Tradeoff, AFewOfManyAreSpreadOverTheirDecibels) {
  std::vector<Point> alone = {point("base", "all", 1000, 70)};
  for (const char* knob : {"resolution", "contribution", "alpha cut", "rest"}) {
    for (int i = 1; i <= 4; ++i) alone.push_back(point(knob, std::to_string(i), 1000 - 100 * i, 65 - 7 * i));
  }
  const size_t all = less_together(alone, 1000).size();
  EXPECT_GT(all, 8u);
  for (const int most : {1, 2, 5}) {
    const std::vector<Point> points = less_together(alone, most);
    EXPECT_EQ(points.size(), static_cast<size_t>(most));
    std::set<std::string> labels;
    for (const Point& one : points) EXPECT_TRUE(labels.insert(one.value.label).second) << one.value.label;
  }
}

// Of equal points the first one stands on the front.
TEST(Tradeoff, NobodyBeatsTheFrontAndAllOthersAreBeaten) {
  std::mt19937 rng(1);
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {  // more time is often, not always, more accuracy; some points are equal
    const uint64_t cycles = 1 + rng() % 50;
    points.push_back(point("a", "b", cycles, static_cast<double>(cycles + rng() % 20)));
  }
  const std::vector<const Point*> front = find_tradeoff_front(points);
  const auto psnr = [](const Point& one) { return one.figures.total.psnr; };
  for (const Point& one : points) {
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const Point& other) {
      return other.cycles() <= one.cycles() && psnr(other) >= psnr(one) &&
             (other.cycles() < one.cycles() || psnr(other) > psnr(one) || &other < &one);
    });
    EXPECT_EQ(one.front > 0, !beaten);
  }
  ASSERT_GT(front.size(), 3u);
  for (size_t i = 0; i < front.size(); ++i) EXPECT_EQ(front[i]->front, static_cast<int>(i + 1));
  for (size_t i = 1; i < front.size(); ++i) {
    EXPECT_LT(psnr(*front[i]), psnr(*front[i - 1]));
    EXPECT_LT(front[i]->cycles(), front[i - 1]->cycles());
  }
}

std::vector<Point> six() {
  return {point("base", "all", 1000000, 70), point("rest", "a", 800000, 52), point("rest", "b", 900000, 49),
          point("rest", "c", 600000, 42),    point("rest", "d", 590000, 41), point("rest", "e", 100000, 20)};
}

TEST(Tradeoff, ADecibelCostsWhatItsStepCosts) {
  std::vector<Point> points = six();
  const std::vector<PricedStep> steps = price(find_tradeoff_front(points));
  ASSERT_EQ(steps.size(), 2u) << "nothing faster has 30 dB";
  EXPECT_EQ(steps[0].from->value.label, "all");
  EXPECT_EQ(steps[0].to->value.label, "a");
  EXPECT_DOUBLE_EQ(steps[0].cycles, 200000);
  EXPECT_DOUBLE_EQ(steps[0].cycles_per_db, 200000.0 / 18);
  EXPECT_EQ(steps[1].to->value.label, "d");
  EXPECT_DOUBLE_EQ(steps[1].cycles_per_db, 210000.0 / 11);
  EXPECT_TRUE(price({}).empty());
  points[0].figures.total.psnr = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(price(find_tradeoff_front(points)).empty()) << "of an exact picture a decibel has no price";
}

// What the models do not know is empty, and null; "~" stands before what they only guess.
TEST(Tradeoff, EachPointHasTheAreaAndTheEnergyThatAreKnown) {
  const Scene scene = random_scene(1, 3, 0);
  const Camera camera = test_camera(64, 48);
  const std::vector<Camera> cameras = {camera};
  std::vector<Point> points = six();
  const FrameModel model = read_frame_model();
  const Config fast = find_design_point("fast").config;
  points[0].config = points[1].config = fast;
  points[1].config.lod = 1;
  points[2].config = with_value(fast, {.label = "", .settings = layers_of_grid(4)});
  for (Point& point : points) point.silicon = model.cost(point.config, point.figures.cycles, 1000000);
  points[1].silicon->extrapolated_area = points[1].silicon->extrapolated_energy = true;
  const Answer answer = tradeoff_answer(points, View(scene, camera, cameras, {}, Measured::kPicture), 1);
  const nlohmann::ordered_json &json = answer.json["points"], &known = json[0]["silicon"];
  EXPECT_DOUBLE_EQ(known["mm2"]["mid"].get<double>(), points[0].mm2());
  EXPECT_DOUBLE_EQ(known["chip_mj"]["mid"].get<double>() + known["dram_mj"]["mid"].get<double>(),
                   1e3 * points[0].joules());
  EXPECT_TRUE(json[1]["silicon"]["extrapolated_area"].get<bool>());
  ASSERT_FALSE(points[2].silicon) << "an area of layers with living quads is known now: take another machine";
  EXPECT_TRUE(json[2]["silicon"].is_null());

  const Table& table = answer.tables.at(0);
  const auto cell = [&](size_t row, const std::string& key) {
    const auto column = std::ranges::find(table.columns, key, &TableColumn::key);
    return cell_text(table.rows.at(row).at(static_cast<size_t>(column - table.columns.begin())), *column);
  };
  EXPECT_EQ(cell(0, "uj"), fmt::format("{:.0f}", 1e6 * points[0].joules()));
  EXPECT_EQ(cell(0, "mm2"), fmt::format("{:.3f}", points[0].mm2()));
  EXPECT_EQ(cell(1, "uj"), fmt::format("~{:.0f}", 1e6 * points[1].joules()));
  EXPECT_EQ(cell(1, "mm2"), fmt::format("~{:.3f}", points[1].mm2()));
  EXPECT_EQ(cell(2, "uj") + cell(2, "mm2"), "");
  EXPECT_NE(tables_text(answer.tables).find("mm2, uJ: 28 nm"), std::string::npos);
}

TEST(Tradeoff, TextJsonAndChartTellTheSameTime) {
  const Scene scene = random_scene(1, 3, 0);
  const Camera camera = test_camera(64, 48);
  const std::vector<Camera> cameras = {camera};
  const Answer answer = tradeoff_answer(six(), View(scene, camera, cameras, {}, Measured::kPicture), 0.8);
  const nlohmann::ordered_json& points = answer.json["points"];
  EXPECT_DOUBLE_EQ(points[1]["us"].get<double>(), 1000);
  EXPECT_EQ(points[1]["front"], 2);
  EXPECT_TRUE(points[2]["front"].is_null()) << "a is faster and closer than b";
  const std::string text = tables_text(answer.tables);
  EXPECT_NE(text.find("80.00  1000.0"), std::string::npos) << text;
  EXPECT_NE(text.find("at 0.8 GHz"), std::string::npos) << text;
  EXPECT_NE(text.find("from 70.0 to 52.0 dB, front 1 to 2: 250.0 us, 13.9 us a decibel"), std::string::npos) << text;
  const Chart& chart = answer.charts.at(0);
  EXPECT_NO_THROW(charts_json({chart}));  // counts fit each other
  ASSERT_EQ(chart.series.size(), 3u);
  EXPECT_EQ(chart.series[1].x[0], 1000);
  EXPECT_EQ(chart.series[2].labels, (std::vector<std::string>{"1", "2", "3", "4", "5"}));
}

}  // namespace
}  // namespace pipegs
