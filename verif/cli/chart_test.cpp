// SPDX-License-Identifier: Apache-2.0
// chart_test: charts as SVG: well-formed, one mark for each value, axes that hold all values.
#include "sim/report/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "verif/cli/well_formed.hpp"

namespace pipegs {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Bars and markers carry a tooltip each, nothing else does.
int marks(const Chart& chart) {
  const std::string svg = charts_svg({chart});
  EXPECT_EQ(xml_fault(svg), "") << svg;
  return count(svg, "<title>");
}

Chart bars() {
  return {.form = Chart::Form::kBars,
          .title = "Title",
          .x_label = "x",
          .y_label = "y",
          .categories = {"a", "b", "c"},
          .series = {{"one", {1, 2, 3}}, {"two", {0.5, kNone, 7}, true}}};
}

TEST(Chart, TheCheckOfTheTestsFindsBrokenXml) {
  EXPECT_EQ(xml_fault("<a><b x=\"1\"/>t &amp; u</a>"), "");
  for (const char* broken : {"<a><b></a></b>", "<a>", "<a x=1/>", "<a>&nonsense;</a>", "<a x=\"1\" x=\"2\"/>",
                             "<a/><b/>", "text", "<a x=\"<\"/>"}) {
    EXPECT_NE(xml_fault(broken), "") << broken;
  }
}

TEST(Chart, EveryFormDrawsEveryValueOnce) {
  Chart chart = bars();
  EXPECT_EQ(marks(chart), 5);
  chart.log_y = true;
  EXPECT_EQ(marks(chart), 5);
  chart.form = Chart::Form::kStacked;
  EXPECT_EQ(marks(chart), 5);
  chart.form = Chart::Form::kLines;
  chart.x = {1, 10, 100};
  EXPECT_EQ(marks(chart), 5);
  chart.log_x = true;
  EXPECT_EQ(marks(chart), 5);
  EXPECT_EQ(marks(histogram("h", "x", {1, 1, 2, 3, 9}, 4)), 3);  // one bin is empty
}

TEST(Chart, PointsLieWhereTheirSeriesSays) {
  Chart chart{.form = Chart::Form::kScatter, .title = "Points", .x_label = "x", .y_label = "y"};
  chart.series = {{.name = "cloud", .values = {60, 61, kNone}, .x = {900, 950, 990}, .labels = {"a", "b<", "c"}},
                  {.name = "front", .values = {61}, .outlined = true, .x = {950}, .labels = {"b"}}};
  EXPECT_EQ(marks(chart), 3);
  EXPECT_EQ(count(charts_svg({chart}), "<path"), 1);  // only what is outlined is joined
  EXPECT_EQ(count(charts_svg({chart}), ">b<"), 0);
  chart.series[1].named = true;
  EXPECT_EQ(count(charts_svg({chart}), ">b<"), 1);
  EXPECT_EQ(marks(chart), 3);
  chart.series[0].labels.pop_back();
  EXPECT_THROW(charts_svg({chart}), std::invalid_argument);
  chart.series = {};
  EXPECT_EQ(marks(chart), 0);
}

TEST(Chart, LinesMayHaveNamesAtTheirPlacesAndAnAxisNearTheirValues) {
  Chart chart = bars();
  chart.form = Chart::Form::kLines;
  chart.x = {0, 1, 2};
  chart.series = {{"one", {60, 61, 62}}};
  chart.from_zero = false;
  EXPECT_EQ(marks(chart), 3);
  const std::string svg = charts_svg({chart});
  for (const char* name : {">a<", ">b<", ">c<"}) EXPECT_EQ(count(svg, name), 1) << name;
  EXPECT_EQ(count(svg, ">0<"), 0);
  chart.categories.pop_back();
  EXPECT_THROW(charts_svg({chart}), std::invalid_argument);
}

TEST(Chart, WhatIsNotPositiveLeavesAGapOnALogarithmicAxis) {
  Chart chart = bars();
  chart.log_y = true;
  chart.series = {{"one", {0, -1, 3}}};
  EXPECT_EQ(marks(chart), 1);
}

TEST(Chart, HeightsAreInProportion) {
  Chart chart{.form = Chart::Form::kBars, .title = "t", .categories = {"a", "b"}, .series = {{"one", {10, 40}}}};
  const std::string svg = charts_svg({chart});
  double heights[2] = {};
  size_t at = 0;
  for (double& height : heights) {
    at = svg.find("<title>", at + 1);
    const size_t from = svg.rfind("height=\"", at) + 8;
    height = std::stod(svg.substr(from));
  }
  EXPECT_GT(heights[0], 1);
  EXPECT_NEAR(heights[1] / heights[0], 4, 0.01);
}

TEST(Chart, NamesMayHoldAnything) {
  Chart chart = bars();
  chart.title = "a < b & \"c\" > d";
  chart.categories[0] = "</svg>";
  chart.series[0].name = "\x01<script>";
  const std::string svg = charts_svg({chart});
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(Chart, EmptyAndOddChartsAreWellFormed) {
  EXPECT_EQ(xml_fault(charts_svg({})), "");
  EXPECT_EQ(marks({.title = "nothing"}), 0);
  EXPECT_EQ(marks({.form = Chart::Form::kBars, .categories = {"a"}, .series = {{"s", {kNone}}}}), 0);
  EXPECT_EQ(marks({.form = Chart::Form::kLines, .x = {5}, .series = {{"s", {2}}}, .log_x = true, .log_y = true}), 1);
  EXPECT_EQ(marks(histogram("h", "x", {}, 10)), 0);
  EXPECT_EQ(marks(histogram("h", "x", {7, 7, kNone}, 10, true)), 1);
  EXPECT_EQ(charts_svg({bars(), bars(), bars()}).find("nan"), std::string::npos);
}

TEST(Chart, CountsThatDoNotFitAreRefused) {
  Chart chart = bars();
  chart.series[0].values.pop_back();
  EXPECT_THROW(charts_svg({chart}), std::invalid_argument);
  EXPECT_THROW(charts_svg({{.form = Chart::Form::kHistogram, .x = {1}, .series = {{"s", {}}}}}), std::invalid_argument);
}

TEST(Chart, HistogramCountsEveryFiniteValueOnce) {
  const Chart chart = histogram("h", "x", {1, 2, 3, 4, 100, kNone}, 5);
  double sum = 0;
  for (const double value : chart.series[0].values) sum += value;
  EXPECT_EQ(sum, 5);
  EXPECT_EQ(chart.series[0].values.back(), 1);  // the largest lies in the last bin
  const Chart by_ratio = histogram("h", "x", {0, 1, 10, 100, 1000}, 3, true);
  EXPECT_NEAR(by_ratio.x[1] / by_ratio.x[0], 10, 1e-9);
}

TEST(Chart, TicksCoverTheRange) {
  for (const auto& [low, high] : {std::pair{0.0, 1.0}, {0.0, 97.0}, {0.0, 0.0031}, {3.0, 8.0}, {0.0, 2.2e6}}) {
    const std::vector<double> ticks = axis_ticks(low, high, false);
    EXPECT_LE(ticks.front(), low) << low << " " << high;
    EXPECT_GE(ticks.back(), high * 0.9999) << low << " " << high;
    EXPECT_GE(ticks.size(), 3u);
    EXPECT_LE(ticks.size(), 9u);
  }
  for (const auto& [low, high] : {std::pair{1.0, 1000.0}, {12.8, 102.4}, {0.02, 0.03}, {5e4, 9e6}}) {
    const std::vector<double> ticks = axis_ticks(low, high, true);
    EXPECT_LE(ticks.front(), low * 1.0001) << low << " " << high;
    EXPECT_GE(ticks.back(), high * 0.9999) << low << " " << high;
    EXPECT_LE(ticks.size(), 10u);
    for (size_t i = 1; i < ticks.size(); ++i) EXPECT_GT(ticks[i], ticks[i - 1]);
  }
}

}  // namespace
}  // namespace pipegs
