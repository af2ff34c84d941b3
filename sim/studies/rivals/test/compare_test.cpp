// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/compare: on a real view more of anything is never slower, ranges hold what they span, and
// what is multiplied of published figures.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/studies/rivals/compare/report.hpp"
#include "sim/studies/rivals/test/by_hand.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

const std::string kDram = "lpddr5-6400x4";

const FrameCounts& view() {
  static const FrameCounts counts =
      count_frame(random_scene(3, 2000, 0), test_camera(200, 150, 120), {.voxels = {1, 0.5, 0.25}});
  return counts;
}

TEST(RivalCompare, MoreUnitsAreNeverSlower) {
  PlayedMemory memory(kDram);
  for (const Rival* rival : all_rivals()) {
    SCOPED_TRACE(rival->name);
    const double cycles = frame_of(*rival, view(), memory).cycles;
    for (const Parameter& one : rival->parameters) {
      if (!one.name.ends_with("rate") && one.name != "lanes" && one.name != "splitters") continue;
      EXPECT_LE(frame_of(*rival, view(), memory, {{one.name, 2 * one.value}}).cycles, cycles) << one.name;
    }
    for (const char* bytes : {"record_bytes", "fetch_bytes", "key_bytes", "passes"}) {
      if (!values_of(*rival).contains(bytes)) continue;
      const double more = 2 * value(values_of(*rival), bytes);
      EXPECT_GE(frame_of(*rival, view(), memory, {{bytes, more}}).cycles, cycles * (1 - 1e-9)) << bytes;
    }
  }
}

TEST(RivalCompare, MemoryWithoutTimeIsNeverSlowerAndAFrameHoldsItsBounds) {
  PlayedMemory memory(kDram), ideal("ideal");
  for (const Rival* rival : all_rivals()) {
    SCOPED_TRACE(rival->name);
    const MachineFrame frame = frame_of(*rival, view(), memory), free = frame_of(*rival, view(), ideal);
    EXPECT_LT(free.cycles, frame.cycles);
    EXPECT_EQ(free.all_bytes(), frame.all_bytes());
    EXPECT_GE(frame.cycles, frame.memory_cycles * (1 - 1e-9));
    double end = 0;
    for (const StageSpan& span : frame.spans) {
      EXPECT_LE(span.busy, span.units * (span.end - span.begin) * (1 + 1e-9)) << span.unit;
      end = std::max(end, span.end);
    }
    EXPECT_NEAR(end, frame.cycles, 1e-6 * frame.cycles);
  }
}

TEST(RivalCompare, RangesHoldTheirMidsAndEveryEndAlone) {
  PlayedMemory memory(kDram);
  for (const Rival* rival : all_rivals()) {
    SCOPED_TRACE(rival->name);
    const RivalResult result = rival_result(*rival, view(), memory);
    for (const Range& range : {result.figures.fps, result.figures.fps_mm2, result.figures.frames_j,
                               result.figures.frames_j_dram, result.mm2}) {
      EXPECT_GT(range.low, 0);
      EXPECT_LE(range.low, range.mid);
      EXPECT_LE(range.mid, range.high);
    }
    EXPECT_DOUBLE_EQ(result.figures.fps.mid, result.frame.fps());
    EXPECT_DOUBLE_EQ(result.figures.fps_mm2.mid, result.frame.fps() / result.mm2.mid);
    EXPECT_LT(result.figures.frames_j_dram.mid, result.figures.frames_j.mid);
    for (const Swing& swing : result.swings) {
      EXPECT_GE(std::min(swing.fps_low, swing.fps_high), result.figures.fps.low) << swing.parameter->name;
      EXPECT_LE(std::max(swing.fps_low, swing.fps_high), result.figures.fps.high) << swing.parameter->name;
    }
  }
}

// A pass of the sort less cannot be slower, and the swing says so by the frames themselves.
TEST(RivalCompare, ASwingIsTheFrameWithThatEnd) {
  PlayedMemory memory(kDram);
  const RivalResult result = rival_result(gscore(), view(), memory);
  for (const Swing& swing : result.swings) {
    if (swing.parameter->name != "passes") continue;
    EXPECT_DOUBLE_EQ(swing.fps_low, frame_of(gscore(), view(), memory, {{"passes", 0}}).fps());
    EXPECT_DOUBLE_EQ(swing.fps_high, frame_of(gscore(), view(), memory, {{"passes", 3}}).fps());
    EXPECT_GT(swing.fps_low, swing.fps_high);
    return;
  }
  FAIL() << "passes have no range";
}

TEST(RivalCompare, PublishedRatiosMultiplied) {
  EXPECT_NEAR(chained(gscore()).area, 2.85 * 3.95 / 3.283, 1e-9);
  EXPECT_NEAR(chained(gscore()).energy, 2.77, 1e-9);
  EXPECT_NEAR(chained(streaminggs()).energy, 1.2043, 1e-4);
  EXPECT_NEAR(chained(streaminggs()).area, 2.85 / 2.1 * 5.37 * 49 / 64 / 3.283, 1e-9);
  EXPECT_EQ(chained(gsacc()).area, 0);
}

