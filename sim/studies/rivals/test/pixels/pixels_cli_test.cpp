// SPDX-License-Identifier: Apache-2.0
// `pipegs rivals --pixels` as a person meets it: table and JSON say the same, options count, bad input.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class PixelsCli : public Cli {
 protected:
  const std::string view_ = "rivals scene.ply --cameras cameras.json ";

  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + "--json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(PixelsCli, TableAndJsonTellTheSameAndDefineAllOfIt) {
  const Json found = json(view_ + "--pixels "), pixels = found["pixels"];
  const Outcome table = run(view_ + "--pixels");
  ASSERT_EQ(table.code, 0) << table.err;
  EXPECT_EQ(found["counts"], json(view_)["counts"]);
  EXPECT_FALSE(json(view_).contains("pixels"));
  EXPECT_EQ(pixels["streaminggs"].size(), 7u * 3);
  EXPECT_EQ(pixels["frames"].size(), 4u * 4);
  EXPECT_TRUE(pixels["path"]["arc"]);
  for (const char* section : {"streaminggs", "frames"}) {
    for (const Json& row : pixels[section]) {
      for (const auto& [key, value] : row.items())
        EXPECT_GT(pixels["definitions"][section].at(key).get<std::string>().size(), 8u) << key;
      const Json& db = row["psnr_db"];
      char text[32];
      std::snprintf(text, sizeof text, " %.2f", db.is_null() ? 0 : db.get<double>());
      EXPECT_NE(table.out.find(db.is_null() ? " equal" : text), std::string::npos) << db;
    }
  }
  for (const auto& [key, value] : pixels["path"].items()) EXPECT_TRUE(pixels["definitions"]["path"].contains(key));
}

TEST_F(PixelsCli, OptionsCount) {
  const Json found = json(view_ +
                          "--pixels --voxels 1 --groups 32 --speeds 2,3 --step 2 --path-frames 1 "
                          "--index-bytes 4 --near 0.5 ")["pixels"];
  ASSERT_EQ(found["streaminggs"].size(), 4u);
  EXPECT_EQ(found["streaminggs"][0]["voxel"], 1.0);
  EXPECT_EQ(found["streaminggs"][3]["part"], 64);
  EXPECT_EQ(found["streaminggs"][3]["group"], 32);
  const Json& row = found["streaminggs"][0];
  EXPECT_EQ(row["bytes"], 16 * row["fetched"].get<double>() + 4 * row["passed"].get<double>());
  ASSERT_EQ(found["frames"].size(), 8u);
  EXPECT_EQ(found["frames"][7]["speed"], 3.0);
  EXPECT_EQ(found["frames"][7]["machine"], "neo_even");
  EXPECT_EQ(found["path"]["turn"], 2.0);
  EXPECT_EQ(found["parameters"]["near"], 0.5);
  write_cameras(folder_ / "two.json", {test_camera(70, 50), [] {
                                         Camera camera = test_camera(70, 50);
                                         camera.position.x = 0.5;
                                         return camera;
                                       }()});
  const Json two = json("rivals scene.ply --cameras two.json --pixels --voxels 1 --groups 16 --speeds 1 ")["pixels"];
  EXPECT_FALSE(two["path"]["arc"]);
  EXPECT_EQ(two["path"]["legs"], 1);
  EXPECT_EQ(two["path"]["turn"], 0.0);
}

TEST_F(PixelsCli, BadInputIsOneLine) {
  for (const char* list : {"0", "-2", "nan", "two", "1e7", "1,,2", ""})
    expect_refused(view_ + "--pixels --voxels '" + list + "'", "--voxels: found ");
  for (const char* list : {"0", "8", "16.0", "4112", "16,x"})
    expect_refused(view_ + "--pixels --groups '" + list + "'", "--groups: found '");
  expect_refused(view_ + "--pixels --groups 16,24", "--groups: found 24, expected multiples of 16");
  expect_refused(view_ + "--pixels --speeds 0", "--speeds: found '0'");
  expect_refused(view_ + "--pixels --step 0", "--step: found '0'");
  expect_refused(view_ + "--pixels --step 91", "--step: found '91'");
  expect_refused(view_ + "--pixels --path-frames 0", "--path-frames: found '0'");
  expect_refused(view_ + "--pixels --index-bytes -1", "--index-bytes: found '-1'");
  expect_refused(view_ + "--voxels 2", "--pixels");
}

}  // namespace
}  // namespace pipegs
