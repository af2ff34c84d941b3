// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/pipelines and sim/report/pipelines: rows, bars and heights worked by hand, and the
// picture.
#include "sim/studies/rivals/pipelines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verif/cli/well_formed.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Two phases at 0.5 GHz; the second one's unit has four of a kind that work 300 of 4 x 100 cycles.
TEST(RivalsPipelines, ARowForEachUnitAndABarForEachPhase) {
  MachineFrame frame{.ghz = 0.5, .cycles = 3000};
  frame.spans = {{"first", "memory", 1, 0, 1000, 500},
                 {"second", "memory", 1, 1000, 3000, 2000},
                 {"second", "VRU", 4, 1000, 1100, 300}};
  const MachinePipeline pipeline = machine_pipeline("one", "", frame);
  EXPECT_DOUBLE_EQ(pipeline.end, 6);
  ASSERT_EQ(pipeline.rows.size(), 2u);
  EXPECT_EQ(pipeline.rows[0].unit, "memory");
  ASSERT_EQ(pipeline.rows[0].bars.size(), 2u);
  EXPECT_DOUBLE_EQ(pipeline.rows[0].bars[0].share, 0.5);
  EXPECT_DOUBLE_EQ(pipeline.rows[0].bars[1].begin, 2);
  EXPECT_DOUBLE_EQ(pipeline.rows[1].bars[0].share, 0.75);
  EXPECT_DOUBLE_EQ(pipeline.rows[1].bars[0].end, 2.2);
}

FrameCounts corner() { return count_frame(scene_of({gaussian_at({0, 0, 1}, 0.01f, 0.8)}), test_camera(64, 64), {}); }

// One Gaussian in four tiles: without subtiles all 4 x 256 pixels are rasterized, 64 in a cycle over the cores.
TEST(RivalsPipelines, AGpuDoesOneThingAfterTheOther) {
  const FrameCounts counts = corner();
  PlayedMemory memory("ideal");
  const MachineFrame frame = gpu_order(counts, memory);
  EXPECT_DOUBLE_EQ(frame.busy("VRU"), 4 * 256.0 / 16);
  EXPECT_DOUBLE_EQ(frame.busy("BSU"), 4);  // a chunk for each list
  double sorted = 0, raster = INFINITY;
  for (const StageSpan& span : frame.spans) {
    if (span.unit == "BSU") sorted = span.end;
    if (span.unit == "VRU") raster = span.begin;
  }
  EXPECT_GE(raster, sorted);
}

TEST(RivalsPipelines, ThePictureHasARowForEachUnitAndATooltipForEachBarOfAModel) {
  const FrameCounts counts = corner();
  PlayedMemory memory("lpddr5-6400x4");
  const std::vector<MachinePipeline> machines = rival_pipelines(counts, memory);
  ASSERT_EQ(machines.size(), 3u);
  size_t bars = 0;
  for (const MachinePipeline& machine : machines) {
    EXPECT_GT(machine.end, 0) << machine.machine;
    for (const PipelineRow& row : machine.rows) {
      for (const PipelineBar& bar : row.bars) {
        EXPECT_GE(bar.begin, 0);
        EXPECT_LE(bar.end, machine.end * (1 + 1e-12));
        EXPECT_LE(bar.share, 1 + 1e-12);
        bars += bar.share > 0;
      }
    }
  }
  const std::string svg = pipelines_svg("a < b", machines);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(count(svg, "<title>"), bars);
  EXPECT_EQ(xml_fault(pipelines_svg("none", {})), "");
}

}  // namespace
}  // namespace pipegs
