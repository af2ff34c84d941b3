// SPDX-License-Identifier: Apache-2.0
// areas_test: the parts of an overflow area of any size: they lie inside it, none over another, and have room for what
// frame_areas says. That the RTL has the same ones is shown by the tests of who writes there.
#include <gtest/gtest.h>

#include "cpp_model/areas/frame_areas.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

struct Part {
  uint64_t first, lines;
};

std::vector<Part> parts(const Config& config, uint64_t size) {
  std::vector<Part> parts;
  const auto add = [&](uint64_t unit, Area area) {
    parts.push_back({area_first(config, size, unit, area), area_lines(config, size, area)});
  };
  if (config.has_lists()) add(0, Area::kLists);
  for (uint64_t unit = 0; unit < static_cast<uint64_t>(config.units); ++unit) {
    for (const Area area : {Area::kKeys, Area::kMerged, Area::kRuns, Area::kRecords}) add(unit, area);
    if (has_alpha_areas(config)) add(unit, Area::kEven);
    if (has_alpha_areas(config) && !config.has_lists()) add(unit, Area::kOdd);
  }
  return parts;
}

std::vector<Config> configs() {
  std::vector<Config> all;
  for (const int units : {1, 2, 4}) {
    for (const char* machine : {"order=0", "order=0 late=1", "order=1", "order=1 late=1", "order=2 late=1"}) {
      all.push_back(config_with(machine));
      all.back().units = units;
    }
  }
  return all;
}

TEST(Areas, LieBesideEachOtherInAnAreaOfAnySize) {
  for (const Config& config : configs()) {
    for (uint64_t i = 0; i < 3000; ++i) {
      const uint64_t size = i < 2000 ? i : (i - 1999) * 0x9e3779b97f4aull % (uint64_t{1} << 33);
      std::vector<Part> all = parts(config, size);
      std::sort(all.begin(), all.end(), [](const Part& a, const Part& b) {
        return a.first != b.first ? a.first < b.first : a.lines < b.lines;
      });
      uint64_t end = 0, sum = 0;
      for (const Part& part : all) {
        if (part.lines == 0) continue;
        ASSERT_GE(part.first, end) << config_difference(config) << ", size " << size;
        end = part.first + part.lines;
        sum += part.lines;
      }
      ASSERT_LE(end, size) << config_difference(config) << ", size " << size;
      if (size % 128 == 0) { ASSERT_EQ(sum, size) << config_difference(config); }  // nothing is left over
    }
  }
}

TEST(Areas, HaveRoomForTheSmallestAndTheLargestScene) {
  constexpr uint64_t kGibibyte = uint64_t{1} << 24;
  for (const Config& config : configs()) {
    for (const uint64_t slots : {0ull, 1ull, 60000ull, 400000ull, 6000000ull, (1ull << 24) - 1}) {
      for (const uint64_t windows : {1ull, 192ull, 2040ull}) {
        const uint64_t size = overflow_area(config, slots, windows), per_unit = kGibibyte / (2 * config.units);
        const auto has = [&](Area area, uint64_t lines) {
          return area_lines(config, size, area) >= std::max<uint64_t>(lines, 16);
        };
        SCOPED_TRACE(config_difference(config) + ", " + std::to_string(slots) + " slots");
        EXPECT_LE(size, 4 * kGibibyte + (config.has_lists() ? 2 * list_first(windows, 0) : 0));
        EXPECT_TRUE(has(Area::kRecords, std::min(slots, per_unit)));
        EXPECT_TRUE(has(Area::kKeys, std::min(slots, per_unit) / 8 + 2) && has(Area::kRuns, slots == 0 ? 0 : 2));
        EXPECT_TRUE(has(Area::kMerged, std::min(slots, per_unit) / 6));
        if (has_alpha_areas(config)) EXPECT_TRUE(has(Area::kEven, std::min(64 * slots, per_unit)));
        if (!config.has_lists()) continue;
        const uint64_t lines = area_lines(config, size, Area::kLists);
        const int log = list_log(config, lines, windows);
        EXPECT_LE(list_first(windows, log), lines);
        EXPECT_TRUE((uint64_t{1} << log) > slots || list_first(windows, log + 1) > 2 * kGibibyte || log == 20);
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
