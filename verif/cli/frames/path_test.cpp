// SPDX-License-Identifier: Apache-2.0
// path_test: `pipegs sim --path`, `--views`: frames one after the other, what each took, and their pictures.
//
// Idea    RTL and timing model draw and count the same path: pictures, cycles and bytes must agree.
#include <cmath>
#include <sstream>

#include "cpp_model/float/image.hpp"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class PathCli : public Cli {
 protected:
  const std::string sim_ = "sim scene.ply --cameras cameras.json ", model_ = sim_ + "--no-rtl ";

  void SetUp() override {
    Cli::SetUp();
    Camera second = test_camera(70, 50), third = second;
    second.position = {0.2, 0.1, 0.3};
    third.position = {0.5, -0.1, 0.4};
    write_cameras(folder_ / "cameras.json", {test_camera(70, 50), second, third});
  }
  // The report of a run that ends well.
  Json report(const std::string& arguments, const std::string& out) {
    const Outcome outcome = run(arguments + " --out " + out);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    return Json::parse(text(out + "/sequence.json"));
  }
  std::vector<std::vector<std::string>> table(const std::string& file) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text(file));
    for (std::string line; std::getline(lines, line);) {
      rows.emplace_back();
      std::istringstream cells(line + ",");
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
  }
};

TEST_F(PathCli, RtlAndTimingModelAgreeFrameByFrame) {
  const Json rtl = report(sim_ + "--path 4 --memory ideal", "rtl"),
             model = report(model_ + "--path 4 --memory ideal", "model");
  ASSERT_EQ(rtl["views"].size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const Json &here = rtl["views"][i], &there = model["views"][i];
    EXPECT_EQ(here["mismatches"], 0) << i;
    EXPECT_FALSE(there.contains("mismatches")) << "nothing was compared";
    EXPECT_FALSE(there.contains("cycles_queued"));
    // Up to the last pixel in memory, which the RTL waits for between two frames.
    EXPECT_NEAR(here["cycles_alone"].get<double>(), there["cycles_alone"].get<double>(), 100) << i;
    EXPECT_EQ(here["bytes_read"], there["bytes_read"]) << i;
    EXPECT_EQ(here["bytes_written"], there["bytes_written"]) << i;
    const std::string name = "/frame_000" + std::to_string(i) + ".png";
    EXPECT_EQ(text("rtl" + name), text("model" + name)) << i;
    EXPECT_DOUBLE_EQ(here["view"], 2 * static_cast<double>(i) / 3);
  }
  EXPECT_NE(text("rtl/frame_0000.png"), text("rtl/frame_0001.png"));
}

TEST_F(PathCli, APathThroughEachViewOnceIsTheViews) {
  report(model_ + "--path 3 --frames png,exr", "path");
  report(model_ + "--views all --frames png,exr", "views");
  report(model_ + "--views 1-2 --frames exr", "some");
  for (const std::string name : {"0000.png", "0001.png", "0002.png", "0000.exr", "0001.exr", "0002.exr"})
    EXPECT_EQ(text("path/frame_" + name), text("views/frame_" + name)) << name;
  EXPECT_EQ(text("some/frame_0001.exr"), text("views/frame_0002.exr"));
  EXPECT_FALSE(fs::exists(folder_ / "some/frame_0000.png"));
  const Json orbit = report("sim scene.ply --no-rtl --orbit 3 --size 40x30 --views all --frames none", "orbit");
  EXPECT_EQ(orbit["views"].size(), 3u);
  EXPECT_FALSE(fs::exists(folder_ / "orbit/frame_0000.png"));
}

TEST_F(PathCli, PercentilesAreFramesOfTheTable) {
  const Json json = report(model_ + "--path 120 --frames none", "walk");
  const auto rows = table("walk/frames.csv");
  ASSERT_EQ(rows.size(), 121u);
  const std::vector<std::string> head = {"frame",      "view",       "camera",     "width",         "height",
                                         "rest",       "lod_pixels", "cycles",     "gap_alone",     "cycles_queued",
                                         "gap_queued", "mismatches", "bytes_read", "bytes_written", "us",
                                         "chip_uj",    "dram_uj",    "steady_db"};
  EXPECT_EQ(rows[0], head);
  std::vector<double> cycles, bytes;
  for (size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), head.size());
    const auto number = [&](const char* name) {
      return std::stod(rows[i].at(static_cast<size_t>(std::find(head.begin(), head.end(), name) - head.begin())));
    };
    EXPECT_EQ(rows[i][0], std::to_string(i - 1));
    cycles.push_back(number("cycles"));
    bytes.push_back(1e-6 * (number("bytes_read") + number("bytes_written")));
    EXPECT_GT(number("chip_uj"), 0) << "energy of the chip";
    EXPECT_EQ(json["views"][i - 1]["cycles_alone"], static_cast<uint64_t>(cycles.back()));
    if (i > 1) { EXPECT_GT(number("steady_db"), 10) << "beside the frame before"; }
  }
  // Of 120 frames so many are as cheap or cheaper.
  for (const auto& [rank, least] :
       std::vector<std::pair<std::string, long>>{{"median", 60}, {"p90", 108}, {"p99", 119}, {"max", 120}}) {
    for (const auto& [key, all] : {std::pair{"cycles", cycles}, {"megabytes", bytes}}) {
      const Json& found = json["percentiles"][key][rank];
      const double value = found["value"];
      EXPECT_NEAR(value, all.at(found["frame"]), 1e-9) << rank;
      const auto below = [&values = all](double limit) {
        return std::count_if(values.begin(), values.end(), [&](double v) { return v <= limit; });
      };
      EXPECT_GE(below(value + 1e-9), least) << key << " " << rank;
      EXPECT_LT(below(value - 1e-9), least) << key << " " << rank;
    }
  }
  EXPECT_EQ(json["charts"][0]["title"], "Cycles of each frame");
}

