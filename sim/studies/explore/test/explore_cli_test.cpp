// SPDX-License-Identifier: Apache-2.0
// explore_cli_test: `pipegs accuracy`, `pipegs study tradeoff` and `shapes` as a person meets them: what they print,
// what they store, when they are stopped, targets, bad input; and --config.
#include <map>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class ExploreCli : public Cli {
 protected:
  const std::string view_ = "scene.ply --cameras cameras.json --store points ", tradeoff_ = "study tradeoff " + view_,
                    shapes_ = "study shapes " + view_,
                    sweep_ = "accuracy " + view_ + "--design exact --knobs alpha_w,t_w,layers --points 4 ";

  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + "--json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  std::vector<fs::path> stored() {
    std::vector<fs::path> paths;
    for (const auto& file : fs::directory_iterator(folder_ / "points")) paths.push_back(file.path());
    std::sort(paths.begin(), paths.end());
    return paths;
  }
  // Whole points only, whatever stopped it.
  void expect_whole_points() {
    for (const fs::path& path : stored()) {
      EXPECT_EQ(path.extension(), ".json") << path;
      EXPECT_FALSE(Json::parse(text(fs::relative(path, folder_)), nullptr, false).is_discarded()) << path;
    }
  }
  // Stops a command as soon as there are three points.
  void expect_interrupted(const std::string& arguments) {
    const Outcome outcome =
        shell("{ '" PIPEGS_BINARY "' " + arguments +
              "& pid=$!; tries=0; while [ \"$(ls points 2>/dev/null | wc -l)\" -lt 3 ] && [ $tries -lt 1200 ]; do "
              "sleep 0.05; tries=$((tries + 1)); done; kill -INT $pid; wait $pid; }");
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    expect_whole_points();
  }
};

TEST_F(ExploreCli, AccuracyResumesWithoutMeasuringAgain) {
  const Outcome first = run(sweep_ + "--out acc --json");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.out, text("acc/accuracy.json"));
  EXPECT_GT(stored().size(), 12u);
  EXPECT_FALSE(fs::exists(folder_ / "acc/accuracy.html"));
  const std::string csv = text("acc/accuracy.csv");

  const Outcome second = run(sweep_ + "--out acc");
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find("  0 points measured"), std::string::npos) << second.out;
  EXPECT_EQ(text("acc/accuracy.csv"), csv);
  EXPECT_EQ(text("acc/accuracy.json"), first.out);

  // One broken, one of something else: both are measured again.
  const std::vector<fs::path> paths = stored();
  std::ofstream(paths[0]) << "{\"key\":";
  fs::copy_file(paths[2], paths[1], fs::copy_options::overwrite_existing);
  const Outcome third = run(sweep_);
  EXPECT_NE(third.out.find("  2 points measured"), std::string::npos) << third.out;
  const Outcome other = run(sweep_ + "--near 0.3");
  EXPECT_EQ(other.out.find("  0 points measured"), std::string::npos);
}

// Nobody sees the pictures: what empties one of them is told, measured or taken from the store, and listed.
TEST_F(ExploreCli, AFrameThatOneConfigurationEmptiesIsTold) {
  Scene faint = random_scene(1, 60, 0);
  for (Gaussian& gaussian : faint.gaussians) gaussian.opacity_logit = -4.6F;
  write_ply(folder_ / "faint.ply", faint);
  for (const char* when : {"measured", "kept"}) {
    SCOPED_TRACE(when);
    const Outcome outcome =
        run("study tradeoff faint.ply --cameras cameras.json --store points --together 0 --json --out faint");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string what = "alpha cut 1/64: the frame is empty: ";
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
    EXPECT_NE(Json::parse(outcome.out)["findings"].dump().find(what), std::string::npos) << outcome.out;
  }
  const Outcome strict = run("study tradeoff faint.ply --cameras cameras.json --store points --together 0 --strict");
  expect_one_line(strict, 2, "alpha cut 1/64: the frame is empty: ");
}

TEST_F(ExploreCli, AnInterruptedQuestionLeavesWholePointsOnly) {
  expect_interrupted("accuracy --design exact --points 0 --window 6,6 --store points --out acc ");
  EXPECT_FALSE(fs::exists(folder_ / "acc"));
  fs::remove_all(folder_ / "points");
  write_ply(folder_ / "more.ply", random_scene(3, 3000, 1));
  write_cameras(folder_ / "larger.json", {test_camera(320, 240)});
  expect_interrupted("study tradeoff more.ply --cameras larger.json --store points ");
}

TEST_F(ExploreCli, TheTargetIsAMachineThatEveryCommandTakes) {
  const Outcome outcome = run(sweep_ + "--target 45dB");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("target 45 dB numeric: "), std::string::npos) << outcome.out;
  const size_t words = outcome.out.find("use it with --design ");
  ASSERT_NE(words, std::string::npos) << outcome.out;
  const std::string machine = outcome.out.substr(words + 12, outcome.out.find('\n', words) - words - 12);
  EXPECT_GE(json("sim scene.ply --cameras cameras.json --no-rtl --out pictures " + machine + " ")["psnr_numeric_db"]
                .get<double>(),
            45);
  const Outcome high = run(sweep_ + "--target 150dB");
  EXPECT_EQ(high.code, 0);
  EXPECT_NE(high.out.find("not reached"), std::string::npos);
}

