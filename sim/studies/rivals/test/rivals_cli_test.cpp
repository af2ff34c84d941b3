// SPDX-License-Identifier: Apache-2.0
// rivals_cli_test: `pipegs study rivals` as a person meets it: machines stand beside each other, options count, bad
// input.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class RivalsCli : public Cli {
 protected:
  const std::string machines_ = "study rivals" + view_;
};

TEST_F(RivalsCli, MachinesStandBesideEachOther) {
  const Outcome table = run(machines_);
  ASSERT_EQ(table.code, 0) << table.err;
  const Json found = json(machines_);
  EXPECT_EQ(found["charts"][0]["categories"][2], "STREAMINGGS");
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

TEST_F(RivalsCli, TheViewAndTheVoxelCount) {
  const Json base = json(machines_), twice = json(machines_ + "--scale 2 "), far = json(machines_ + "--near 3 "),
             fine = json(machines_ + "--voxel 0.25 ");
  const auto bytes = [](const Json& found, const char* rival, const char* kind) {
    return found["rivals"][rival]["bytes_by_kind"][kind].get<double>();
  };
  EXPECT_EQ(twice["width"], 140);
  EXPECT_EQ(twice["height"], 100);
  EXPECT_EQ(bytes(twice, "gscore", "records"), bytes(base, "gscore", "records"));
  EXPECT_GT(bytes(twice, "gscore", "fetches"), bytes(base, "gscore", "fetches"));
  EXPECT_LT(bytes(far, "gscore", "features"), bytes(base, "gscore", "features"));
  EXPECT_NE(bytes(fine, "streaminggs", "means"), bytes(base, "streaminggs", "means"));
  EXPECT_EQ(fine["rivals"]["gscore"], base["rivals"]["gscore"]);
}

TEST_F(RivalsCli, MemoryCounts) {
  const Json slow = json(machines_ + "--memory lpddr5-6400x1 "), ideal = json(machines_ + "--memory ideal ");
  for (const auto& [rival, row] : slow["rivals"].items()) {
    EXPECT_LT(row["fps"]["mid"], ideal["rivals"][rival]["fps"]["mid"]) << rival;
    EXPECT_EQ(row["bytes"], ideal["rivals"][rival]["bytes"]) << rival;
  }
}

TEST_F(RivalsCli, BadInputIsOneLine) {
  for (const char* edge : {"0", "-2", "nan", "two", "1e7", ""})
    expect_refused(machines_ + "--voxel '" + edge + "'", "--voxel: found '");
  expect_refused(machines_ + "--memory slow", "--memory");
  for (const char* scale : {"0", "-1", "nan", "1000"})
    expect_refused(machines_ + "--scale '" + scale + "'", "--scale: found '");
  expect_refused(machines_ + "--set units=99", "units");
  expect_refused(machines_ + "--window 0,0", "--window: the whole view is counted, expected none");
  expect_refused(machines_ + "--view 1", "--view: found 1, expected 0 to 0");
  expect_refused("study rivals missing.ply --cameras cameras.json", "missing.ply");
}

}  // namespace
}  // namespace pipegs
