// SPDX-License-Identifier: Apache-2.0
// commands_test: ladder, profile and model: what they print and write holds together and agrees with
// the RTL.
#include <cmath>
#include <map>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class Commands : public Cli {};

TEST_F(Commands, LadderComparesDesignPointsAndWritesTheirFigures) {
  const Json ladder = json("ladder" + view_ + "--designs dop,late,fast --out designs");
  EXPECT_EQ(ladder, Json::parse(text("designs/ladder.json")));
  EXPECT_EQ(ladder["charts"][0]["categories"], Json({"dop", "late", "fast"}));
  ASSERT_EQ(ladder["designs"].size(), 3u);
  for (const Json& design_point : ladder["designs"]) {
    SCOPED_TRACE(design_point["name"]);
    const Json report = Json::parse(text("designs/" + design_point["name"].get<std::string>() + "/report.json"));
    EXPECT_EQ(design_point["mismatches"], 0);
    EXPECT_EQ(design_point["cycles"], report["cycles"]);
    Json streams = report["memory"]["by_stream"];
    for (Json& stream : streams) stream.erase("bursts");
    EXPECT_EQ(design_point["bytes_by_stream"], streams);
    EXPECT_EQ(design_point["psnr_order_db"], report["psnr_order_db"]);
    EXPECT_EQ(design_point["psnr_numeric_db"], report["psnr_numeric_db"]);
    EXPECT_DOUBLE_EQ(design_point["fps"].get<double>(), 1e9 / report["cycles"].get<double>());
    EXPECT_TRUE(design_point["speedup"].is_null()) << "there is no baseline to compare with";
    double busy = 0, sorting = 0;
    for (const Json& unit : report["units"]["ru"]) busy += unit["busy"].get<double>();
    for (const Json& unit : report["units"]["su"]) sorting += unit["busy"].get<double>();
    EXPECT_NEAR(design_point["raster_over_sort"].get<double>(), busy / sorting, 1e-12);
    EXPECT_NEAR(design_point["bubbles"].get<double>(), 1 - busy / (4 * report["cycles"].get<double>()), 1e-12);
    EXPECT_GT(design_point["exposed_cycles"], 0);
    EXPECT_LT(design_point["exposed_cycles"], design_point["cycles"]);
    EXPECT_GT(design_point["peak_records"], 0);
    EXPECT_GT(design_point["static"]["buffer_bytes"], 0);
  }
  EXPECT_EQ(ladder["designs"][1]["same_pixels_as"], "dop");
  EXPECT_GT(ladder["designs"][0]["peak_alpha_lines"], 0);
  EXPECT_TRUE(ladder["designs"][1]["peak_alpha_lines"].is_null());
  EXPECT_TRUE(ladder["designs"][2]["same_pixels_as"].is_null());
  EXPECT_EQ(ladder["designs"][2]["pixels_unlike_same_order"], 0)
      << "its numbers are others: there is nothing to compare";
}

TEST_F(Commands, LadderPrintsATable) {
  const Outcome outcome = run("ladder" + view_ + "--designs late --no-truth");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* part : {"raster/sort", "  late ", "bubbles", "buffers, KB"})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
}

// What a frame leaves out is told by every command that makes one, once, and kept with what the command has found.
TEST_F(Commands, WhatAFrameLeavesOutIsTold) {
  Scene scene = random_scene(1, 300, 1);
  scene.gaussians[7].mean.x = 1e30f;
  write_ply(folder_ / "far.ply", scene);
  const std::string view = " far.ply --cameras cameras.json ", line = "1 of 300 Gaussians lie beyond the range";
  for (const std::string& command :
       {"render" + view + "--out far", "sim" + view + "--no-rtl --no-truth --out far",
        "sim" + view + "--no-rtl --views all --frames none --out far", "explain" + view + "--pixel 3,3 --no-rtl",
        "model" + view, "effects" + view, "pack" + view + "--out far", "study profile" + view + "--out far",
        "ladder" + view + "--designs late --no-truth --out far", "what-if" + view + "--set units=2 --out far",
        "render" + view + "--views all --out far",
        "accuracy" + view + "--knobs alpha_w --points 0 --store far --out far", "point" + view + "--store far",
        "point" + view + "--engine golden --store far"}) {
    SCOPED_TRACE(command);
    const Outcome strict = run(command + " --strict");  // `ladder` names each design point before
    EXPECT_EQ(strict.code, 2) << strict.err;
    EXPECT_NE(strict.err.find("--strict: far.ply: warning: 1 of 300"), std::string::npos) << strict.err;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::size_t first = outcome.err.find(line);
    ASSERT_NE(first, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find(line, first + 1), std::string::npos) << outcome.err;
  }
  for (const char* file : {"far/report.json", "far/sequence.json", "far/profile.json", "far/late/report.json",
                           "far/accuracy.json", "far/what-if.json", "far/render.json"}) {
    const Json findings = Json::parse(text(file)).at("findings");
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Json& f) { return f["key"] == "left_out"; }))
        << file;
  }
}