// The area model has no point of a machine like `dpc`: it says nothing of its area, clock and energy.
TEST_F(ExploreCli, AMachineThatNoPointIsLikeHasAccuracyAndCyclesButNoArea) {
  const std::string dpc = "accuracy " + view_ + "--design dpc --knobs alpha_w --points 2 --target 45dB ";
  const Json json = this->json(dpc);
  EXPECT_TRUE(json["base"]["silicon"].is_null());
  EXPECT_GT(json["base"]["cycles"], 0);
  EXPECT_FALSE(json["front"]["cycles"].empty());
  EXPECT_TRUE(json["front"]["area"].empty());
  EXPECT_TRUE(json["front"]["energy"].empty());
  EXPECT_TRUE(json["front"]["time"].empty());
  const Outcome text = run(dpc);
  EXPECT_EQ(text.out.find("mm2"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("cycles count at 1 GHz"), std::string::npos) << text.out;
}

// What has an area has the keys of a clock, null where no path of the kind is known.
TEST_F(ExploreCli, TimeIsCyclesByTheClock) {
  const Json json = this->json(sweep_), silicon = json["base"]["silicon"];
  ASSERT_TRUE(silicon.contains("ghz") && silicon.contains("us") && silicon.contains("path_ps"));
  EXPECT_EQ(silicon["ghz"].is_null(), json["front"]["time"].empty());
  if (silicon["ghz"].is_null()) {
    EXPECT_TRUE(silicon["us"].is_null() && silicon["path_ps"].is_null());
    EXPECT_NE(run(sweep_).out.find("cycles count at 1 GHz"), std::string::npos);
  } else {
    EXPECT_NEAR(silicon["us"].get<double>(), json["base"]["cycles"].get<double>() / silicon["ghz"].get<double>() / 1000,
                1e-6);
  }
}

TEST_F(ExploreCli, TradeoffTellsEveryPointOnceAndTakesWhatIsStored) {
  const std::string few = tradeoff_ + "--together 3 ";
  const Json first = json(few);
  EXPECT_EQ(first["charts"][0]["name"], "quality_by_time");
  EXPECT_EQ(first["ghz"], 1.0);
  std::map<std::string, int> knobs;
  int on_front = 0;
  for (const Json& point : first["points"]) {
    ++knobs[point["knob"]];
    on_front += !point["front"].is_null();
    EXPECT_DOUBLE_EQ(point["us"], point["cycles"].get<double>() / 1000);
    EXPECT_EQ(point["silicon"].is_null(),
              point["configuration"].get<std::string>().find("order=2") == std::string::npos)
        << point["label"];
    EXPECT_EQ(point["width"], point["label"] == "1/2"       ? 35
                              : point["label"] == "3/4"     ? 53
                              : point["knob"] != "together" ? 70
                                                            : point["width"].get<int>());
  }
  EXPECT_EQ(knobs["base"], 1);
  EXPECT_EQ(knobs["SH degree"], 1);
  EXPECT_EQ(knobs["contribution"], 5);
  EXPECT_LE(knobs["together"], 3);
  EXPECT_GT(on_front, 1);
  EXPECT_EQ(stored().size(), first["points"].size());

  // Stored ones are believed: this one has another number now. A broken one is measured again.
  const std::vector<fs::path> paths = stored();
  EXPECT_EQ(json(few), first);
  const std::string cycles = std::to_string(first["points"][0]["cycles"].get<uint64_t>());
  for (const fs::path& path : paths) {
    std::string point = text(fs::relative(path, folder_));
    const Json key = Json::parse(point)["key"];
    const size_t at = point.find("\"cycles\": " + cycles + ",");
    if (key["scale"] != 1.0 || key["without"] != 0.0 || at == std::string::npos) continue;
    std::ofstream(path, std::ios::binary) << point.replace(at, 10 + cycles.size(), "\"cycles\": 987654321");
  }
  const Json second = json(tradeoff_ + "--together 0 " + "--ghz 2 ");
  EXPECT_EQ(second["points"][0]["cycles"], 987654321);
  EXPECT_DOUBLE_EQ(second["points"][0]["us"], 493827.1605);
  for (const fs::path& path : paths) std::ofstream(path, std::ios::binary) << "{\"key\":";
  EXPECT_EQ(json(few), first);
}

// Another near plane; of another camera the contributions, which are of the pictures of all.
TEST_F(ExploreCli, TradeoffOfAnotherViewMeasuresItsOwn) {
  json(tradeoff_ + "--together 0 ");
  const size_t own = stored().size();
  json(tradeoff_ + "--together 0 " + "--near 0.3 ");
  EXPECT_EQ(stored().size(), 2 * own);
  Camera other = test_camera(70, 50);
  other.position.x = 0.1;
  write_cameras(folder_ / "cameras.json", {test_camera(70, 50), other});
  json(tradeoff_ + "--together 0 ");
  EXPECT_EQ(stored().size(), 2 * own + 5);
}

TEST_F(ExploreCli, TradeoffRunsOnEveryOrderAndOnScenesWithoutColourBands) {
  write_ply(folder_ / "plain.ply", random_scene(2, 40, 0));
  for (const char* point : {"fast", "exact", "dop", "baseline"}) {
    SCOPED_TRACE(point);
    const Outcome outcome = run(
        std::string("study tradeoff plain.ply --cameras cameras.json --together 0 --store points --design ") + point);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("SH degree"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("layers of grid") == std::string::npos, std::string(point) == "baseline") << outcome.out;
  }
}

TEST_F(ExploreCli, ShapesFindsTheFrontAndStoresWhatItMeasured) {
  const std::string exact = shapes_ + "--design exact --runs 24 ";
  const Json json = this->json(exact);
  EXPECT_EQ(json["mm2"], 3.283);
  EXPECT_LE(json["shapes"].size(), 24u);
  EXPECT_GT(json["shapes"].size(), 10u);
  EXPECT_FALSE(json["front"].empty());
  EXPECT_EQ(stored().size(), json["shapes"].size());
  for (const Json& shape : json["shapes"]) {
    EXPECT_GT(shape["cycles"], 0);
    EXPECT_EQ(shape["within"], shape["mm2"]["mid"] <= 3.283);
    if (shape["ghz"].is_null()) EXPECT_NEAR(shape["us"].get<double>(), shape["cycles"].get<double>() / 1000, 1e-6);
  }
  // What is stored is taken: a frame of fewer cycles changes the table.
  for (const fs::path& path : stored()) {
    auto changed = nlohmann::ordered_json::parse(text(fs::relative(path, folder_)));  // is read in its own order
    changed["measured"]["cycles"] = 777;
    std::ofstream(path) << changed.dump();
  }
  const Outcome second = run(exact + "--area 3");
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find(" 777 "), std::string::npos) << second.out;
  EXPECT_NE(second.out.find("within 3 mm2"), std::string::npos) << second.out;
}

