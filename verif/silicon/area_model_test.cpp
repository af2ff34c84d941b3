// SPDX-License-Identifier: Apache-2.0
// area_model_test: leave-one-out errors of areas and energies; tables written by hand; broken tables.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "scenes/input_error.hpp"
#include "sim/design/design_point.hpp"
#include "sim/silicon/frame_model.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;
constexpr const char* kSynth = PIPEGS_SOURCE_DIR "/synth/data/";

// A block of 1000 and 10 for each bit and 2 for each bit squared, and one that knows no knob.
AreaPoint by_hand(int coeff_f, int late = 0) {
  AreaPoint point;
  point.config.coeff_f = coeff_f, point.config.late = late;
  const double bits = coeff_f - 28;
  point.nand2["pu_coeff"]["pu"] = 1000 + 10 * bits + 2 * bits * bits + 300 * late;
  point.nand2["pipegs_perf"]["top"] = 200;
  point.nand2["pu_row_unit"][late ? "ru" : "pu"] = 50;
  return point;
}

TEST(AreaModel, FindsLinesSquaresAndDesignPoints) {
  const AreaModel model({by_hand(28), by_hand(20), by_hand(24), by_hand(30), by_hand(28, 1)},
                        {{"pu_coeff", {"coeff_f"}}, {"pipegs_perf", {}}, {"pu_row_unit", {}}});
  const auto told = [&](int coeff_f, int late) { return model.nand2(by_hand(coeff_f, late).config); };
  for (const int coeff_f : {22, 26, 29}) {
    EXPECT_NEAR(told(coeff_f, 0).at("pu"), by_hand(coeff_f).by_unit().at("pu"), 3) << coeff_f;
    EXPECT_NEAR(told(coeff_f, 1).at("pu"), by_hand(coeff_f, 1).by_unit().at("pu"), 3)
        << coeff_f << ": the square moves with the design point";
  }
  EXPECT_NEAR(told(26, 1).at("ru"), 50, 0.1) << "a block stands where its design point has it";
  EXPECT_NEAR(told(26, 0).at("top"), 200, 0.1);
}

TEST(AreaModel, KnowsItsBounds) {
  const AreaModel model({by_hand(28), by_hand(24), by_hand(28, 1)},
                        {{"pu_coeff", {"coeff_f"}}, {"pipegs_perf", {}}, {"pu_row_unit", {}}});
  EXPECT_TRUE(model.inside(by_hand(26).config));
  EXPECT_TRUE(model.inside(by_hand(26, 1).config));
  EXPECT_FALSE(model.inside(by_hand(23).config));
  Config other;
  other.alpha_w = 10;
  EXPECT_FALSE(model.inside(other)) << "no point moves it";
  other = {};
  other.order = 1;
  EXPECT_FALSE(model.inside(other)) << "no point of this design point";
}

TEST(AreaModel, KnowsKindsThatAPointHas) {
  const Dependences depends = {{"pu_coeff", {"coeff_f"}}, {"pipegs_perf", {}}, {"pu_row_unit", {}}};
  Config config = by_hand(28, 1).config;
  config.quads = 1;
  const std::vector<AreaPoint> points = {by_hand(28), by_hand(24), by_hand(28, 1)};
  EXPECT_TRUE(AreaModel(points, depends).knows(by_hand(20, 1).config));
  EXPECT_FALSE(AreaModel(points, depends).knows(config)) << "quads make another kind of machine";
  AreaPoint quads = by_hand(28, 1);
  quads.config = config;
  quads.nand2["pu_coeff"]["pu"] += 500;
  const AreaModel model({points[0], points[1], points[2], quads}, depends);
  EXPECT_TRUE(model.knows(config));
  EXPECT_NEAR(model.nand2(config).at("pu"), 1800, 3);
  EXPECT_NEAR(model.nand2(points[2].config).at("pu"), 1300, 3) << "and leave the others as they are";
}

