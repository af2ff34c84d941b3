// SPDX-License-Identifier: Apache-2.0
// rivals_cli_test: `pipegs study rivals` as a person meets it: table and JSON say the same and define all of it,
// parameters count, machines stand beside each other, bad input.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class RivalsCli : public Cli {
 protected:
  const std::string view_ = "study rivals scene.ply --cameras cameras.json --counts ",
                    machines_ = "study rivals scene.ply --cameras cameras.json ";

  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + "--json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(RivalsCli, TableAndJsonTellTheSameAndDefineAllOfIt) {
  const Json found = json(view_);
  const Outcome table = run(view_);
  ASSERT_EQ(table.code, 0) << table.err;
  EXPECT_EQ(found["width"], 70);
  EXPECT_EQ(found["height"], 50);
  EXPECT_EQ(found["counts"]["gaussians"]["scene"], 300);
  EXPECT_GT(found["counts"]["gaussians"]["visible"], 30);
  for (const auto& [section, counts] : found["counts"].items()) {
    EXPECT_NE(table.out.find("\n  " + section + "\n"), std::string::npos) << section;
    for (const auto& [key, value] : counts.items()) {
      EXPECT_GT(found["definitions"][section].at(key).get<std::string>().size(), 10u) << section << " " << key;
      const size_t at = table.out.find("\n  " + key + " ", table.out.find("\n  " + section + "\n"));
      ASSERT_NE(at, std::string::npos) << section << " " << key;
      const std::string line = table.out.substr(at + 1, table.out.find('\n', at + 1) - at - 1);
      EXPECT_NE(line.find(" " + std::to_string(value.get<uint64_t>()) + "  "), std::string::npos) << key << "\n"
                                                                                                  << line;
    }
  }
  ASSERT_EQ(found["lists"].size(), 4u);
  for (const Json& lists : found["lists"]) {
    EXPECT_GT(lists["square"]["pairs"], lists["exact"]["pairs"]);
    for (const auto& [key, sums] : lists.items()) {
      if (!sums.is_object()) continue;
      EXPECT_TRUE(found["definitions"]["lists"].contains(key)) << key;
      uint64_t counted = 0;
      for (const Json& number : sums["histogram"]) counted += number.get<uint64_t>();
      EXPECT_EQ(counted, sums["nonempty"]);
      for (const auto& [column, value] : sums.items())
        EXPECT_TRUE(found["definitions"]["lists"].contains(column)) << column;
    }
  }
}

TEST_F(RivalsCli, ParametersCount) {
  const Json base = json(view_), fine = json(view_ + "--voxel 0.25 "), narrow = json(view_ + "--group 16 ");
  EXPECT_EQ(base["parameters"], Json({{"near", 0.2}, {"voxel", 2.0}, {"group", 64}}));
  EXPECT_GT(fine["counts"]["voxels"]["occupied"], base["counts"]["voxels"]["occupied"]);
  EXPECT_GT(narrow["counts"]["voxels"]["fetched"], base["counts"]["voxels"]["fetched"]);
  EXPECT_LT(json(view_ + "--near 3 ")["counts"]["gaussians"]["in_front"], base["counts"]["gaussians"]["in_front"]);
  EXPECT_EQ(json(view_ + "--design dop ")["counts"], base["counts"]);
  EXPECT_EQ(fine["counts"]["pixels"], base["counts"]["pixels"]);
}

TEST_F(RivalsCli, MachinesStandBesideEachOther) {
  const Outcome table = run(machines_);
  ASSERT_EQ(table.code, 0) << table.err;
  const Json found = json(machines_);
  EXPECT_EQ(found["charts"][0]["categories"][2], "STREAMINGGS");
  EXPECT_EQ(found["counts"], json(view_)["counts"]);
  EXPECT_EQ(found["memory"], "lpddr5-6400x4");
  for (const char* rival : {"gscore", "gs_tg", "streaminggs", "gsacc", "neo", "flicker"}) {
    const Json& row = found["rivals"].at(rival);
    EXPECT_NE(table.out.find("\n  " + row["name"].get<std::string>() + " "), std::string::npos) << rival;
    EXPECT_LE(row["fps_per_mm2"]["low"], row["fps_per_mm2"]["mid"]) << rival;
    EXPECT_LE(row["fps_per_mm2"]["mid"], row["fps_per_mm2"]["high"]) << rival;
    for (const char* own : {"dop", "fast"}) EXPECT_TRUE(found["against"]["over"][rival].contains(own)) << rival;
  }
  for (const char* own : {"dop", "fast"}) EXPECT_GT(found["ours"][own]["fps"]["mid"], 0) << own;
}

TEST_F(RivalsCli, TheMachineBesideThePapersIsTheOneOfTheOptions) {
  const Json other = json(machines_ + "--design exact --set records=1024 "), one = json(machines_ + "--design dop ");
  EXPECT_EQ(other["ours"].size(), 2u);
  EXPECT_TRUE(other["ours"].contains("dop"));
  EXPECT_FALSE(other["ours"].contains("fast"));
  EXPECT_EQ(one["ours"].size(), 1u);
  EXPECT_EQ(one["ours"]["dop"], other["ours"]["dop"]);
}

TEST_F(RivalsCli, ScaleMakesTheSamePictureLarger) {
  const Json base = json(view_), twice = json(view_ + "--scale 2 ");
  EXPECT_EQ(twice["width"], 140);
  EXPECT_EQ(twice["height"], 100);
  EXPECT_EQ(twice["counts"]["gaussians"]["in_front"], base["counts"]["gaussians"]["in_front"]);
  EXPECT_GT(twice["counts"]["pixels"]["reached"], 3 * base["counts"]["pixels"]["reached"].get<double>());
}

TEST_F(RivalsCli, MemoryCounts) {
  const Json slow = json(machines_ + "--memory lpddr5-6400x1 "), ideal = json(machines_ + "--memory ideal ");
  for (const auto& [rival, row] : slow["rivals"].items()) {
    EXPECT_LT(row["fps"]["mid"], ideal["rivals"][rival]["fps"]["mid"]) << rival;
    EXPECT_EQ(row["bytes"], ideal["rivals"][rival]["bytes"]) << rival;
  }
}

TEST_F(RivalsCli, OurOwnSceneNeedsNoArguments) {
  EXPECT_GT(json("study rivals --counts ")["counts"]["gaussians"]["visible"], 1000);
}

TEST_F(RivalsCli, BadInputIsOneLine) {
  for (const char* edge : {"0", "-2", "nan", "two", "1e7", ""})
    expect_refused(view_ + "--voxel '" + edge + "'", "--voxel: found '");
  for (const char* side : {"0", "-16", "8", "16.0", "4112", "x"})
    expect_refused(view_ + "--group '" + side + "'", "--group: found '");
  expect_refused(view_ + "--group 24", "--group: found 24, expected a multiple of 16");
  expect_refused(machines_ + "--memory slow", "--memory");
  for (const char* scale : {"0", "-1", "nan", "1000"})
    expect_refused(view_ + "--scale '" + scale + "'", "--scale: found '");
  expect_refused(machines_ + "--set units=99", "units");
  expect_refused(view_ + "--window 0,0", "--window: the whole view is counted, expected none");
  expect_refused(view_ + "--view 1", "--view: found 1, expected 0 to 0");
  expect_refused("study rivals missing.ply --cameras cameras.json", "missing.ply");
}

}  // namespace
}  // namespace pipegs