TEST_F(ExploreCli, SettingsComeAfterTheFile) {
  write("mine.cfg", "alpha_w = 10  # finer\nt_w = 22\n");
  const Outcome outcome = run(
      "sim scene.ply --cameras cameras.json --config mine.cfg --set t_w=20 --no-rtl --no-truth --json --out pictures");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json config = Json::parse(outcome.out)["config"];
  EXPECT_EQ(config["alpha_w"], 10);
  EXPECT_EQ(config["t_w"], 20);
}

TEST_F(ExploreCli, BadInputIsOneLine) {
  write("bad.cfg", "# fine\nt_w=22\nalpha_w=3\n");
  write("order.cfg", "order=2\n");
  const std::string view = " scene.ply --cameras cameras.json ";
  expect_refused("sim" + view + "--config bad.cfg", "bad.cfg:3: alpha_w: found '3', expected an integer from 6 to 12");
  expect_refused("sim" + view + "--config missing.cfg", "--config missing.cfg: cannot open");
  expect_refused("model" + view + "--designs late --config order.cfg",
                 "order.cfg:1: order=2: the design points set order");
  expect_refused("accuracy" + view + "--knobs nonsense", "--knobs: unknown knob 'nonsense'; known: coeff_f");
  expect_refused("accuracy" + view + "--target loud", "--target: found 'loud', expected decibels");
  for (const char* clock : {"0", "0.05", "11", "-1", "fast", "nan", "1,5", ""})
    expect_refused(tradeoff_ + "--ghz '" + clock + "'", "--ghz: found '");
  for (const char* many : {"-1", "1001", "1.5", "many"})
    expect_refused(tradeoff_ + "--together '" + many + "'", "--together: found '");
  for (const char* area : {"0", "-1", "nan", "3.2x", "1e9", "''"})
    expect_refused(shapes_ + "--design exact --area " + area, "--area: found '");
  expect_refused(shapes_ + "--design exact --runs 0", "--runs: found '0'");
  expect_refused(shapes_ + "--design dpc", "synth/points.py, add one");
  expect_refused("study shapes nowhere.ply --cameras cameras.json --store points", "nowhere.ply");
  for (const std::string& question : {tradeoff_, shapes_}) {
    expect_refused(question + "--window 0,0", "--window: pictures or windows of other sizes are compared as a whole");
    expect_refused(question + "--out scene.ply", "cannot be written: 'scene.ply' is a file, expected a folder");
    expect_refused(question + "--page", "--page: found no --out, expected the folder that takes it");
  }
  expect_refused("study tradeoff scene.ply --cameras cameras.json --store scene.ply", "is a file, expected a folder");
  expect_refused(tradeoff_ + "--view 1", "--view: found 1, expected 0 to 0");
  expect_refused(tradeoff_ + "--set t_cut=7", "t_cut: found '7'");
  EXPECT_EQ(left_behind(), (std::vector<std::string>{"bad.cfg", "order.cfg"}));
}

}  // namespace
}  // namespace pipegs
