// SPDX-License-Identifier: Apache-2.0
// campaign_test: a campaign on this machine: killed and resumed, torn files, a right RTL and a wrong one.
#include <csignal>
#include <thread>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class CampaignRun : public Cli {
 protected:
  const std::string parallel_ = "parallel -j 1 < out/lines.txt";

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
  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder_ / "out/points")) {
      if (file.path().extension() == ".json") files.push_back(file.path());
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
  std::map<fs::path, fs::file_time_type> before;
  for (const fs::path& file : kept()) before[file] = fs::last_write_time(file);
  ASSERT_GE(before.size(), 2u);
  ASSERT_LT(before.size(), 8u) << "it was not killed in the middle";
  const Outcome half = merge();
  EXPECT_EQ(half.code, 1);
  EXPECT_NE(half.err.find("points are missing, the first: "), std::string::npos) << half.err;

  lines_of(eight());
  const std::string left = text("out/lines.txt");
  EXPECT_LE(std::count(left.begin(), left.end(), '\n'), 8 - static_cast<long>(before.size()));
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
  lines_of(eight());
  ASSERT_EQ(shell(parallel_).code, 0);
  ASSERT_EQ(merge().code, 0);
  const std::string results = text("out/results.csv");
  const std::vector<fs::path> all = kept();
  ASSERT_EQ(all.size(), 8u);

  fs::resize_file(all[0], 100);  // figures, half of them
  fs::remove(all[1]);
  std::ofstream(all[2]) << R"({"key": {}, "measured": {}})";  // of another point
  EXPECT_EQ(merge().code, 1);
  const fs::file_time_type whole = fs::last_write_time(all[3]);
  EXPECT_NE(lines_of(eight()).out.find("8 points, 5 of them kept"), std::string::npos);
  const std::string out = shell(parallel_).out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 3) << out;
  EXPECT_EQ(fs::last_write_time(all[3]), whole);
  ASSERT_EQ(merge().code, 0);
  EXPECT_EQ(text("out/results.csv"), results);
}

TEST_F(CampaignRun, TheRtlIsComparedPointByPoint) {
  lines_of(campaign("rtl"));
  ASSERT_EQ(one_by_one("out").code, 0);
  ASSERT_EQ(merge().code, 0);
  const Json result = Json::parse(text("out/results.json"))["results"][0]["result"];
  EXPECT_EQ(result["mismatches"], 0);
  EXPECT_GT(result["beats_compared"], 0);
  EXPECT_GT(result["cycles"], 0);
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
