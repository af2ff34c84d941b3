// SPDX-License-Identifier: Apache-2.0
// accuracy_cli_test: `pipegs accuracy` and --config as a person meets them: resuming, targets, bad input.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class AccuracyCli : public Cli {
 protected:
  const std::string sweep_ =
      "accuracy scene.ply --cameras cameras.json --design exact --knobs alpha_w,t_w,layers --points 4 --out acc ";

  size_t files(const std::string& folder, const std::string& part = "") {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / folder))
      count += entry.path().filename().string().find(part) != std::string::npos;
    return count;
  }
};

TEST_F(AccuracyCli, ResumesWithoutMeasuringAgain) {
  const Outcome first = run(sweep_ + "--json");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.out, text("acc/accuracy.json"));
  const size_t points = files("acc/points");
  EXPECT_GT(points, 12u);
  // Without npm there is no page, and all else is as it was.
  const bool page = first.err.find("accuracy.html is left out") == std::string::npos;
  const std::string html = text("acc/accuracy.html"), csv = text("acc/accuracy.csv");
  EXPECT_EQ(html.find("id=\"plane:picture0\"") != std::string::npos, page);

  const Outcome second = run(sweep_ + "--resume");
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find("  0 points measured"), std::string::npos) << second.out;
  EXPECT_EQ(text("acc/accuracy.html"), html);
  EXPECT_EQ(text("acc/accuracy.csv"), csv);
  EXPECT_EQ(text("acc/accuracy.json"), first.out);

  // One broken, one of something else: both are measured again.
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder_ / "acc/points")) paths.push_back(entry.path());
  std::ofstream(paths[0]) << "{\"key\":";
  fs::copy_file(paths[2], paths[1], fs::copy_options::overwrite_existing);
  const Outcome third = run(sweep_ + "--resume");
  EXPECT_NE(third.out.find("  2 points measured"), std::string::npos) << third.out;
  const Outcome other = run(sweep_ + "--resume --near 0.3");
  EXPECT_EQ(other.out.find("  0 points measured"), std::string::npos);
}

TEST_F(AccuracyCli, AnInterruptedSweepLeavesWholePointsOnly) {
  // Ctrl-C as soon as there are three points.
  const std::string command =
      "cd '" + folder_.string() +
      "' && { '" PIPEGS_BINARY
      "' accuracy --design exact --points 0 --window 6,6 --out acc > out.txt 2> err.txt & pid=$!; tries=0; "
      "while [ \"$(ls acc/points 2>/dev/null | wc -l)\" -lt 3 ] && [ $tries -lt 1200 ]; do sleep 0.05; tries=$((tries "
      "+ 1)); done; "
      "kill -INT $pid; wait $pid; }";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130) << text("err.txt");
  ASSERT_TRUE(fs::exists(folder_ / "acc"));
  EXPECT_FALSE(fs::exists(folder_ / "acc/accuracy.html"));
  EXPECT_EQ(files("acc/points", ".tmp"), 0u);
  for (const auto& entry : fs::directory_iterator(folder_ / "acc/points"))
    EXPECT_FALSE(Json::parse(text(fs::relative(entry.path(), folder_)), nullptr, false).is_discarded());
}

TEST_F(AccuracyCli, TheTargetIsAFileThatEveryCommandReads) {
  const Outcome outcome = run(sweep_ + "--target 45dB");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("target 45 dB numeric: "), std::string::npos) << outcome.out;
  ASSERT_NE(text("acc/target.cfg").find("late=1\n"), std::string::npos) << text("acc/target.cfg");
  const Outcome report =
      run("sim scene.ply --cameras cameras.json --config acc/target.cfg --no-rtl --json --out pictures");
  ASSERT_EQ(report.code, 0) << report.err;
  EXPECT_GE(Json::parse(report.out)["psnr_numeric_db"].get<double>(), 45);
  const Outcome high = run(sweep_ + "--resume --target 150dB");
  EXPECT_EQ(high.code, 0);
  EXPECT_NE(high.out.find("not reached"), std::string::npos);
}

// The area model has no point of a machine like `dpc`: nothing is told of its area, clock and energy.
TEST_F(AccuracyCli, AMachineThatNoPointIsLikeHasAccuracyAndCyclesButNoArea) {
  const Outcome outcome =
      run("accuracy scene.ply --cameras cameras.json --design dpc --knobs alpha_w --points 2 --out acc --target 45dB "
          "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_TRUE(json["base"]["silicon"].is_null());
  EXPECT_GT(json["base"]["cycles"], 0);
  EXPECT_FALSE(json["front"]["cycles"].empty());
  EXPECT_TRUE(json["front"]["area"].empty());
  EXPECT_TRUE(json["front"]["energy"].empty());
  EXPECT_TRUE(json["front"]["time"].empty());
  EXPECT_EQ(json["knobs"][0]["sentence"].get<std::string>().find("area"), std::string::npos);
  EXPECT_NE(text("acc/accuracy.csv").find(",,,"), std::string::npos);
  EXPECT_NE(text("acc/accuracy.txt").find("cycles count at 1 GHz"), std::string::npos);
}

// What has an area has the keys of a clock, null where no path of the kind is known.
TEST_F(AccuracyCli, TimeIsCyclesByTheClock) {
  const Outcome outcome = run(sweep_ + "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out), silicon = json["base"]["silicon"];
  ASSERT_TRUE(silicon.contains("ghz") && silicon.contains("us") && silicon.contains("path_ps"));
  EXPECT_EQ(silicon["ghz"].is_null(), json["front"]["time"].empty());
  if (silicon["ghz"].is_null()) {
    EXPECT_TRUE(silicon["us"].is_null() && silicon["path_ps"].is_null());
    EXPECT_NE(text("acc/accuracy.txt").find("cycles count at 1 GHz"), std::string::npos);
  } else {
    EXPECT_NEAR(silicon["us"].get<double>(), json["base"]["cycles"].get<double>() / silicon["ghz"].get<double>() / 1000,
                1e-6);
  }
}

TEST_F(AccuracyCli, SettingsComeAfterTheFile) {
  write("mine.cfg", "alpha_w = 10  # finer\nt_w = 22\n");
  const Outcome outcome = run(
      "sim scene.ply --cameras cameras.json --config mine.cfg --set t_w=20 --no-rtl --no-truth --json --out pictures");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json config = Json::parse(outcome.out)["config"];
  EXPECT_EQ(config["alpha_w"], 10);
  EXPECT_EQ(config["t_w"], 20);
}

TEST_F(AccuracyCli, BadInputIsOneLine) {
  write("bad.cfg", "# fine\nt_w=22\nalpha_w=3\n");
  write("order.cfg", "order=2\n");
  const std::string view = " scene.ply --cameras cameras.json ";
  expect_refused("sim" + view + "--config bad.cfg", "bad.cfg:3: alpha_w: found '3', expected an integer from 6 to 12");
  expect_refused("sim" + view + "--config missing.cfg", "--config missing.cfg: cannot open");
  expect_refused("model" + view + "--designs late --config order.cfg",
                 "order.cfg:1: order=2: the design points set order");
  expect_refused("accuracy" + view + "--knobs nonsense", "--knobs: unknown knob 'nonsense'; known: coeff_f");
  expect_refused("accuracy" + view + "--target loud", "--target: found 'loud', expected decibels");
}

}  // namespace
}  // namespace pipegs
