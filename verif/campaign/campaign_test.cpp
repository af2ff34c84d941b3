// SPDX-License-Identifier: Apache-2.0
// campaign_test: a campaign on this machine: killed and resumed, torn files, windows that make a frame, a wrong RTL.
#include <csignal>
#include <thread>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class CampaignRun : public Cli {
 protected:
  const std::string parallel_ = "parallel -j 1 --joblog out/joblog --resume-failed < out/lines.txt";

  void SetUp() override {
    Cli::SetUp();
    write_cameras(folder_ / "cameras.json", {test_camera(200, 140), test_camera(60, 40)});
  }
  Json campaign(const std::string& engine) const {
    return {{"scenes", {{{"name", "small"}, {"scene", "scene.ply"}, {"cameras", "cameras.json"}, {"views", {0}}}}},
            {"engine", engine}};
  }
  // Two views on four design points, by the timing model.
  Json eight() const {
    Json file = campaign("model");
    file["scenes"][0]["views"] = {0, 1};
    file["designs"] = {"baseline", "dop", "exact", "fast"};
    return file;
  }
  Outcome lines_of(const Json& file, const std::string& out = "out", const std::string& program = PIPEGS_BINARY) {
    write("campaign.json", file.dump());
    const Outcome outcome = shell("'" + program + "' campaign campaign.json --out " + out);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
  }
  Outcome one_by_one(const std::string& out) { return shell("sh -e " + out + "/lines.txt"); }
  Outcome merge(const std::string& out = "out") { return run("campaign campaign.json --merge --out " + out); }
  std::vector<fs::path> kept(const std::string& extension = ".json", const std::string& out = "out") const {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder_ / out / "points")) {
      if (file.path().extension() == extension) files.push_back(file.path());
    }
    std::sort(files.begin(), files.end());
    return files;
  }
  bool no_parallel() { return shell("parallel --version").code != 0; }
};

TEST_F(CampaignRun, KilledInTheMiddleItLosesNothingAndDoesNothingTwice) {
  if (no_parallel()) GTEST_SKIP() << "GNU parallel is not installed";
  lines_of(eight());
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    const std::string line = "cd '" + folder_.string() + "' && " + parallel_ + " > /dev/null 2>&1";
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  setpgid(child, child);
  for (int i = 0; i < 6000 && kept().size() < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(-child, SIGKILL);
  waitpid(child, nullptr, 0);
  // A job may be left that nobody waits for any more: it ends by itself, or the lines below wait for its point.
  std::map<fs::path, fs::file_time_type> before;
  for (const fs::path& file : kept()) before[file] = fs::last_write_time(file);
  ASSERT_GE(before.size(), 2u);
  ASSERT_LT(before.size(), 8u) << "it was not killed in the middle";
  const Outcome half = merge();
  EXPECT_EQ(half.code, 1);
  EXPECT_NE(half.err.find("points are missing, the first: "), std::string::npos) << half.err;

  const Outcome resumed = shell(parallel_);
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(kept().size(), 8u);
  for (const auto& [file, time] : before) EXPECT_EQ(fs::last_write_time(file), time) << file << " was measured twice";
  const Outcome whole = merge();
  EXPECT_EQ(whole.code, 0) << whole.err;
  EXPECT_NE(whole.out.find("8 of 8 points"), std::string::npos) << whole.out;

  // Nothing but the cost depends on how it ran.
  lines_of(eight(), "other");
  EXPECT_EQ(one_by_one("other").code, 0);
  EXPECT_EQ(merge("other").code, 0);
  EXPECT_EQ(text("out/results.csv"), text("other/results.csv"));
  EXPECT_EQ(text("out/results.json"), text("other/results.json"));
  EXPECT_EQ(shell("grep -c '' out/results.csv out/costs.csv").out, "out/results.csv:9\nout/costs.csv:9\n");
}

TEST_F(CampaignRun, WhatIsTornIsMeasuredAgain) {
  if (no_parallel()) GTEST_SKIP() << "GNU parallel is not installed";
  Json file = campaign("golden");
  file["windows"] = 1;
  lines_of(file);
  ASSERT_EQ(shell(parallel_).code, 0);
  ASSERT_EQ(merge().code, 0);
  const std::string results = text("out/results.csv"), picture = text("out/frames/small-0-default-fast/frame.exr");
  ASSERT_FALSE(picture.empty());
  ASSERT_EQ(kept(".exr").size(), 4u);

  fs::resize_file(kept()[0], 100);                            // figures, half of them
  fs::remove(fs::path(kept()[1]).replace_extension(".exr"));  // no pixels
  std::fstream(fs::path(kept()[2]).replace_extension(".exr"), std::ios::in | std::ios::out).seekp(900).put('x');
  fs::remove_all(folder_ / "out/frames");
  EXPECT_EQ(merge().code, 1);
  EXPECT_FALSE(fs::exists(folder_ / "out/frames")) << "a frame without three of its windows";
  EXPECT_EQ(shell(parallel_).out, "") << "its log says that all is done";
  const fs::file_time_type whole = fs::last_write_time(kept()[3]);
  EXPECT_NE(lines_of(file).out.find("4 points, 1 of them kept"), std::string::npos);
  const std::string out = shell(parallel_).out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 3) << out;
  EXPECT_EQ(fs::last_write_time(kept()[3]), whole);
  ASSERT_EQ(merge().code, 0);
  EXPECT_EQ(text("out/results.csv"), results);
  EXPECT_EQ(text("out/frames/small-0-default-fast/frame.exr"), picture);
}

TEST_F(CampaignRun, WindowsAreTheFrameBitForBit) {
  for (const std::string engine : {"golden", "rtl"}) {
    SCOPED_TRACE(engine);
    Json file = campaign(engine);
    file["windows"] = engine == "rtl" ? 2 : 1;
    lines_of(file, engine);
    const Outcome outcome = one_by_one(engine);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    ASSERT_EQ(merge(engine).code, 0);
    const std::string sim = "sim scene.ply --cameras cameras.json --no-truth --out whole_" + engine;
    ASSERT_EQ(run(sim + (engine == "rtl" ? "" : " --no-rtl")).code, 0);
    const std::string joined = text(engine + "/frames/small-0-default-fast/frame.exr");
    EXPECT_GT(joined.size(), 1000u);
    EXPECT_TRUE(joined == text("whole_" + engine + "/frame.exr")) << "the joined frame is another one";
    EXPECT_TRUE(text(engine + "/frames/small-0-default-fast/frame.png") == text("whole_" + engine + "/frame.png"));
  }
  const Json results = Json::parse(text("rtl/results.json"));
  ASSERT_EQ(results["results"].size(), 2u) << "two rows of two windows";
  for (const Json& one : results["results"]) {
    EXPECT_EQ(one["result"]["mismatches"], 0);
    EXPECT_GT(one["result"]["beats_compared"], 0);
    EXPECT_GT(one["result"]["cycles"], 0);
  }
}

TEST_F(CampaignRun, AWrongRtlIsToldByItsLineAndByTheMerge) {
  lines_of(campaign("rtl"), "out", PIPEGS_FAULTY);
  const std::string fault = "PIPEGS_FAULT=pixel ";
  EXPECT_EQ(shell(fault + "sh out/lines.txt").code, 1);
  const Outcome outcome = shell(fault + "'" PIPEGS_FAULTY "' campaign campaign.json --out out --merge");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("in 1 points the RTL differs from the golden model"), std::string::npos) << outcome.err;
  EXPECT_NE(merge().err.find("1 points are missing"), std::string::npos) << "another program, another key";
}

}  // namespace
}  // namespace pipegs
