// SPDX-License-Identifier: Apache-2.0
// page_parts_test: what a page is put together from: charts, codes of maps, text that ends no element, sentences on a
// frame.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/design/design_point.hpp"
#include "sim/report/chart.hpp"
#include "sim/report/html/document.hpp"
#include "sim/report/html/frame/frame_page.hpp"
#include "sim/report/html/frame/pixel_map.hpp"
#include "sim/report/html/study_page.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(Chart, WhatIsNotFiniteLeavesAGap) {
  const Json json = charts_json({{.name = "one", .categories = {"a", "b"}, .series = {{"s", {1, kNone}}}}})[0];
  EXPECT_EQ(json["name"], "one");
  EXPECT_EQ(json["series"][0]["values"], Json({1.0, nullptr}));
}

TEST(Chart, CountsThatDoNotFitAreRefused) {
  using Form = Chart::Form;
  EXPECT_THROW(charts_json({{.form = Form::kBars, .categories = {"a"}, .series = {{"s", {}}}}}), std::invalid_argument);
  EXPECT_THROW(charts_json({{.form = Form::kHistogram, .x = {1}, .series = {{"s", {1}}}}}), std::invalid_argument);
  EXPECT_THROW(charts_json({{.form = Form::kLines, .categories = {"a"}, .x = {1, 2}, .series = {{"s", {1, 2}}}}}),
               std::invalid_argument);
  EXPECT_THROW(charts_json({{.form = Form::kScatter, .series = {{.name = "s", .values = {1}, .x = {1}}}}}),
               std::invalid_argument);
}

TEST(Chart, HistogramCountsEveryFiniteValueOnce) {
  const Chart chart = histogram("h", "h", "x", {1, 2, 3, 4, 100, kNone}, 5);
  double sum = 0;
  for (const double value : chart.series[0].values) sum += value;
  EXPECT_EQ(sum, 5);
  EXPECT_EQ(chart.series[0].values.back(), 1);  // the largest lies in the last bin
  const Chart by_ratio = histogram("h", "h", "x", {0, 1, 10, 100, 1000}, 3, true);
  EXPECT_NEAR(by_ratio.x[1] / by_ratio.x[0], 10, 1e-9);
  for (const std::vector<double>& odd : {std::vector<double>{}, {7, 7, kNone}})
    EXPECT_EQ(charts_json({histogram("h", "h", "x", odd, 10, true)})[0]["series"][0]["values"].size(), 10u);
}

TEST(PixelMap, LogarithmicCodesAreAtMostHalfAStepOff) {
  PixelMap map{.name = "errors", .width = 1, .height = 1, .logarithmic = true, .low = 0x1p-16, .steps = 6};
  for (double value = 0x1p-16; value <= 1; value *= 1.013) map.values.push_back(value);
  const std::vector<uint16_t> codes = codes_of(map);
  ASSERT_EQ(codes.size(), map.values.size());
  for (size_t i = 0; i < codes.size(); ++i) {
    const double shown = map.low * std::exp2((codes[i] - 1) / map.steps);
    EXPECT_LE(std::abs(std::log2(shown / map.values[i])), 0.5 / map.steps + 1e-12) << map.values[i];
    EXPECT_LT(codes[i], 256);
  }
  map.values = {0, 0x1p-17, 1e-300};
  EXPECT_EQ(codes_of(map), (std::vector<uint16_t>{0, 0, 0}));
}

