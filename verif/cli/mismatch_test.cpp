// SPDX-License-Identifier: Apache-2.0
// mismatch_test: a wrong colour leads to its cause: the line that stands last, report.json, the command that replays it
// with waves of some cycles, their view in GTKWave, and the pixel Gaussian by Gaussian.
//
// Idea    The fault is `color` of faulty_rtl.cpp: wherever an RU writes region 5 back, one bit of red is wrong.
#include <algorithm>
#include <regex>
#include <sstream>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class MismatchCli : public Cli {
 protected:
  const std::string faulty_ = "PIPEGS_FAULT=color '" PIPEGS_FAULTY "' ";

  // The outcome of a line, both of whose streams are one, as on a terminal.
  std::vector<std::string> lines_of(const std::string& line) {
    std::istringstream both(shell("{ " + line + "; } 2>&1").out);
    std::vector<std::string> lines;
    for (std::string one; std::getline(both, one);) lines.push_back(one);
    return lines;
  }
  Json first_of(const std::string& folder) { return Json::parse(text(folder + "/report.json")).at("first_mismatch"); }
  static std::string behind(const std::string& begin, const std::string& line) {
    return line.starts_with(begin) ? line.substr(begin.size()) : "";
  }
};

TEST_F(MismatchCli, TheFirstOneStandsLastWithWhatRepeatsIt) {
  const std::vector<std::string> lines = lines_of(faulty_ + "sim" + view_ + "--no-truth --out bad");
  ASSERT_GE(lines.size(), 20u) << "the table comes before";
  const Json first = first_of("bad");
  ASSERT_TRUE(first.is_object()) << first;
  EXPECT_EQ(lines.at(lines.size() - 2), fmt::format("first mismatch, cycle {}, window {},{}: {}",
                                                    first["cycle"].get<int64_t>(), first["window"][0].get<int>(),
                                                    first["window"][1].get<int>(), first["what"].get<std::string>()));
  EXPECT_EQ(behind("replay with waves: ", lines.back()), first["replay"]);
  EXPECT_EQ(first["stream"], fmt::format("RU {}", first["unit"].get<int>()));
  EXPECT_EQ(first["signal"], "tap_pixels_o");
  EXPECT_EQ(first["region"], 5);
  EXPECT_EQ(first["field"], "red");
  EXPECT_EQ(std::stoi(first["found"].get<std::string>()) ^ 1, std::stoi(first["expected"].get<std::string>()));
  EXPECT_GT(first["cycle"], 0);
  EXPECT_TRUE(first["gaussian"].is_number_unsigned());
  EXPECT_EQ(first["pixel"].size(), 2u);
}

// Cycles of the window alone are others than those of the frame: the line has the cycle of its own run.
TEST_F(MismatchCli, TheLineShowsItInTheWavesOfAFewCycles) {
  const std::string sim = "sim" + view_ + smallest_ + "--no-truth ";
  ASSERT_EQ(shell(faulty_ + sim + "--out bad").code, 1);
  const Json whole = first_of("bad");
  ASSERT_EQ(shell("PIPEGS_FAULT=color " + whole["replay"].get<std::string>()).code, 1);
  const Json alone = first_of("replay");
  EXPECT_EQ(alone["what"], whole["what"]);
  EXPECT_FALSE(alone.contains("replay")) << "its waves are there";
  const std::string around = fmt::format("--waves-around {}", alone["cycle"].get<int64_t>());
  EXPECT_NE(whole["replay"].get<std::string>().find(around), std::string::npos) << whole;
  const std::vector<std::string> again = lines_of("PIPEGS_FAULT=color " + whole["replay"].get<std::string>());
  EXPECT_EQ(again.back(), "its waves: gtkwave replay/waves.gtkw");

  // The view: the waves beside it, the streams, the marker at the cycle.
  const std::string view = text("replay/waves.gtkw");
  EXPECT_NE(view.find("[dumpfile] \"" + (folder_ / "replay/waves.fst").string()), std::string::npos) << view;
  for (const char* signal : {"\nTOP.aclk\n", "\nTOP.tap_splat_o[", "\nTOP.tap_sorted_o[", "\nTOP.tap_alphas_o[",
                             "\nTOP.tap_pixels_o[", "\nTOP.tap_pixels_valid_o"})
    EXPECT_NE(view.find(signal), std::string::npos) << signal << view;
  std::smatch marker;
  ASSERT_TRUE(std::regex_search(view, marker, std::regex("\n\\*-6\\.0 ([0-9]+) "))) << view;

  // Fewer cycles, smaller waves.
  ASSERT_EQ(run(sim + "--window 0,0 --waves --out all").code, 0);
  ASSERT_EQ(run(sim + "--window 0,0 --waves-around 1000,20 --out few").code, 0);
  EXPECT_LT(fs::file_size(folder_ / "few/waves.fst") * 3, fs::file_size(folder_ / "all/waves.fst"));
}

