// SPDX-License-Identifier: Apache-2.0
// shapes_cli_test: `pipegs shapes` as a person meets it: a run on a small scene, what is kept of it, bad input.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;  // a kept frame is read in its own order

class ShapesCli : public Cli {
 protected:
  const std::string view_ = "shapes scene.ply --cameras cameras.json ";
  const std::string exact_ = view_ + "--design exact --runs 24 --keep kept ";
};

TEST_F(ShapesCli, FindsTheFrontAndKeepsWhatItMeasured) {
  const Outcome first = run(exact_ + "--json");
  ASSERT_EQ(first.code, 0) << first.err;
  const Json json = Json::parse(first.out);
  EXPECT_EQ(json["mm2"], 3.283);
  EXPECT_LE(json["shapes"].size(), 24u);
  EXPECT_GT(json["shapes"].size(), 10u);
  EXPECT_FALSE(json["front"].empty());
  size_t kept = 0;
  for (const auto& file : fs::directory_iterator(folder_ / "kept")) kept += file.path().extension() == ".json";
  EXPECT_EQ(kept, json["shapes"].size());
  for (const Json& shape : json["shapes"]) {
    EXPECT_GT(shape["cycles"], 0);
    EXPECT_EQ(shape["within"], shape["mm2"]["mid"] <= 3.283);
    if (shape["ghz"].is_null()) EXPECT_NEAR(shape["us"].get<double>(), shape["cycles"].get<double>() / 1000, 1e-6);
  }
  // What is kept is taken: a frame of one cycle changes the table.
  const std::string base = json["shapes"][0]["configuration"];
  for (const auto& file : fs::directory_iterator(folder_ / "kept")) {
    Json changed = Json::parse(text(fs::relative(file.path(), folder_)));
    changed["measured"]["cycles"] = 777;
    std::ofstream(file.path()) << changed.dump();
  }
  const Outcome second = run(exact_ + "--area 3");
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find(" 777 "), std::string::npos) << second.out;
  EXPECT_NE(second.out.find("within 3 mm2"), std::string::npos) << second.out;
}

TEST_F(ShapesCli, BadInputIsOneLine) {
  for (const char* area : {"0", "-1", "nan", "3.2x", "1e9", "''"})
    expect_refused(view_ + "--design exact --area " + area, "--area: found '");
  expect_refused(view_ + "--design exact --runs 0", "--runs: found '0'");
  expect_refused(view_ + "--design dpc", "synth/points.py, add one");
  expect_refused(view_ + "--design exact --window 0,0", "--window: ");
  expect_refused("shapes nowhere.ply --cameras cameras.json --design exact", "nowhere.ply");
  expect_refused(view_ + "--design exact --keep scene.ply", "--keep");
}

}  // namespace
}  // namespace pipegs
