// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/models: a frame of each worked by hand, without memory's time, and what each moves.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/studies/rivals/models/rival.hpp"
#include "sim/studies/rivals/test/by_hand.hpp"

namespace pipegs {
namespace {

MachineFrame ideal_frame(const Rival& rival, const Values& changed = {}, const FrameCounts& counts = two_tiles()) {
  PlayedMemory memory("ideal");
  return frame_of(rival, counts, memory, changed);
}

const StageSpan& span_of(const MachineFrame& frame, const std::string& unit) {
  for (const StageSpan& span : frame.spans) {
    if (span.unit == unit) return span;
  }
  throw std::invalid_argument(unit);
}

// Preprocessing: 64 blocks of 15.625 Gaussians on 4 CCUs, 16 rounds. The first tile's list of 40 is split once (128 >=
// 40) at 2 keys a cycle, of its 30 open pairs two chunks are sorted, its 70 subtiles of 64 px take 4 cycles each. The
// second tile has another core: nothing to split, one chunk, 16 subtiles.
TEST(RivalModels, GscoreByHand) {
  const MachineFrame frame = ideal_frame(gscore());
  EXPECT_EQ(frame.cycles, 1000 / 4 + 40 / 2 + 2 + 70 * 4);
  EXPECT_EQ(frame.busy("CCU"), 1000);
  EXPECT_EQ(frame.busy("QSU"), 20);
  EXPECT_EQ(frame.busy("BSU"), 2 + 1);
  EXPECT_EQ(frame.busy("VRU"), (70 + 16) * 4);
  EXPECT_EQ(span_of(frame, "QSU").begin, 250);
  EXPECT_EQ(span_of(frame, "VRU").end, frame.cycles);
  EXPECT_EQ(frame.bound, "VRU");
  EXPECT_DOUBLE_EQ(frame.bound_share, 302.0 / 552);
  EXPECT_DOUBLE_EQ(frame.chip_joules, 0.87 * 552e-9);
  EXPECT_DOUBLE_EQ(frame.fps(), 1e9 / 552);
}

// 3687.5 lines of records; 50 of features; 50 keys of 6 B gathered. The lists' 300 B lie in two runs of 150 B, three
// lines each: three times read, twice written. 40 open pairs fetch 32 B, two to a line.
TEST(RivalModels, GscoresBytesByHand) {
  const MachineFrame frame = ideal_frame(gscore());
  EXPECT_EQ(frame.bytes.at("records"), 3688 * 64);
  EXPECT_EQ(frame.bytes.at("features"), 50 * 64);
  EXPECT_EQ(frame.bytes.at("fetches"), 20 * 64);
  EXPECT_EQ(frame.bytes.at("keys"), 5 * 64);
  EXPECT_EQ(frame.bytes.at("sort"), (6 + 4) * 3 * 64);
  EXPECT_EQ(frame.bytes.at("pixels"), 32 * 16 * 4);
  EXPECT_DOUBLE_EQ(frame.dram_joules.mid, frame.all_bytes() * 8 * kDramPjPerBit.mid * 1e-12);
}

// One core: the second tile waits at the lanes. Without subtiles 30 pairs of 256 px, with squares 60 and lists of 80.
TEST(RivalModels, GscoresPartsLeftOut) {
  EXPECT_EQ(ideal_frame(gscore(), {{"cores", 1}}).cycles, 1000 + 20 + 2 + 4 * (70 + 16));
  EXPECT_EQ(ideal_frame(gscore(), {{"subtiles", 0}}).cycles, 250 + 20 + 2 + 30 * 16);
  EXPECT_EQ(ideal_frame(gscore(), {{"box", 0}}).cycles, 250 + 40 + 4 + 60 * 16);
  EXPECT_EQ(ideal_frame(gscore(), {{"passes", 0}}).bytes.at("sort"), 2 * 3 * 64);
}

// One group of 35: split once at 2 a cycle, 35 masks, 33 exact pairs of 16 cycles.
TEST(RivalModels, GsTgByHand) {
  const MachineFrame frame = ideal_frame(gs_tg());
  EXPECT_EQ(frame.cycles, 250 + 17.5 + 35 + 33 * 16);
  EXPECT_EQ(frame.bound, "RM");
  EXPECT_EQ(frame.bytes.at("keys"), 4 * 64);  // 35 keys of 6 B
  // A core that looks at an entry in 16 cycles waits for masks: 35 entries, 2 tiles.
  EXPECT_EQ(ideal_frame(gs_tg(), {{"masks", 0.0625}}).cycles, 250 + 17.5 + 35 + 35 * 2 * 16);
}

TEST(RivalModels, StreaminggsByHand) {
  const MachineFrame frame = ideal_frame(streaminggs());
  EXPECT_EQ(frame.cycles, 400.0 / 4 + 90 + 4.0 / 4 + 86);
  EXPECT_EQ(frame.bytes.at("means"), 400 * 16);      // four runs of 25 lines
  EXPECT_EQ(frame.bytes.at("indices"), 4 * 4 * 64);  // four runs of 202.5 B
  EXPECT_EQ(ideal_frame(streaminggs(), {{"filters", 0}}).cycles, 400 + 1 + 86);
}

// Of 400 the voxels of edge 2 keep 22.5 %, those of edge 1 half of 200: fewer bytes, further from 23.7 %.
TEST(RivalModels, StreaminggsChoosesVoxels) {
  EXPECT_EQ(ideal_frame(streaminggs(), {{"voxels", 0}}).busy("coarse filter"), 100);
  EXPECT_EQ(ideal_frame(streaminggs(), {{"voxels", 1}}).busy("coarse filter"), 100);
  EXPECT_EQ(ideal_frame(streaminggs(), {{"voxels", 2}}).busy("coarse filter"), 50);
}

// The tiles of two groups: the second one has the last 16 columns of a picture of 80.
TEST(RivalModels, StreaminggsGivesTilesToTheirGroups) {
  FrameCounts counts = two_tiles();
  counts.lists[kLists16].columns = 5, counts.lists[kLists64].columns = 2;
  counts.tiles.insert(counts.tiles.begin() + 1, 3, TileCounts{});
  counts.voxels = {{.groups = {{1, 100, 20, 10}, {1, 8, 4, 2}}}};
  // The first group: 25, 20, 1/4 and 70 cycles; the second follows at the lanes.
  EXPECT_EQ(ideal_frame(streaminggs(), {}, counts).cycles, 25 + 20 + 0.25 + 70 + 16);
}

// 64 blocks through projection (100 / 64), lanes (40 pairs of 256 px, 64 a cycle) and sorter (1000 keys, 4 a cycle).
TEST(RivalModels, GsaccByHand) {
  const MachineFrame frame = ideal_frame(gsacc());
  EXPECT_EQ(frame.cycles, (100 + 160.0) / 64 + 250);
  EXPECT_DOUBLE_EQ(frame.seconds(), 2 * frame.cycles * 1e-9);
  EXPECT_EQ(frame.bytes.at("records"), 100 * 64);
  EXPECT_EQ(frame.bytes.at("tiles"), 0);
  // 40 pairs, a tenth of them in the cache: 2 KB read and written.
  EXPECT_EQ(ideal_frame(gsacc(), {{"spilled", 1}}).bytes.at("tiles"), 2 * 36 * 2048);
}

// A list of 45 has two levels above runs of 16; 72 subtiles of a cycle each.
TEST(RivalModels, NeoByHand) {
  const MachineFrame frame = ideal_frame(neo());
  EXPECT_EQ(frame.cycles, 45 * 2 + 72);
  EXPECT_EQ(frame.bytes.at("records"), 94 * 64 + 100 * 128);  // 6000 B, and two lines of 100
  EXPECT_EQ(frame.bytes.at("features"), 100 * 64);
  EXPECT_EQ(frame.bytes.at("fetches"), 45 * 64);
  EXPECT_EQ(frame.bytes.at("keys"), 14 * 64);         // 4.5 keys of three lines
  EXPECT_EQ(frame.bytes.at("sort"), 4 * 2 * 5 * 64);  // 297 B in runs of 270 B, four times
}

// 50 keys split, 35 sorted, 70 subtiles tested, 210 mini-tiles of 2 cycles.
TEST(RivalModels, FlickerByHand) {
  const MachineFrame frame = ideal_frame(flicker());
  EXPECT_DOUBLE_EQ(frame.cycles, 250 + 25 + 3 + 70 + 200 * 1.05 * 2);
  EXPECT_EQ(frame.bound, "VRU");
}

TEST(RivalModels, AnEmptyViewTakesPreprocessingAndPixels) {
  FrameCounts counts = two_tiles();
  for (ListCounts& lists : counts.lists) {
    for (const Cover cover : kAllCovers) std::fill(lists.lengths[cover].begin(), lists.lengths[cover].end(), 0);
  }
  counts.tiles = {{}, {}};
  counts.listed = {};
  counts.neighbours = {};
  counts.voxels = {{.groups = {{}}}};
  for (const Rival* rival : all_rivals()) {
    SCOPED_TRACE(rival->name);
    const MachineFrame frame = ideal_frame(*rival, {}, counts);
    EXPECT_TRUE(std::isfinite(frame.cycles));
    EXPECT_EQ(frame.bytes.at("pixels"), 32 * 16 * 4);
  }
}

TEST(RivalModels, RefuseParametersWithoutMeaning) {
  for (const Rival* rival : all_rivals()) {
    SCOPED_TRACE(rival->name);
    EXPECT_THROW(values_of(*rival, {{"none such", 1}}), std::invalid_argument);
    for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
      EXPECT_THROW(values_of(*rival, {{"watts", bad}}), std::invalid_argument);
    if (values_of(*rival).contains("lanes")) EXPECT_THROW(values_of(*rival, {{"lanes", 0}}), std::invalid_argument);
  }
  EXPECT_THROW(value({}, "lanes"), std::invalid_argument);
}

TEST(RivalModels, ParametersLieInTheirRangesAndOnlyWhatIsReadHasNone) {
  for (const Rival* rival : all_rivals()) {
    SCOPED_TRACE(rival->name);
    EXPECT_TRUE(values_of(*rival).contains("watts"));
    for (const Parameter& one : rival->parameters) {
      SCOPED_TRACE(one.name);
      EXPECT_LE(one.low, one.value);
      EXPECT_LE(one.value, one.high);
      EXPECT_GT(one.source.size(), 5u);
      if (one.mark == Mark::kRead) EXPECT_EQ(one.low, one.high);
    }
  }
}

TEST(RivalModels, AreaCrossesToTwentyEightNanometres) {
  EXPECT_EQ(gscore().mm2_28().low, 3.95);
  EXPECT_EQ(gscore().mm2_28().high, 3.95);
  EXPECT_DOUBLE_EQ(streaminggs().mm2 * streaminggs().node.plain(), 5.37 * 28 * 28 / 32 / 32);
  for (const Rival* rival : all_rivals()) {
    const Range mm2 = rival->mm2_28();
    EXPECT_LE(mm2.low, mm2.mid) << rival->name;
    EXPECT_LE(mm2.mid, mm2.high) << rival->name;
    EXPECT_LE(rival->mm2 * rival->node.plain(), mm2.high * 1.02) << rival->name;
  }
}

}  // namespace
}  // namespace pipegs
