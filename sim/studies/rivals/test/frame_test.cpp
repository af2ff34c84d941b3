// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/models/phases and traffic: pipelines worked by hand, and traffic at rates that the DRAM
// must and cannot exceed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sim/memory/dram_memory.hpp"
#include "sim/studies/rivals/models/phases.hpp"

namespace pipegs {
namespace {

// A phase of these stages, whose items take no time in memory.
MachineFrame frame_of(const std::vector<UnitStage>& stages, size_t items) {
  PlayedMemory ideal("ideal");
  return run_phases({{"tiles", {}, std::vector<double>(items, 1), stages}}, 1, 1, ideal);
}

// Three items of 2 and 3 cycles: sorting runs beside rasterization, which is the slower one.
TEST(RivalsPipeline, SlowestStageSetsThePace) {
  const MachineFrame frame = frame_of({{"sort", 1, {2, 2, 2}}, {"raster", 1, {3, 3, 3}}}, 3);
  EXPECT_EQ(frame.cycles, 2 + 3 * 3);
  ASSERT_EQ(frame.spans.size(), 2u);
  EXPECT_EQ(frame.spans[0].busy, 6);
  EXPECT_EQ(frame.spans[0].end, 6);
  EXPECT_EQ(frame.spans[1].busy, 9);
  EXPECT_EQ(frame.spans[1].begin, 2);
  EXPECT_EQ(frame.bound, "raster");
}

// Unit 0: 4; unit 1: 1, 1, 5.
TEST(RivalsPipeline, UnitsWorkSideBySide) { EXPECT_EQ(frame_of({{"raster", 2, {4, 1, 1, 5}}}, 4).cycles, 7); }

// The first stage begins item i only when the second has begun item i - 2, of two units item i - 4.
TEST(RivalsPipeline, DoubleBuffersHoldUpTheFirstStage) {
  const std::vector<double> one(8, 1), ten(8, 10);
  const MachineFrame tight = frame_of({{"a", 1, one}, {"b", 1, ten}}, 8),
                     wide = frame_of({{"a", 1, one}, {"b", 2, ten}}, 8);
  EXPECT_EQ(tight.spans[0].end, 51 + 1);
  EXPECT_EQ(tight.cycles, 81);
  EXPECT_EQ(wide.spans[0].end, 12 + 1);
  EXPECT_EQ(wide.cycles, 42);
}

TEST(RivalsPipeline, EmptyFrameAndBadInput) {
  EXPECT_EQ(frame_of({{"a", 1, {}}}, 0).cycles, 0);
  EXPECT_THROW(frame_of({{"a", 0, {}}}, 0), std::invalid_argument);
  EXPECT_THROW(frame_of({{"a", 1, {1, 2}}}, 1), std::invalid_argument);
  EXPECT_THROW(frame_of({{"a", 1, {-1}}}, 1), std::invalid_argument);
}

const std::string kDram = "lpddr5-6400x4";

double gbps(const Traffic& traffic) { return traffic.bytes / traffic.cycles; }  // at 1 GHz

TEST(RivalsTraffic, TablesRunAtTheRateOfThePinsAndNeverAbove) {
  const double peak = dram_memory_timing(kDram).peak_gbps();
  const Traffic read = play_traffic({{.kind = "scene", .bytes = 20e6}}, kDram, 1.0);
  EXPECT_GT(gbps(read), 0.85 * peak);
  EXPECT_LE(gbps(read), peak);
  EXPECT_GT(read.row_hits, 0.9);
}

TEST(RivalsTraffic, ScatteredLinesAreSlowerThanATableAndLongRunsAreNot) {
  const Flow table{.kind = "a", .bytes = 8e6};
  const Flow lines{.kind = "a", .bytes = 8e6, .run = 64, .table = 1e8};
  const Flow runs{.kind = "a", .bytes = 8e6, .run = 4096, .table = 1e8};
  const double whole = gbps(play_traffic({table}, kDram, 1.0));
  EXPECT_LT(gbps(play_traffic({lines}, kDram, 1.0)), 0.8 * whole);
  EXPECT_GT(gbps(play_traffic({runs}, kDram, 1.0)), 0.8 * whole);
}

TEST(RivalsTraffic, RunsMoveWholeLines) {
  EXPECT_EQ(play_traffic({{.kind = "record", .bytes = 236 * 1000, .run = 236}}, kDram, 1.0).bytes, 256 * 1000);
  EXPECT_EQ(pin_bytes({.kind = "record", .bytes = 236 * 1000, .run = 236}), 256 * 1000);
  EXPECT_EQ(play_traffic({{.kind = "none"}}, kDram, 1.0).cycles, 0);
}

TEST(RivalsTraffic, AnIdealMemoryTakesNoTime) {
  const Traffic traffic = play_traffic({{.kind = "scene", .bytes = 640}}, "ideal", 1.0);
  EXPECT_EQ(traffic.cycles, 0);
  EXPECT_EQ(traffic.bytes, 640);
}

TEST(RivalsTraffic, LongPhasesScaleByTheirBytes) {
  const double lines = static_cast<double>(kPlayedLines);
  const Traffic played = play_traffic({{.kind = "a", .bytes = lines * 64}}, kDram, 1.0);
  const Traffic scaled = play_traffic({{.kind = "a", .bytes = 10 * lines * 64}}, kDram, 1.0);
  EXPECT_NEAR(scaled.cycles / played.cycles, 10, 1e-9);
}

TEST(RivalsTraffic, BadInput) {
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(play_traffic({{.kind = "a", .bytes = bad}}, kDram, 1.0), std::invalid_argument);
  EXPECT_THROW(play_traffic({}, "none such", 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace pipegs
