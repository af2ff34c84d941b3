// SPDX-License-Identifier: Apache-2.0
// page_parts_test: what a page is put together from: codes of maps, text that ends no element, sentences on a frame.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/report/html/frame/frame_page.hpp"
#include "sim/report/html/frame/pixel_map.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace
}  // namespace pipegs