TEST_F(MismatchCli, ExplainShowsTheColor) {
  ASSERT_EQ(shell(faulty_ + "sim" + view_ + "--no-truth --out bad").code, 1);
  const Json first = first_of("bad");
  const std::string explain =
      fmt::format("explain{}--pixel {},{} ", view_, first["pixel"][0].get<int>(), first["pixel"][1].get<int>());
  const Json right = Json::parse(run(explain + "--json").out).at("gaussians"),
             wrong = Json::parse(shell(faulty_ + explain + "--json").out).at("gaussians");
  ASSERT_EQ(right.size(), wrong.size()) << "the Gaussian of the mismatch has an alpha here";
  for (size_t i = 0; i < wrong.size(); ++i) {
    if (right[i]["rtl"].is_null()) continue;
    EXPECT_EQ(right[i]["rtl"]["sum"], right[i]["golden"]["sum"]);
    EXPECT_EQ(right[i]["rtl"]["first_that_differs"], false);
    EXPECT_EQ(wrong[i]["rtl"]["first_that_differs"], wrong[i]["gaussian"] == first["gaussian"]);
    EXPECT_NEAR(right[i]["golden"]["color"][0].get<double>(), right[i]["double"]["color"][0].get<double>(), 0.02);
    EXPECT_NEAR(right[i]["golden"]["sum"][0].get<double>(), right[i]["double"]["sum"][0].get<double>(), 0.02);
    EXPECT_NE(wrong[i]["rtl"]["sum"][0], wrong[i]["golden"]["sum"][0]);
    EXPECT_EQ(wrong[i]["rtl"]["sum"][1], wrong[i]["golden"]["sum"][1]);
  }
  const std::vector<std::string> lines = lines_of(faulty_ + explain);
  EXPECT_NE(lines.back().find("first mismatch, cycle "), std::string::npos) << lines.back();
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) { return line.ends_with("  the first that differs"); }),
            1);
}

TEST_F(MismatchCli, OtherCommandsTellItLast) {
  const std::vector<std::string> ladder = lines_of(faulty_ + "ladder" + view_ + "--designs dop --no-truth");
  EXPECT_TRUE(ladder.at(ladder.size() - 2).starts_with("dop: first mismatch, cycle ")) << ladder.at(ladder.size() - 2);
  const std::string again = behind("replay: ", ladder.back());
  EXPECT_NE(again.find(" sim scene.ply "), std::string::npos) << again;
  EXPECT_EQ(shell("PIPEGS_FAULT=color " + again).code, 1);
  EXPECT_EQ(first_of("replay")["field"], "red");
  write_cameras(folder_ / "cameras.json", {test_camera(70, 50), test_camera(70, 50)});
  const std::vector<std::string> views = lines_of(faulty_ + "sim" + view_ + "--views all --frames none --out two");
  const Json first = Json::parse(text("two/sequence.json")).at("first_mismatch");
  EXPECT_EQ(first["frame"], 0);
  EXPECT_EQ(first["queued"], true);
  EXPECT_EQ(behind("replay with waves: ", views.back()), first["replay"]);
  EXPECT_NE(views.back().find(fmt::format("--waves-around {}", first["cycle"].get<int64_t>())), std::string::npos);
}

TEST_F(MismatchCli, WhatIsNoRangeIsRefused) {
  const std::string sim = "sim" + view_ + smallest_ + "--no-truth ";
  for (const char* range : {"-1", "many", "5,", ",5", "5,0", "5,6,7", "5:6"})
    expect_refused(sim + "--waves-around " + range, "--waves-around: ");
  expect_refused(sim + "--waves-around 5 --waves", "--waves excludes --waves-around");
  expect_refused(sim + "--waves-around 5 --no-rtl", "--waves: there are none with --no-rtl");
}

}  // namespace
}  // namespace pipegs