TEST(PixelMap, AValueBeyondTheCodesIsRefused) {
  for (const double value : {65536.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const PixelMap map{.name = "counts", .width = 1, .height = 1, .values = {value}};
    EXPECT_THROW(codes_of(map), std::range_error) << value;
  }
}

TEST(HtmlDocument, NoStringEndsItsElement) {
  HtmlDocument page("frame", "</script><script>alert(1)</script>", "pipegs sim '<!--'");
  page.data["name"] = std::string("\xff broken </script>");
  const std::string text = page.text("<p>before</p><!--data--><p>after</p>");
  EXPECT_TRUE(text.starts_with("<p>before</p>"));
  EXPECT_TRUE(text.ends_with("<p>after</p>"));
  EXPECT_EQ(text.find("</script><script>"), std::string::npos);
  EXPECT_EQ(text.find("<!--"), std::string::npos);
  const size_t begin = text.find("id=\"data\">") + 10, end = text.find("</script>");
  const Json data = Json::parse(text.substr(begin, end - begin));
  EXPECT_EQ(data["title"], "</script><script>alert(1)</script>");
}

TEST(HtmlDocument, APlaneHasItsCountOfNumbers) {
  HtmlDocument page("frame", "a", "b");
  EXPECT_NO_THROW(page.add_plane("a", 3, 2, 1, std::vector<uint8_t>(6)));
  EXPECT_NO_THROW(page.add_plane("b", 3, 2, std::vector<uint16_t>(6, 65535)));
  EXPECT_THROW(page.add_plane("c", 3, 2, 3, std::vector<uint8_t>(6)), std::invalid_argument);
  EXPECT_THROW(page.add_plane("d", 0, 2, 1, std::vector<uint8_t>()), std::invalid_argument);
  EXPECT_THROW(
      page.add_plane("e", HtmlDocument::kLongestSide + 1, 1, 1, std::vector<uint8_t>(HtmlDocument::kLongestSide + 1)),
      std::invalid_argument);
}

TEST(HtmlDocument, ATemplateWithoutAPlaceIsRefused) {
  EXPECT_THROW(HtmlDocument("frame", "a", "b").text("<p></p>"), std::invalid_argument);
}

Json units(int count, int busy, int starved, int blocked, int memory) {
  return Json(static_cast<size_t>(count),
              Json{{"busy", busy}, {"starved", starved}, {"blocked", blocked}, {"memory", memory}});
}

Json report(double cycles_over_largest) {
  return {{"ran", {{"rtl", true}}},
          {"cycles", 1000},
          {"units",
           {{"dopu", units(1, 300, 0, 700, 0)},
            {"pu", units(4, 500, 100, 400, 0)},
            {"su", units(4, 200, 10, 790, 0)},
            {"ru", units(4, 950, 30, 0, 20)}}},
          {"bounds", {{"largest", "RU"}, {"cycles_over_largest", cycles_over_largest}}}};
}

TEST(Sentences, SayWhatBoundsTheFrame) {
  const Json near = frame_sentences(report(1.1)), far = frame_sentences(report(2));
  EXPECT_NE(near["frame"].get<std::string>().find("909 cycles of blending in the RUs: 90.9 %"), std::string::npos)
      << near["frame"];
  EXPECT_NE(near["frame"].get<std::string>().find("That bounds the frame"), std::string::npos);
  EXPECT_NE(far["frame"].get<std::string>().find("The units that work most are the RUs, 95.0 %"), std::string::npos)
      << far["frame"];
  const auto pu = near["units"]["pu"].get<std::string>(), ru = near["units"]["ru"].get<std::string>();
  EXPECT_NE(pu.find("The 4 PUs work in 50.0 % of the cycles"), std::string::npos) << pu;
  EXPECT_NE(pu.find("They wait 10.0 % for Gaussians and 40.0 % until"), std::string::npos) << pu;
  EXPECT_NE(ru.find("They wait 3.0 % for sorted records"), std::string::npos) << ru;
  EXPECT_EQ(ru.find("external memory"), std::string::npos) << ru;  // 2 % are not worth a word
}

TEST(Sentences, AnEmptyViewHasNoBound) {
  Json empty = report(1);
  empty["bounds"]["largest"] = nullptr;
  EXPECT_NE(frame_sentences(empty)["frame"].get<std::string>().find("no work"), std::string::npos);
}

TEST(StudyPage, ItsJsonHoldsNoInfinityAndEndsNoElement) {
  StudyPage page("</script>", "pipegs <x>", "v");
  const double inf = std::numeric_limits<double>::infinity();
  page.charts({{.form = Chart::Form::kScatter,
                .title = "t",
                .series = {{.name = "s", .values = {1, inf}, .x = {std::nan(""), 2}, .labels = {"a", "b"}}}}});
  page.table({.title = "",
              .columns = {{.heading = "a", .word = true}, {.heading = "empty"}, {.heading = "b"}},
              .rows = {{{.text = "x"}, {.text = ""}, {.text = "1", .value = 1}}}});
  const std::string html = page.text("<!--data-->");
  EXPECT_EQ(html.find("</script>"), html.rfind("</script>")) << "one element, ended once";
  const size_t from = html.find('{');
  const auto section = nlohmann::json::parse(html.substr(from, html.find("</script>") - from))["sections"][0];
  EXPECT_EQ(section["charts"][0]["series"][0]["values"].dump(), "[1.0,null]");
  EXPECT_EQ(section["charts"][0]["series"][0]["x"].dump(), "[null,2.0]");
  EXPECT_EQ(section["tables"][0]["columns"].size(), 2u) << "an empty column is left out";
  EXPECT_EQ(section["tables"][0]["rows"][0][1]["value"], 1.0);
}

TEST(StudyPage, MachinesAreSettingsForAnyCommand) {
  EXPECT_EQ(machine_words(find_design_point("fast").config), "--design fast");
  EXPECT_EQ(machine_words(Config{}), "--design dop");
  Config config = find_design_point("exact").config;
  config.units = 2, config.alpha_w = 11;
  EXPECT_EQ(machine_words(config), "--design exact --set units=2 --set alpha_w=11");
}

TEST(Document, Base64) {
  EXPECT_EQ(base64("pleasure."), "cGxlYXN1cmUu");
  EXPECT_EQ(base64("pleasure"), "cGxlYXN1cmU=");
  EXPECT_EQ(base64("pleasur"), "cGxlYXN1cg==");
}

}  // namespace
}  // namespace pipegs
