// area_model_test: areas and energies that were left out, told from the others; tables written by hand; broken tables.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "scenes/input_error.hpp"
#include "sim/rung.hpp"
#include "sim/silicon/frame_model.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;
constexpr const char* kSynth = PIPEGS_SOURCE_DIR "/synth/";

// A block of 1000 and 10 for each bit and 2 for each bit squared, and one that knows no knob.
AreaPoint by_hand(int coeff_f, int late = 0) {
  AreaPoint point;
  point.config.coeff_f = coeff_f, point.config.late = late;
  const double bits = coeff_f - 28;
  point.nand2["pu_coeff"]["pu"] = 1000 + 10 * bits + 2 * bits * bits + 300 * late;
  point.nand2["perf"]["top"] = 200;
  point.nand2["pu_row_unit"][late ? "ru" : "pu"] = 50;
  return point;
}

TEST(AreaModel, FindsLinesSquaresAndRungs) {
  const AreaModel model({by_hand(28), by_hand(20), by_hand(24), by_hand(30), by_hand(28, 1)}, {{"pu_coeff", {"coeff_f"}}, {"perf", {}}, {"pu_row_unit", {}}});
  const auto told = [&](int coeff_f, int late) { return model.nand2(by_hand(coeff_f, late).config); };
  for (const int coeff_f : {22, 26, 29}) {
    EXPECT_NEAR(told(coeff_f, 0).at("pu"), by_hand(coeff_f).by_unit().at("pu"), 3) << coeff_f;
    EXPECT_NEAR(told(coeff_f, 1).at("pu"), by_hand(coeff_f, 1).by_unit().at("pu"), 3) << coeff_f << ": the square moves with the rung";
  }
  EXPECT_NEAR(told(26, 1).at("ru"), 50, 0.1) << "a block stands where its rung has it";
  EXPECT_NEAR(told(26, 0).at("top"), 200, 0.1);
}

TEST(AreaModel, KnowsItsBounds) {
  const AreaModel model({by_hand(28), by_hand(24), by_hand(28, 1)}, {{"pu_coeff", {"coeff_f"}}});
  EXPECT_TRUE(model.inside(by_hand(26).config));
  EXPECT_TRUE(model.inside(by_hand(26, 1).config));
  EXPECT_FALSE(model.inside(by_hand(23).config));
  Config other;
  other.alpha_w = 10;
  EXPECT_FALSE(model.inside(other)) << "no point moves it";
  other = {};
  other.order = 1;
  EXPECT_FALSE(model.inside(other)) << "no point of this rung";
}

// Whether another point is of the same rung, and another one has spherical harmonics of the same degree.
bool has_kin(const AreaModel& model, size_t point) {
  const Config& config = model.points()[point].config;
  bool rung = false, degree = false;
  for (size_t i = 0; i < model.points().size(); ++i) {
    const Config& other = model.points()[i].config;
    rung = rung || (i != point && rung_name(other) == rung_name(config));
    degree = degree || (i != point && other.sh_degree == config.sh_degree);
  }
  return rung && degree;
}

// Every point of the table told from all others. Of a point that alone has its rung, or its degree, the others know nothing of that.
TEST(AreaModel, TellsThePointsThatAreLeftOut) {
  const AreaModel model(read_area_points(std::string(kSynth) + "points.csv"), read_dependences(std::string(kSynth) + "depends.csv"));
  ASSERT_GE(model.points().size(), 3u);
  for (size_t i = 0; i < model.points().size(); ++i) {
    const AreaPoint& left_out = model.points()[i];
    const double synthesised = sum(left_out.by_unit());
    const double fitted = sum(model.nand2(left_out.config)) / synthesised - 1, told = sum(model.without(i).nand2(left_out.config)) / synthesised - 1;
    printf("%+7.2f %% fitted, %+7.2f %% left out%s: %s\n", 100 * fitted, 100 * told, model.without(i).inside(left_out.config) ? "" : " (extrapolated)",
           config_difference(left_out.config).c_str());
    EXPECT_LT(std::abs(fitted), 0.002);
    EXPECT_LT(std::abs(told), has_kin(model, i) ? 0.03 : 0.1);
  }
}

