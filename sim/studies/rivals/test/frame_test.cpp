// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/frame: pipelines worked by hand, and traffic at rates that the DRAM must and cannot
// exceed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sim/memory/dram_memory.hpp"
#include "sim/studies/rivals/frame/pipeline.hpp"
#include "sim/studies/rivals/frame/traffic.hpp"

namespace pipegs {
namespace {

const PipelineSpan& span_of(const PipelineRun& run, size_t item, size_t stage) {
  return *std::find_if(run.spans.begin(), run.spans.end(),
                       [&](const PipelineSpan& span) { return span.item == item && span.stage == stage; });
}

// Three items of 2 and 3 cycles: sorting runs beside rasterization, which is the slower one.
TEST(RivalsPipeline, SlowestStageSetsThePace) {
  const PipelineRun run = run_pipeline({{.name = "sort"}, {.name = "raster"}}, {{2, 3}, {2, 3}, {2, 3}});
  EXPECT_EQ(run.cycles, 2 + 3 * 3);
  EXPECT_EQ(run.busy, (std::vector<double>{6, 9}));
  EXPECT_EQ(span_of(run, 1, 0).begin, 2);
  EXPECT_EQ(span_of(run, 2, 1).begin, 8);
}

TEST(RivalsPipeline, UnitsWorkSideBySide) {
  const PipelineRun run = run_pipeline({{.name = "raster", .units = 2}}, {{4}, {1}, {1}, {5}});
  // Unit 0: 4; unit 1: 1, 1, 5.
  EXPECT_EQ(run.cycles, 7);
  EXPECT_EQ(span_of(run, 3, 0).unit, 1u);
}

// With room for one item the first stage may begin item i only when the second has begun item i - 1.
TEST(RivalsPipeline, RoomBetweenStagesHoldsUpTheFirst) {
  const std::vector<std::vector<double>> items(4, {1, 10});
  const PipelineRun free = run_pipeline({{.name = "a"}, {.name = "b"}}, items);
  const PipelineRun tight = run_pipeline({{.name = "a", .ahead = 1}, {.name = "b"}}, items);
  EXPECT_EQ(span_of(free, 3, 0).begin, 3);
  EXPECT_EQ(span_of(tight, 3, 0).begin, 21);
  EXPECT_EQ(free.cycles, 41);
  EXPECT_EQ(tight.cycles, 41);
}

TEST(RivalsPipeline, EmptyFrameAndBadInput) {
  EXPECT_EQ(run_pipeline({{.name = "a"}}, {}).cycles, 0);
  EXPECT_THROW(run_pipeline({{.name = "a", .units = 0}}, {}), std::invalid_argument);
  EXPECT_THROW(run_pipeline({{.name = "a"}}, {{1, 2}}), std::invalid_argument);
  EXPECT_THROW(run_pipeline({{.name = "a"}}, {{-1}}), std::invalid_argument);
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