TEST_F(PathCli, ARunThatWasStoppedGoesOn) {
  const std::string walk = model_ + "--path 120 --out walk";
  expect_one_line(shell("'" PIPEGS_BINARY "' " + walk +
                        " & p=$!\nuntil [ -e walk/frame_0002.png ]; do sleep 0.01; done;"
                        " kill -INT $p; wait $p"),
                  130, " of 120 frames; the same command goes on there");
  EXPECT_FALSE(fs::exists(folder_ / "walk/sequence.json"));
  const Json whole = report(model_ + "--path 120", "walk");
  EXPECT_EQ(whole["views"].size(), 120u);
  EXPECT_EQ(whole, report(model_ + "--path 120 --frames none", "other"));
}

// What was kept is taken where it fits: its key, its numbers, the pictures that belong to it.
TEST_F(PathCli, OnlyWholeFramesAreKept) {
  const auto kept_of = [&](uint64_t cycles) -> fs::path {
    for (const auto& file : fs::directory_iterator(folder_ / "walk/kept")) {
      if (Json::parse(text("walk/kept/" + file.path().filename().string()))["measured"]["cycles"] == cycles)
        return "walk/kept" / file.path().filename();
    }
    return "none";
  };
  const auto set_cycles = [&](const fs::path& file, const Json& cycles) {
    auto json = nlohmann::ordered_json::parse(text(file.string()));
    json["measured"]["cycles"] = cycles;
    write(file.string(), json.dump());
  };
  const Json first = report(model_ + "--path 4", "walk");
  const std::string picture = text("walk/frame_0002.png");
  const auto cycles = [](const Json& json, int i) { return json["views"][i]["cycles_alone"].get<uint64_t>(); };
  const fs::path one = kept_of(cycles(first, 1)), two = kept_of(cycles(first, 2)), three = kept_of(cycles(first, 3));
  set_cycles(one, 7);         // a mark: this frame is not computed again
  set_cycles(two, 7);         // its picture will not be there
  set_cycles(three, "many");  // no number
  fs::remove(folder_ / "walk/frame_0002.png");
  const Json second = report(model_ + "--path 4", "walk");
  EXPECT_EQ(cycles(second, 1), 7u);
  EXPECT_EQ(cycles(second, 2), cycles(first, 2));
  EXPECT_EQ(cycles(second, 3), cycles(first, 3));
  EXPECT_EQ(text("walk/frame_0002.png"), picture);
  write("walk/frame_0001.png", picture);  // another frame's
  EXPECT_EQ(report(model_ + "--path 4", "walk"), first);
  // A background, other pixels: other frames.
  set_cycles(one, 7);
  EXPECT_NE(cycles(report(model_ + "--path 4 --background 255,255,255", "walk"), 1), 7u);
}

TEST_F(PathCli, EachMismatchIsNamedWithItsFrame) {
  const Outcome outcome = shell("PIPEGS_FAULT=pixel '" PIPEGS_FAULTY "' " + sim_ + "--path 2 --out wrong");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("first mismatch, frame "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--path 2 --no-truth --out replay --waves"), std::string::npos) << outcome.err;
}

TEST_F(PathCli, WhatMakesNoSequenceIsOneLine) {
  expect_refused(sim_ + "--views 0-3", "--views: found 3, expected 0 to 2");
  for (const char* span : {"0", "", "1-", "-1", "a-b", "0-1-2", "every"})
    expect_refused(sim_ + "--views '" + span + "'", "--views: found '");
  expect_refused(sim_ + "--views 2-1", "--views: found '1', expected an integer from 2");
  for (const char* frames : {"1", "0", "-5", "many", "2.5", "100001", ""})
    expect_refused(sim_ + "--path '" + frames + "'", "--path: found '");
  expect_refused(sim_ + "--path 5 --views 1-1", "--path: found 1 view, expected two or more for a path");
  expect_refused("sim scene.ply --size 40x30 --path 5", "--path: found 1 view, expected two or more for a path");
  for (const char* other : {"--effects auto", "--view 0", "--netlist"})
    expect_refused(sim_ + "--path 5 " + other, std::string(other).substr(0, std::string(other).find(' ')) +
                                                   ": found a sequence, expected one view");
  for (const char* kinds : {"jpg", "png,none", "png,,exr", "png,png"})
    expect_refused(sim_ + "--path 5 --frames " + kinds, "--frames: found ");
  expect_refused(sim_ + "--frames png", "--frames: found one frame, expected --views or --path");
  write_cameras(folder_ / "cameras.json", {test_camera(70, 50), test_camera(40, 90)});
  expect_refused(sim_ + "--path 5", "--path: found views of 70x50 and 40x90 pixels, expected one size for a path");
  EXPECT_FALSE(fs::exists(folder_ / "pictures"));
}

}  // namespace
}  // namespace pipegs