// A machine with a block in each unit, one in each PU that fetches, one that stands once, and one that stands once for
// each unit and once more.
AreaPoint of_shape(int units, int fronts, int coeff_f = 28) {
  AreaPoint point;
  point.config.units = units, point.config.fronts = fronts, point.config.coeff_f = coeff_f;
  const auto add = [&](const char* block, const char* unit, int instances, double each) {
    point.nand2[block][unit] = instances * each;
    point.instances[block] = instances;
  };
  add("pipegs_su", "su", 2 * units, 100 + 10 * (coeff_f - 28));
  add("pu_cull", "pu", 2 * point.config.pu_fronts(), 700);
  add("pipegs_dopu", "dopu", 4, 50);
  add("pipegs_perf", "top", units + 1, 20);
  return point;
}

TEST(AreaModel, MultipliesWhatStandsInEachUnit) {
  const Dependences depends = {
      {"pipegs_su", {"coeff_f"}}, {"pu_cull", {}}, {"pipegs_dopu", {}}, {"pipegs_perf", {"units"}}};
  const std::vector<AreaPoint> points = {of_shape(4, 4), of_shape(4, 2), of_shape(2, 2), of_shape(4, 4, 24)};
  const AreaModel model(points, depends);
  for (const auto& [units, fronts] : {std::pair{4, 4}, {4, 2}, {4, 1}, {2, 1}, {2, 4}, {1, 1}}) {
    const AreaPoint wanted = of_shape(units, fronts, 26);
    for (const auto& [unit, nand2] : wanted.by_unit())
      EXPECT_NEAR(model.nand2(wanted.config).at(unit), nand2, 0.03 * nand2) << unit << ", " << units << ", " << fronts;
  }
  EXPECT_FALSE(model.inside(of_shape(1, 1).config));
  EXPECT_TRUE(model.inside(of_shape(2, 4).config)) << "of two PUs at most two fetch";
}

// A table in which all machines have four units: what is a multiple of four stands in each.
TEST(AreaModel, TakesAMultipleOfTheUnitsForOneOfEach) {
  const AreaModel model({of_shape(4, 4), of_shape(4, 4, 24)},
                        {{"pipegs_su", {"coeff_f"}}, {"pu_cull", {}}, {"pipegs_dopu", {}}, {"pipegs_perf", {}}});
  EXPECT_NEAR(model.nand2(of_shape(2, 2).config).at("su"), 400, 2);
  EXPECT_NEAR(model.nand2(of_shape(2, 2).config).at("top"), 100, 0.1) << "five are no multiple of four";
}

// A block whose knobs nobody has told is not taken for one that has none.
TEST(AreaModel, RefusesABlockWithoutItsKnobs) {
  try {
    const AreaModel model({by_hand(28), by_hand(24)}, {{"pu_coeff", {"coeff_f"}}, {"pipegs_perf", {}}});
    FAIL() << "pu_row_unit has no row";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("block pu_row_unit: missing"), std::string::npos) << error.what();
  }
}

// Fitted alone, a part of the library would be the sum of what all blocks hold of it, in widths of no one knob.
TEST(AreaModel, BlocksHoldTheirPartsOfTheLibrary) {
  const Dependences depends = read_dependences(std::string(kSynth) + "depends.csv");
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(PIPEGS_SOURCE_DIR "/rtl/lib"))
    EXPECT_FALSE(depends.contains(file.path().stem().string())) << file.path() << " is no block";
}

// Whether another point is of the same kind, and another one has spherical harmonics of the same degree.
bool has_kin(const AreaModel& model, size_t point) {
  const Config& config = model.points()[point].config;
  bool kind = false, degree = false;
  for (size_t i = 0; i < model.points().size(); ++i) {
    const Config& other = model.points()[i].config;
    kind = kind || (i != point && kind_of(other) == kind_of(config));
    degree = degree || (i != point && other.sh_degree == config.sh_degree);
  }
  return kind && degree;
}

