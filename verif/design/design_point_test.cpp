// SPDX-License-Identifier: Apache-2.0
// Against sim/design/design_point and its table: legal machines, told apart by their settings, named alike everywhere.
#include "sim/design/design_point.hpp"

#include <gtest/gtest.h>

#include <map>

namespace pipegs {
namespace {

Config changed(std::string_view design_point, const std::vector<std::string>& settings) {
  Config config = find_design_point(design_point).config;
  for (const std::string& setting : settings) config_set(config, setting);
  return config;
}

// Each point's settings as they stand in the table.
std::map<std::string_view, std::string> written() {
  std::map<std::string_view, std::string> texts;
  std::string* text = nullptr;
  const auto add = [&](const std::string& setting) { *text += (text->empty() ? "" : ",") + setting; };
#define PIPEGS_POINT(name, in_paper, speedup, ratio, what) text = &texts[#name];
#define PIPEGS_SETTING(entry, value) add(#entry "=" #value);
#define PIPEGS_PICTURE(entry, value) add(#entry "=" #value);
#define PIPEGS_END(name)
#include "sim/design/design_points.def"
#undef PIPEGS_POINT
#undef PIPEGS_SETTING
#undef PIPEGS_PICTURE
#undef PIPEGS_END
  return texts;
}

TEST(DesignPoints, AreLegalAndKnownByTheirSettings) {
  for (const DesignPoint& point : design_points()) {
    EXPECT_NO_THROW(config_check(point.config)) << point.name;
    for (const ConfigEntry& entry : config_entries(point.config)) {
      if (entry.member == nullptr) continue;
      EXPECT_GE(entry.value, entry.low) << point.name << ": " << entry.name;
      EXPECT_LE(entry.value, entry.high) << point.name << ": " << entry.name;
    }
    EXPECT_EQ(design_point_name(point.config), point.name);
    EXPECT_EQ(&find_design_point(point.name), &point);
  }
  EXPECT_EQ(find_design_point("dop").config, Config{});
  EXPECT_NO_THROW(find_design_point(kDefaultDesignPoint));
}

TEST(DesignPoints, ABusHasAWidthOfAxiOrIsAbsent) {
  for (int width = 0; width <= 512; ++width) {
    Config config;
    config.bus_w = width;
    std::string error;
    try {
      config_check(config);
    } catch (const ConfigError& found) { error = found.what(); }
    const bool legal = width == 0 || width == 128 || width == 256 || width == 512;
    EXPECT_EQ(error, legal ? "" : "configuration: bus_w = " + std::to_string(width) + ", expected 0, 128, 256 or 512");
  }
}

TEST(DesignPoints, BadNamesAreRefused) {
  EXPECT_THROW(find_design_point("nonsense"), ConfigError);
  EXPECT_THROW(find_design_point(""), ConfigError);
  EXPECT_THROW(find_design_points({"dop", "dop"}), ConfigError);
  EXPECT_EQ(find_design_points({}).size(), design_points().size());
}

// CMake puts a machine into the folder that is named as the table writes it, the program looks for it in the folder
// that is named by config_difference().
TEST(DesignPoints, TheTableIsWrittenAsFoldersAreNamed) {
  const std::map<std::string_view, std::string> texts = written();
  ASSERT_EQ(texts.size(), design_points().size());
  for (const DesignPoint& point : design_points()) {
    const std::string& text = texts.at(point.name);
    EXPECT_EQ(text.empty() ? "default" : text, config_difference(point.config));
  }
}

// `exact` and `fast` compute the same things in the same places; every other pair differs in that.
TEST(DesignPoints, AChangedConfigurationBelongsToTheNearest) {
  EXPECT_EQ(design_point_name(changed("fast", {"records=1024"})), "fast");
  EXPECT_EQ(design_point_name(changed("fast", {"units=2", "alpha_w=12", "window=64"})), "fast");
  EXPECT_EQ(design_point_name(changed("exact", {"records=1024"})), "exact");
  EXPECT_EQ(design_point_name(changed("exact", {"pos_w=18", "base_w=14", "mantissa_w=22", "coeff_f=24", "alpha_w=10"})),
            "exact");
  EXPECT_EQ(design_point_name(changed("dop", {"alpha_w=10", "records=1536", "bucket_bits=6"})), "dop");
  EXPECT_EQ(design_point_name(changed("late", {"quadratic=1"})), "");
}

TEST(DesignPoints, WideIsFastWithTwiceTheUnits) {
  EXPECT_EQ(changed("fast", {"units=8", "records=704"}), find_design_point("wide").config);
}

TEST(DesignPoints, OnlyWhatChangesPixelsMakesAnotherPicture) {
  const auto same = [](std::string_view one, std::string_view other) {
    return find_design_point(one).picture == find_design_point(other).picture;
  };
  for (const auto& [one, other] : {std::pair{"dop", "late"}, {"baseline", "dpc"}, {"dpc", "tspp"}, {"fast", "wide"}})
    EXPECT_TRUE(same(one, other)) << one << ", " << other;
  for (const auto& [one, other] :
       {std::pair{"dop", "tspp"}, {"exact", "late"}, {"fast", "exact"}, {"gscore", "baseline"}})
    EXPECT_FALSE(same(one, other)) << one << ", " << other;
}

}  // namespace
}  // namespace pipegs