// Without tools nothing can be built or brought up to date.
TEST_F(Commands, ADesignPointWhoseRtlDoesNotBuildIsNamedAndLeftOut) {
  const Outcome outcome =
      run("ladder" + view_ + "--no-truth --designs dop --set alpha_lines=128 --json --out left", "PATH=/nowhere ");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  const Json ladder = Json::parse(outcome.out);
  EXPECT_NE(ladder["designs"][0]["failure"].get<std::string>().find("does not build"), std::string::npos);
  EXPECT_EQ(ladder["designs"][0]["failure"].get<std::string>().find('\n'), std::string::npos);
  EXPECT_FALSE(ladder["designs"][0].contains("cycles"));
  EXPECT_FALSE(fs::exists(folder_ / "left"));
}

TEST_F(Commands, ProfileCountsHoldTogether) {
  const Json counted = json("study profile" + view_);
  const auto &all = counted["gaussians"], &cost = counted["coefficient_cost"];
  EXPECT_GE(all["tile_pairs"], all["window_pairs"]);
  EXPECT_GE(all["window_pairs"], all["visible"]);
  EXPECT_NEAR(cost["once_per_gaussian"].get<double>() * all["mean_tiles"].get<double>(), 1, 1e-12);
  EXPECT_LE(cost["once_per_gaussian"], cost["once_per_gaussian_and_window"]);
  EXPECT_LE(cost["once_per_gaussian"], cost["mean_of_inverse_tiles"]);  // Jensen
}

// Tiles that are known by hand: a small Gaussian inside a tile, one on a corner of four tiles, one that nobody sees.
TEST_F(Commands, ProfileCountsTilesRightly) {
  const Camera camera = test_camera(128, 96);
  const auto at = [&](double x, double y) {
    return gaussian_at(
        {static_cast<float>((x - camera.cx) / camera.fx * 2), static_cast<float>((y - camera.cy) / camera.fy * 2), 2},
        0.01f);
  };
  // Pixel x lies at its centre: the border of two tiles is at 15.5.
  write_ply(folder_ / "tiles.ply", scene_of({at(40, 40), at(79.5, 31.5), gaussian_at({0, 0, -3})}));
  write_cameras(folder_ / "tiles.json", {camera});
  const Json profile = json("study profile tiles.ply --cameras tiles.json");
  EXPECT_EQ(profile["gaussians"]["visible"], 2);
  EXPECT_EQ(profile["gaussians"]["tile_pairs"], 5);
  EXPECT_EQ(profile["gaussians"]["window_pairs"], 2);
  EXPECT_DOUBLE_EQ(profile["gaussians"]["share_in_two_or_more"].get<double>(), 0.5);
  EXPECT_DOUBLE_EQ(profile["coefficient_cost"]["mean_of_inverse_tiles"].get<double>(), (1 + 0.25) / 2);
}

TEST_F(Commands, ProfileGivesThePapersArithmetic) {
  const Json profile = json("study profile" + view_);
  const Json direct = profile["arithmetic_per_pixel"]["direct"];
  for (const Json& row : profile["arithmetic_per_pixel"]["dpc"]) {
    if (row["tile"] != 16) continue;
    const double multiplications = row["multiplications"], additions = row["additions"];
    EXPECT_NEAR(1 - multiplications / direct["multiplications"].get<double>(), 0.962, 5e-4);
    EXPECT_NEAR(1 - (multiplications + additions) /
                        (direct["multiplications"].get<double>() + direct["additions"].get<double>()),
                0.769, 5e-4);
  }
}

TEST_F(Commands, ModelComparesItselfWithTheRtl) {
  const Json model = json("model" + view_ + "--designs dop,late --check --windows");
  ASSERT_EQ(model["designs"].size(), 2u);
  for (const Json& design_point : model["designs"]) {
    SCOPED_TRACE(design_point["name"]);
    EXPECT_EQ(design_point["cycles"], design_point["rtl"]["cycles"]);
    EXPECT_EQ(design_point["window_ends"], design_point["rtl"]["window_ends"]);
    EXPECT_EQ(design_point["differences"], Json::array());
    EXPECT_TRUE(design_point["first_difference"].is_null());
  }
  const Outcome outcome = run("model" + view_ + "--design late --set units=2");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("units=2"), std::string::npos) << outcome.out;
}

TEST_F(Commands, BadInputIsRefusedInOneLine) {
  expect_refused("ladder" + view_ + "--set late=1", "the design points set late");
  for (const char* command : {"ladder", "model", "silicon"}) {
    expect_refused(command + view_ + "--designs dop,fast --window 0,0",
                   "--window: found design points with windows of 64 and 128 pixels, expected one size");
  }
  expect_refused("model" + view_ + "--designs dop,nonsense", "nonsense");
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

}  // namespace
}  // namespace pipegs