// Every point of the table told from all others. Of a point that alone is of its kind, or has its degree, or moves a
// knob so far, the others know nothing of that.
TEST(AreaModel, LeaveOneOutErrorsOfThePoints) {
  const AreaModel model(read_area_points(std::string(kSynth) + "points.csv"),
                        read_dependences(std::string(kSynth) + "depends.csv"));
  ASSERT_GE(model.points().size(), 3u);
  for (size_t i = 0; i < model.points().size(); ++i) {
    const AreaPoint& kept_out = model.points()[i];
    const double synthesised = sum(kept_out.by_unit());
    const double fitted = sum(model.nand2(kept_out.config)) / synthesised - 1,
                 told = sum(model.without(i).nand2(kept_out.config)) / synthesised - 1;
    printf("%+7.2f %% fitted, %+7.2f %% leave-one-out%s: %s\n", 100 * fitted, 100 * told,
           model.without(i).inside(kept_out.config) ? "" : " (extrapolated)",
           config_difference(kept_out.config).c_str());
    EXPECT_LT(std::abs(fitted), 0.005);  // what two knobs do together is in no line of the model
    EXPECT_LT(std::abs(told), has_kin(model, i) && model.without(i).inside(kept_out.config) ? 0.03 : 0.1);
  }
}

// Every measured frame told from all others: from another scene's frame of its design point, or, of a design point that
// has one frame only, from other design points.
TEST(FrameModel, LeaveOneOutErrorsOfTheFrames) {
  const FrameModel model = read_frame_model();
  ASSERT_GE(model.frames().size(), 2u);
  for (size_t i = 0; i < model.frames().size(); ++i) {
    const MeasuredFrame& frame = model.frames()[i];
    double measured = 0;
    for (const auto& [row, joules] : frame.joules) measured += joules;
    const FrameModel others = model.without(i);
    const double told = others.dynamic(frame.config, frame.kilo_nand2, frame.cycles).mid / measured - 1;
    const bool same_design_point = std::any_of(
        others.frames().begin(), others.frames().end(),
        [&](const MeasuredFrame& other) { return design_point_name(other.config) == design_point_name(frame.config); });
    printf("%+7.1f %% of the chip's %.0f uJ leave-one-out%s: %s %s\n", 100 * told, measured * 1e6,
           same_design_point ? "" : " (no other of its design point)", frame.scene.c_str(),
           config_difference(frame.config).c_str());
    EXPECT_LT(std::abs(told), same_design_point ? 0.21 : 0.8);  // how often a unit switches differs between scenes
  }
}

TEST(FrameModel, AddsUp) {
  const FrameModel model = read_frame_model();
  const MeasuredFrame& frame = model.frames().front();
  const uint64_t bytes = 20'000'000;
  const FrameCost cost = model.cost(frame.config, frame.cycles, bytes).value(),
                  twice = model.cost(frame.config, 2 * frame.cycles, 2 * bytes).value();
  Config other;
  other.late = other.order = 1;
  EXPECT_FALSE(model.cost(other, frame.cycles, bytes)) << "no machine of this kind is among the points";
  EXPECT_NEAR(cost.dram.mid, 8 * 8e-12 * static_cast<double>(bytes), 1e-15);
  EXPECT_NEAR(twice.joules(), 2 * cost.joules(), 1e-12);
  EXPECT_EQ(twice.mm2.mid, cost.mm2.mid);
  EXPECT_LT(cost.mm2.low, cost.mm2.mid);
  EXPECT_LT(cost.chip.mid, cost.chip.high);
}

