// SPDX-License-Identifier: Apache-2.0
// tradeoff_cli_test: `pipegs tradeoff` as a person meets it: what it prints, what it keeps, when it is stopped, bad
// input.
#include <map>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class TradeoffCli : public Cli {
 protected:
  const std::string view_ = "tradeoff scene.ply --cameras cameras.json ", kept_ = view_ + "--keep kept ",
                    few_ = kept_ + "--together 3 ", alone_ = kept_ + "--together 0 ";

  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + "--json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  std::vector<fs::path> files() {
    std::vector<fs::path> paths;
    for (const auto& file : fs::directory_iterator(folder_ / "kept")) paths.push_back(file.path());
    std::sort(paths.begin(), paths.end());
    return paths;
  }
};

TEST_F(TradeoffCli, TellsEveryPointOnceAndTakesWhatIsKept) {
  const Json first = json(few_);
  EXPECT_EQ(first["charts"][0]["name"], "quality_by_time");
  EXPECT_EQ(first["ghz"], 1.0);
  std::map<std::string, int> knobs;
  int on_front = 0;
  for (const Json& point : first["points"]) {
    ++knobs[point["knob"]];
    on_front += !point["front"].is_null();
    EXPECT_DOUBLE_EQ(point["us"], point["cycles"].get<double>() / 1000);
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
  EXPECT_EQ(files().size(), first["points"].size());

  // Kept ones are believed: this one has another number now. A broken one is measured again.
  const std::vector<fs::path> paths = files();
  EXPECT_EQ(json(few_), first);
  const std::string cycles = std::to_string(first["points"][0]["cycles"].get<uint64_t>());
  for (const fs::path& path : paths) {
    std::string kept = text(fs::relative(path, folder_));
    const Json key = Json::parse(kept)["key"];
    const size_t at = kept.find("\"cycles\": " + cycles + ",");
    if (key["scale"] != 1.0 || key["without"] != 0.0 || at == std::string::npos) continue;
    std::ofstream(path, std::ios::binary) << kept.replace(at, 10 + cycles.size(), "\"cycles\": 987654321");
  }
  const Json second = json(alone_ + "--ghz 2 ");
  EXPECT_EQ(second["points"][0]["cycles"], 987654321);
  EXPECT_DOUBLE_EQ(second["points"][0]["us"], 493827.1605);
  for (const fs::path& path : paths) std::ofstream(path, std::ios::binary) << "{\"key\":";
  EXPECT_EQ(json(few_), first);
}

// Another near plane, and another camera whose picture the contributions are of.
TEST_F(TradeoffCli, AnotherViewMeasuresItsOwn) {
  json(alone_);
  const size_t own = files().size();
  json(alone_ + "--near 0.3 ");
  EXPECT_EQ(files().size(), 2 * own);
  Camera other = test_camera(70, 50);
  other.position.x = 0.1;
  write_cameras(folder_ / "cameras.json", {test_camera(70, 50), other});
  json(alone_);
  EXPECT_EQ(files().size(), 3 * own);
}

TEST_F(TradeoffCli, RunsOnEveryOrderAndOnScenesWithoutColourBands) {
  write_ply(folder_ / "plain.ply", random_scene(2, 40, 0));
  for (const char* point : {"fast", "exact", "dop", "baseline"}) {
    SCOPED_TRACE(point);
    const Outcome outcome =
        run(std::string("tradeoff plain.ply --cameras cameras.json --together 0 --keep kept --design ") + point);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("SH degree"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("order layers") == std::string::npos, std::string(point) == "baseline") << outcome.out;
  }
}

TEST_F(TradeoffCli, AnInterruptedOneKeepsWholePointsOnly) {
  write_ply(folder_ / "more.ply", random_scene(3, 3000, 1));
  write_cameras(folder_ / "larger.json", {test_camera(320, 240)});
  const std::string command = "{ '" PIPEGS_BINARY
                              "' tradeoff more.ply --cameras larger.json --keep kept & pid=$!; tries=0; while [ \"$(ls "
                              "kept 2>/dev/null | wc -l)\" -lt 1 ] && [ $tries -lt "
                              "1200 ]; do sleep 0.05; tries=$((tries + 1)); done; kill -INT $pid; wait $pid; }";
  const Outcome outcome = shell(command);
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  for (const fs::path& path : files()) {
    EXPECT_EQ(path.extension(), ".json") << path;
    EXPECT_FALSE(Json::parse(text(fs::relative(path, folder_)), nullptr, false).is_discarded()) << path;
  }
}

TEST_F(TradeoffCli, BadInputIsOneLine) {
  for (const char* clock : {"0", "0.05", "11", "-1", "fast", "nan", "1,5", ""})
    expect_refused(view_ + "--ghz '" + clock + "'", "--ghz: found '");
  for (const char* many : {"-1", "1001", "1.5", "many"})
    expect_refused(view_ + "--together '" + many + "'", "--together: found '");
  expect_refused(view_ + "--window 0,0", "--window: pictures of other sizes are compared as a whole");
  expect_refused(view_ + "--keep scene.ply", "cannot be written: 'scene.ply' is a file, expected a folder");
  expect_refused(view_ + "--page /proc/chart.html", "cannot be written: nothing can be made in");
  expect_refused(view_ + "--view 1", "--view: found 1, expected 0 to 0");
  expect_refused(view_ + "--set t_cut=7", "t_cut: found '7'");
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

}  // namespace
}  // namespace pipegs