// Every measured frame told from all others: from another scene's frame of its rung, or, of a rung that has one frame only, from other rungs.
TEST(FrameModel, TellsTheFramesThatAreLeftOut) {
  const FrameModel model = read_frame_model();
  ASSERT_GE(model.frames().size(), 2u);
  for (size_t i = 0; i < model.frames().size(); ++i) {
    const MeasuredFrame& frame = model.frames()[i];
    double measured = 0;
    for (const auto& [row, joules] : frame.joules) measured += joules;
    const FrameModel others = model.without(i);
    const double told = others.dynamic(frame.config, frame.kilo_nand2, frame.cycles).mid / measured - 1;
    const bool same_rung = std::any_of(others.frames().begin(), others.frames().end(), [&](const MeasuredFrame& other) {
      return rung_name(other.config) == rung_name(frame.config);
    });
    printf("%+7.1f %% of the chip's %.0f uJ left out%s: %s %s\n", 100 * told, measured * 1e6, same_rung ? "" : " (no other of its rung)", frame.scene.c_str(),
           config_difference(frame.config).c_str());
    EXPECT_LT(std::abs(told), same_rung ? 0.15 : 0.8);
  }
}

TEST(FrameModel, AddsUpAndIsKept) {
  const FrameModel model = read_frame_model();
  const MeasuredFrame& frame = model.frames().front();
  const FrameCost cost = model.cost(frame.config, frame.cycles, frame.bytes), twice = model.cost(frame.config, 2 * frame.cycles, 2 * frame.bytes);
  EXPECT_NEAR(cost.dram.mid, 8 * 8e-12 * static_cast<double>(frame.bytes), 1e-15);
  EXPECT_NEAR(twice.joules(), 2 * cost.joules(), 1e-12);
  EXPECT_EQ(twice.mm2.mid, cost.mm2.mid);
  EXPECT_LT(cost.mm2.low, cost.mm2.mid);
  EXPECT_LT(cost.chip.mid, cost.chip.high);
  const fs::path path = fs::temp_directory_path() / ("pipegs_frames_" + std::to_string(getpid()) + ".csv");
  std::ofstream(path) << frames_csv(model.frames());
  EXPECT_EQ(frames_csv(read_frames(path)), frames_csv(model.frames()));
  fs::remove(path);
}

TEST(AreaModel, RefusesBrokenTables) {
  const fs::path path = fs::temp_directory_path() / ("pipegs_points_" + std::to_string(getpid()) + ".csv");
  const auto refused = [&](const std::string& text, auto&& read) {
    std::ofstream(path) << text;
    try {
      read(path);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string points = "configuration,unit,block,instances,nand2,flipflops\n", frames = "scene,configuration,cycles,bytes,row,kilo_nand2,frame_uj\n";
  EXPECT_NE(refused("", read_area_points).find("line 1: expected configuration"), std::string::npos);
  EXPECT_NE(refused(points, read_area_points).find("no points"), std::string::npos);
  EXPECT_NE(refused(points + "default,pu\n", read_area_points).find("line 2: expected 6 fields, found 2"), std::string::npos);
  EXPECT_NE(refused(points + "\"late=1,order=7\",pu,pu,4,1,1\n", read_area_points).find("line 2: "), std::string::npos);
  EXPECT_NE(refused(points + "default,pu,pu,4,x,1\n", read_area_points).find("line 2: "), std::string::npos);
  EXPECT_NE(refused("block,knobs\npu,nothing\n", read_dependences).find("line 2: "), std::string::npos);
  EXPECT_NE(refused(frames + "own,default,1,1,PU,1,1\n", read_frames).find("expected cycles, and the rows"), std::string::npos);
  fs::remove(path);
}

}  // namespace
}  // namespace pipegs