TEST(RivalCompare, RatiosOfRanges) {
  const Range over = ratio({1, 2, 4}, {5, 10, 20});
  EXPECT_DOUBLE_EQ(over.low, 1.0 / 20);
  EXPECT_DOUBLE_EQ(over.mid, 0.2);
  EXPECT_DOUBLE_EQ(over.high, 4.0 / 5);
}

TEST(RivalCompare, AFigurePassesWithinFifteenPercent) {
  const auto passes = [](double ours, bool at_most) { return Check{"", "", "", 2, ours, "", at_most}.passes(); };
  EXPECT_TRUE(passes(2.29, false));
  EXPECT_TRUE(passes(1.71, false));
  EXPECT_FALSE(passes(2.31, false));
  EXPECT_FALSE(passes(1.69, false));
  EXPECT_TRUE(passes(1, true));
  EXPECT_FALSE((Check{.published = 2, .ours = 2, .chosen = true}.passes()));
  EXPECT_FALSE(passes(2.31, true));
}

// The two tiles of models_test.cpp, without the time of memory.
TEST(RivalCompare, ChecksAreRatiosOfFrames) {
  PlayedMemory ideal("ideal");
  const std::vector<Check> checks = checks_of(two_tiles(), ideal);
  const auto ours = [&](const std::string& figure) {
    for (const Check& check : checks) {
      if (check.figure == figure) return check.ours;
    }
    ADD_FAILURE() << figure;
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(ours("speed by the oriented box"), (250.0 + 40 + 4 + 960) / (250 + 20 + 2 + 480));
  EXPECT_DOUBLE_EQ(ours("speed by subtiles"), (250.0 + 20 + 2 + 480) / 552);
  EXPECT_DOUBLE_EQ(ours("speed over oriented boxes without subtiles, same lanes"), 752 / 830.5);
  EXPECT_DOUBLE_EQ(ours("speed without its filters"), 277.0 / 487);
  EXPECT_DOUBLE_EQ(ours("speed over GSCore of 16 cores"), (1000.0 / 16 + 302) / 162);
  EXPECT_DOUBLE_EQ(ours("tiles that neighbours in order share"), 10);
  EXPECT_DOUBLE_EQ(ours("Gaussians that the coarse filter drops"), 77.5);
}

TEST(RivalCompare, LegoTakesAtLeastItsBytesAtTheRateOfThePins) {
  PlayedMemory memory(kDram);
  EXPECT_GT(lego_least_cycles(memory), 114.4e6 / 51.2);
  EXPECT_LT(lego_least_cycles(memory), kLegoCycles);
}

TEST(RivalCompare, TablesAndJsonHaveEveryMachine) {
  PlayedMemory memory(kDram);
  const OwnMachine own{.name = "ours",
                       .cycles = 1000,
                       .bytes = 64,
                       .mm2 = {1, 2, 3},
                       .figures = {{1, 1, 1}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  const Comparison comparison = compare(view(), memory, {own});
  const std::string text = tables_text(comparison_tables(comparison));
  const nlohmann::ordered_json json = comparison_json(comparison);
  for (const Rival* rival : all_rivals()) {
    EXPECT_NE(text.find("\n  " + rival->name), std::string::npos) << rival->name;
    const auto& row = json["rivals"].at(rival->key);
    EXPECT_EQ(row["parameters"].size(), rival->parameters.size());
    EXPECT_GT(row["fps"]["mid"], 0);
    EXPECT_TRUE(json["against"]["over"][rival->key].contains("ours"));
  }
  // Packed as ours they move what they read of Gaussians less, and nothing else.
  for (const char* key : {"gscore", "gs_tg", "flicker", "neo"}) {
    SCOPED_TRACE(key);
    const auto packed = std::find_if(json["variants"].begin(), json["variants"].end(),
                                     [&](const auto& one) { return one["rival"] == key && one["key"] == "packed"; });
    ASSERT_NE(packed, json["variants"].end());
    const auto& as_published = json["rivals"][key];
    const double before = as_published["parameters"]["record_bytes"]["value"],
                 records = as_published["bytes_by_kind"]["records"];
    EXPECT_LT((*packed)["bytes_by_kind"]["records"], records);
    EXPECT_NEAR((*packed)["bytes_by_kind"]["records"], records * kOwnRecordBytes / before, 0.03 * records);
    for (const auto& [kind, bytes] : as_published["bytes_by_kind"].items()) {
      if (kind != "records") EXPECT_EQ((*packed)["bytes_by_kind"][kind], bytes) << kind;
    }
    EXPECT_GT((*packed)["frames_per_joule_with_dram"], as_published["frames_per_joule_with_dram"]["mid"]);
  }
  EXPECT_EQ(json["ours"]["ours"]["mm2"]["mid"], 2);
  EXPECT_EQ(json["checks"].size(), comparison.checks.size());
  EXPECT_EQ(comparison_charts(comparison).front().categories.size(), all_rivals().size() + 1);
}

}  // namespace
}  // namespace pipegs
