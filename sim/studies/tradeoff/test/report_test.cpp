// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/tradeoff/report: time is cycles over the clock, and a decibel's price is that of its leg.
#include "sim/studies/tradeoff/report.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace pipegs {
namespace {

std::vector<TradeoffPoint> points() {
  std::vector<TradeoffPoint> points;
  for (const auto& [label, cycles, psnr] : {std::tuple{"all", 1000000, 70.0},
                                            {"a", 800000, 52.0},
                                            {"b", 900000, 49.0},
                                            {"c", 600000, 42.0},
                                            {"d", 590000, 41.0},
                                            {"e", 100000, 20.0}}) {
    TradeoffPoint point;
    point.way = {.knob = "T cut", .label = label};
    point.cycles = static_cast<uint64_t>(cycles), point.psnr = psnr, point.ssim = 0.9;
    points.push_back(point);
  }
  find_front(points);
  return points;
}

TEST(TradeoffReport, ADecibelCostsWhatItsLegCosts) {
  const std::vector<TradeoffPoint> all = points();
  for (const double ghz : {1.0, 0.5}) {
    const std::vector<Leg> legs = price(all, ghz);
    ASSERT_EQ(legs.size(), 2u) << "nothing faster has 30 dB";
    EXPECT_EQ(legs[0].from->way.label, "all");
    EXPECT_EQ(legs[0].to->way.label, "a");
    EXPECT_DOUBLE_EQ(legs[0].us, 200 / ghz);
    EXPECT_DOUBLE_EQ(legs[0].us_per_db, 200 / ghz / 18);
    EXPECT_EQ(legs[1].to->way.label, "d");
    EXPECT_DOUBLE_EQ(legs[1].us_per_db, 210 / ghz / 11);
  }
  EXPECT_TRUE(price({}, 1).empty());
  std::vector<TradeoffPoint> exact = all;
  exact[0].psnr = std::numeric_limits<double>::infinity();
  find_front(exact);
  EXPECT_TRUE(price(exact, 1).empty()) << "of an exact picture a decibel has no price";
}

TEST(TradeoffReport, TextJsonAndChartTellTheSameTime) {
  const std::vector<TradeoffPoint> all = points();
  const auto json = to_json(all, 0.8);
  EXPECT_DOUBLE_EQ(json[1]["us"].get<double>(), 1000);
  EXPECT_EQ(json[1]["front"], 2);
  EXPECT_TRUE(json[2]["front"].is_null()) << "a is faster and closer than b";
  const std::string text = table_text(to_table(all, 0.8));
  EXPECT_NE(text.find("T cut a    1000.0       80.0 "), std::string::npos) << text;
  EXPECT_NE(text.find("at 0.8 GHz"), std::string::npos) << text;
  EXPECT_NE(text.find("from 70.0 to 52.0 dB, front 1 to 2: 250.0 us, 13.9 us a decibel"), std::string::npos) << text;
  const Chart chart = tradeoff_chart("title", all, 0.8);
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[0].x[1], 1000);
  EXPECT_EQ(chart.series[1].labels, (std::vector<std::string>{"1", "2", "3", "4", "5"}));
  EXPECT_NO_THROW(charts_json({chart}));  // counts fit each other
}

}  // namespace
}  // namespace pipegs