TEST(AreaModel, RefusesBrokenTables) {
  const fs::path path = fs::temp_directory_path() / ("pipegs_points_" + std::to_string(getpid()) + ".csv");
  const auto refused = [&](const std::string& text, auto&& read) {
    std::ofstream(path) << text;
    try {
      read(path);
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("accepted");
  };
  const std::string points = "configuration,unit,block,instances,nand2,flipflops\n",
                    frames = "scene,configuration,cycles,row,kilo_nand2,frame_uj\n";
  const auto expect = [&](const std::string& text, auto&& read, const std::string& part) {
    const std::string error = refused(text, read);
    EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' is not in: " << error;
  };
  expect("", read_area_points, "no header, expected configuration");
  expect(points, read_area_points, "no points");
  expect(points + "default,pu\n", read_area_points, "line 2: found 2 fields, expected 6");
  expect(points + "\"late=1,order=7\",pu,pu,4,1,1\n", read_area_points, "line 2: ");
  expect(points + "\"units=2,units=4\",pu,pu,4,1,1\n", read_area_points,
         "line 2: configuration: found a second 'units'");
  expect(points + "default,pu,pu,4,x,1\n", read_area_points, "line 2, nand2: found 'x', expected a number from 0");
  expect(points + "default,pu,pu,4,-1,1\n", read_area_points, "line 2, nand2: found '-1'");
  expect(points + "default,pu,pu,4,nan,1\n", read_area_points, "line 2, nand2: found 'nan'");
  expect(points + "default,pu,pu,4,7 4,1\n", read_area_points, "line 2, nand2: found '7 4'");
  expect(points + "default,pu,pu,0,7,1\n", read_area_points, "line 2, instances: found '0'");
  expect(points + "default,pu,pu,4,7,-1\n", read_area_points, "line 2, flipflops: found '-1'");
  expect(points + "default,pu,a,4,7,1\ndefault,pu,a,4,7,1\n", read_area_points,
         "line 3, block: found a second row of 'a'");
  expect(points + "default,pu,a,4,7,1\nunits=2,pu,a,4,7,1\ndefault,pu,b,4,7,1\n", read_area_points,
         "line 4, configuration: found 'default' again");
  expect("block,knobs\npu,nothing\n", read_dependences, "line 2: ");
  expect("block,knobs\npu,units\npu,units\n", read_dependences, "line 3, block: found a second 'pu'");
  expect("block,knobs\npu,units units\n", read_dependences, "line 2, knobs: found a second 'units'");
  expect(frames + "mine,default,1,PU,1,1\n", read_frames, "mine: expected the rows DOPU");
  expect(frames + "mine,default,-1,PU,1,1\n", read_frames, "line 2, cycles: found '-1'");
  expect(frames + "mine,default,1,PU,0,1\n", read_frames, "line 2, kilo_nand2: found '0', expected a number above 0");
  expect(frames + "mine,default,1,PU,1,inf\n", read_frames, "line 2, frame_uj: found 'inf'");
  expect(frames + "mine,default,1,PU,1,1\nmine,default,1,PU,1,1\n", read_frames, "line 3, row: found a second 'PU'");
  expect(frames + "mine,default,1,PU,1,1\nmine,default,2,SU,1,1\n", read_frames, "line 3, cycles: found other cycles");
  const std::string paths = "configuration,unit,path_fo4\n", dop = "default,pu,60\ndefault,su,50\ndefault,ru,50\n";
  expect(paths + dop, read_path_points, "default: expected the rows dopu, pu, su, ru, top");
  expect(paths + "default,lists,50\n", read_path_points,
         "line 2, unit: found 'lists', expected dopu, pu, su, ru or top");
  expect(paths + "default,pu,60\ndefault,pu,60\n", read_path_points, "line 3, unit: found a second row of 'pu'");
  expect(paths + "default,pu,0\n", read_path_points, "line 2, path_fo4: found '0', expected a number above 0");
  expect(paths + dop + "units=2,pu,60\n" + dop, read_path_points, "configuration: found 'default' again");
  EXPECT_EQ(refused(paths, read_path_points), "accepted") << "a table without points is one";
  EXPECT_TRUE(read_path_points("/nowhere.csv").empty()) << "and so is none";
  EXPECT_THROW(read_frames("/nowhere.csv"), InputError);
  EXPECT_THROW(read_area_points(fs::temp_directory_path()), InputError);
  EXPECT_THROW(read_dependences("/dev/zero"), InputError);
  fs::remove(path);
}

}  // namespace
}  // namespace pipegs
