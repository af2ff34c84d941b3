// SPDX-License-Identifier: Apache-2.0
// campaign_file_test: what a campaign's file says becomes lines in its order; what it says wrong is one line.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class CampaignFile : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    write_cameras(folder_ / "cameras.json", {test_camera(70, 50), test_camera(60, 40)});
  }
  // Two views on two design points.
  static Json good() {
    return {{"scenes", {{{"name", "small"}, {"scene", "scene.ply"}, {"cameras", "cameras.json"}, {"views", {1, 0}}}}},
            {"designs", {"fast", "dop"}}};
  }
  Outcome run_file(const Json& file) {
    write("campaign.json", file.dump());
    return run("campaign campaign.json --out out");
  }
  void expect_wrong(const Json& file, const std::string& part) {
    SCOPED_TRACE(file.dump());
    expect_one_line(run_file(file), 2, "campaign.json: " + part);
    EXPECT_FALSE(fs::exists(folder_ / "out")) << "something was left behind";
  }
};

TEST_F(CampaignFile, LinesAreTheProductInTheOrderOfTheFile) {
  Json file = good();
  file["configurations"] = {{{"name", "plain"}}, {{"name", "few"}, {"set", {"records=1024"}}}};
  file["seed"] = 7;
  const Outcome first = run_file(file);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_NE(first.out.find("8 points, 0 of them kept"), std::string::npos) << first.out;
  const std::string lines = text("out/lines.txt");
  size_t at = 0;
  for (const char* part : {"--view 1 --design fast --memory", "--view 1 --design dop --memory",
                           "--view 1 --design fast --set records=1024", "--view 1 --design dop --set records=1024",
                           "--view 0 --design fast --memory", "--view 0 --design dop --memory",
                           "--view 0 --design fast --set records=1024", "--view 0 --design dop --set records=1024"}) {
    at = lines.find(part, at);
    ASSERT_NE(at, std::string::npos) << part << " is not, or not in its place, in:\n" << lines;
  }
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 8);
  // A line says all there is to say: it runs in another folder, and says so when it has nothing left to do.
  const std::string line = lines.substr(0, lines.find('\n'));
  EXPECT_TRUE(line.starts_with("/")) << line;
  const Outcome measured = shell("cd / && " + line), kept = shell("cd / && " + line);
  EXPECT_EQ(measured.code, 0) << measured.err;
  EXPECT_TRUE(measured.out.starts_with("measured /")) << measured.out;
  EXPECT_EQ(kept.out, "kept" + measured.out.substr(std::string("measured").size()));
  const Outcome again = run_file(file);
  EXPECT_NE(again.out.find("8 points, 1 of them kept"), std::string::npos) << again.out;
  EXPECT_EQ(text("out/lines.txt"), lines.substr(line.size() + 1)) << "what is kept has no line";
}

TEST_F(CampaignFile, TheExampleOfThePageIsOne) {
  std::ifstream file(PIPEGS_SOURCE_DIR "/docs/campaign.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}}, fence = "```json\n";
  const size_t begin = page.find(fence) + fence.size();
  const Outcome outcome = run_file(Json::parse(page.substr(begin, page.find("```", begin) - begin)));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("18 points, 0 of them kept"), std::string::npos) << outcome.out;
}

TEST_F(CampaignFile, WhatIsWrongIsOneLine) {
  const auto with = [](const std::string& place, const Json& value) {
    Json file = good();
    file[Json::json_pointer(place)] = value;
    return file;
  };
  expect_wrong(with("/design", "fast"), "design: found '\"fast\"', expected one of the fields scenes, designs");
  expect_wrong(with("/designs", Json::array()), "designs: ");
  expect_wrong(with("/designs/1", "fats"), "designs[1]: found '\"fats\"', expected what is allowed there: ");
  expect_wrong(with("/designs/1", "fast"), "designs[1]: found '\"fast\"', expected each name once");
  expect_wrong(with("/engine", "verilator"), "engine: found '\"verilator\"', expected one of model, golden, rtl");
  expect_wrong(with("/truth", true), "truth: found 'true', expected false with the engine model");
  expect_wrong(with("/memory", "ddr2"), "memory: found '\"ddr2\"', expected one of ");
  expect_wrong(with("/seed", -1), "seed: found '-1', expected");
  expect_wrong(with("/scenes/0/name", "a b"), "scenes[0].name: found '\"a b\"', expected a name of up to 60 letters");
  expect_wrong(with("/scenes/0/scene", "gone.ply"), "scenes[0].scene: found '\"gone.ply\"', expected a file that is");
  expect_wrong(with("/scenes/0/axes", "XYZ"), "scenes[0].axes: found '\"XYZ\"', expected R or L");
  expect_wrong(with("/scenes/0/size", "160"), "scenes[0].size: found '\"160\"', expected what is allowed there: ");
  expect_wrong(with("/scenes/0/orbit", 4), "scenes[0].orbit: found '4', expected cameras or an orbit, not both");
  expect_wrong(with("/scenes/0/views/1", 1), "scenes[0].views[1]: found '1', expected each view once");
  expect_wrong(with("/scenes/0/views/1", -1), "scenes[0].views[1]: found '-1', expected");
  expect_wrong(with("/scenes/0/view", 1), "scenes[0].view: found '1', expected one of the fields name, scene");
  expect_wrong(with("/scenes/1", good()["scenes"][0]), "scenes[1].name: found '\"small\"', expected each name once");
  expect_wrong(with("/configurations", {{{"name", "a"}, {"set", {"units=3"}}}}), "configurations[0].set: found ");
  expect_wrong(with("/configurations", {{{"name", "a"}, {"set", {"recordz=3"}}}}), "configurations[0].set: found ");
  expect_wrong(Json::object(), "'scenes' is missing");
  Json many = good();
  many["scenes"][0]["views"] = Json::array();
  for (int view = 0; view < 1000; ++view) many["scenes"][0]["views"].push_back(view);
  for (int i = 0; i < 51; ++i) many["configurations"].push_back({{"name", std::to_string(i)}});
  expect_wrong(many, "found 1000 views x 51 configurations x 2 design points, expected at most 100000 points");
}

TEST_F(CampaignFile, WhatTheSceneDoesNotHaveIsOneLine) {
  Json file = good();
  file["scenes"][0]["views"] = {0, 2};
  expect_one_line(run_file(file), 2, "--view: found 2, expected 0 to 1");
  write("campaign.json", "{");
  expect_one_line(run("campaign campaign.json --out out"), 2, "campaign.json: ");
  expect_one_line(run("campaign gone.json --out out"), 2, "gone.json: ");
  expect_refused("point scene.ply --cameras cameras.json --truth --store k", "--truth: found --engine model");
  expect_refused("point scene.ply --cameras cameras.json --engine other --store k", "--engine");
  expect_refused("point scene.ply --cameras cameras.json", "--store");
  EXPECT_EQ(left_behind(), std::vector<std::string>{"campaign.json"});
}

}  // namespace
}  // namespace pipegs
