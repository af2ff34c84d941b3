// SPDX-License-Identifier: Apache-2.0
// cli_test: `pipegs` with good and bad input: exit codes, one clear line, nothing half-written.
#include "cpp_model/driver/pipegs_frame.h"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

TEST_F(Cli, SimAgreesAndWritesPictureAndReport) {
  const Outcome outcome = run("sim scene.ply --cameras cameras.json --out pictures");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* name : {"frame.exr", "frame.png", "report.json"})
    EXPECT_TRUE(fs::exists(folder_ / "pictures" / name)) << name;
  const auto report = nlohmann::json::parse(text("pictures/report.json"));
  EXPECT_EQ(report["mismatches"], 0);
  for (const char* key :
       {"scene", "camera", "config", "cycles", "units", "memory", "work", "psnr_numeric_db", "psnr_order_db",
        "psnr_total_db", "max_abs_error", "saturations", "wall_seconds", "host", "rtl_khz"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  uint64_t read = 0;
  for (const auto& [stream, bytes] : report["memory"]["by_stream"].items()) read += bytes["read"].get<uint64_t>();
  EXPECT_EQ(read, report["memory"]["bytes_read"]);
}

TEST_F(Cli, ThePictureInRasterOrderIsTheSame) {
  const std::string sim = "sim scene.ply --cameras cameras.json --no-truth ";
  ASSERT_EQ(run(sim + "--out windows").code, 0);
  const Outcome outcome = run(sim + "--picture raster --out raster");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(text("raster/frame.png"), text("windows/frame.png"));
  const auto raster = nlohmann::json::parse(text("raster/report.json")),
             windows = nlohmann::json::parse(text("windows/report.json"));
  EXPECT_EQ(raster["config"]["picture"], "raster");
  EXPECT_EQ(windows["config"]["picture"], "windows");
  // Rows of eight pixels, four bytes each, of a picture whose sides need not be multiples of anything.
  const int width = raster["camera"]["width"], height = raster["camera"]["height"];
  EXPECT_EQ(raster["memory"]["by_stream"]["raster"]["written"], (width + 7) / 8 * 32 * height);
  expect_refused(sim + "--picture upside", "--picture: upside not in {windows,raster}");
}

TEST_F(Cli, ViewsFollowInOneMachine) {
  write_cameras(folder_ / "cameras.json", {test_camera(70, 50), test_camera(40, 90), test_camera(70, 50)});
  const Outcome outcome = run("sim scene.ply --cameras cameras.json --views 1-2 --json --out pictures");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* name : {"frame_0000.png", "frame_0001.png", "frames.csv"})
    EXPECT_TRUE(fs::exists(folder_ / "pictures" / name)) << name;
  const auto report = nlohmann::json::parse(text("pictures/sequence.json"));
  EXPECT_EQ(report, nlohmann::json::parse(outcome.out));
  ASSERT_EQ(report["views"].size(), 2u);
  uint64_t queued = 0, alone = 0;
  for (const auto& view : report["views"]) {
    EXPECT_EQ(view["mismatches"], 0);
    queued += view["cycles_queued"].get<uint64_t>();
    alone += view["cycles_alone"].get<uint64_t>();
  }
  EXPECT_EQ(queued, report["cycles_queued"]);
  EXPECT_EQ(alone, report["cycles_alone"]);
  EXPECT_LT(queued, alone);
  // A frame that is alone takes as long as in a machine of its own, and until its last pixel is in memory.
  ASSERT_EQ(run("sim scene.ply --cameras cameras.json --view 1 --no-truth --out single").code, 0);
  const auto single = nlohmann::json::parse(text("single/report.json"));
  EXPECT_GE(report["views"][0]["cycles_alone"], single["cycles"]);
  EXPECT_LE(report["views"][0]["cycles_alone"], single["cycles"].get<uint64_t>() + 100);
}

TEST_F(Cli, SettingsMayStandBeforeTheScene) {
  const Outcome outcome =
      run("sim --set grid=4 --set units=4 scene.ply --cameras cameras.json --no-truth --out pictures");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(Cli, ADesignPointIsItsSettingsAndThoseBehindIt) {
  const auto config_of = [&](const std::string& design) {
    const Outcome outcome =
        run("sim scene.ply --cameras cameras.json " + design + "--no-truth --no-rtl --json --out pictures");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out)["config"];
  };
  const auto standard = config_of(""), paper = config_of("--design dop ");
  EXPECT_EQ(standard, config_of("--design fast "));
  EXPECT_EQ(standard["order"], 2);
  EXPECT_EQ(standard["window"], 128);
  EXPECT_EQ(paper["order"], 0);
  EXPECT_EQ(paper["window"], 64);
  EXPECT_EQ(paper["alpha_w"], 8) << "nothing of the default is left in the paper's machine";
  const auto late = config_of("--design late ");
  EXPECT_EQ(late["late"], 1);
  EXPECT_EQ(late["order"], 0);
  EXPECT_EQ(late["quadratic"], 0);
  EXPECT_EQ(config_of("--design late --set late=0 ")["late"], 0);
  EXPECT_EQ(standard["walk_most"], PIPEGS_WALK_MOST);
  EXPECT_EQ(config_of("--walk-most 5 ")["walk_most"], 5);
  EXPECT_FALSE(paper.contains("walk_most")) << "its windows have one walk";
}

TEST_F(Cli, RenderWritesEveryModel) {
  for (const char* model : {"truth", "layered", "golden"}) {
    EXPECT_EQ(run("render scene.ply --cameras cameras.json --model " + std::string(model) + " --out " + model).code, 0)
        << model;
    EXPECT_TRUE(fs::exists(folder_ / model / "frame.exr"));
  }
}

TEST_F(Cli, ASceneWithoutCamerasIsFramed) {
  const auto rendered = [&](const std::string& options) {
    const Outcome outcome = run("render scene.ply " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return text("out/frame.png");
  };
  const std::string plain = rendered("--size 96x64"), turned = rendered("--size 96x64 --orbit 4 --view 1");
  EXPECT_NE(plain, turned);
  EXPECT_EQ(plain, rendered("--size 96x64 --orbit 4 --view 0"));
  EXPECT_NE(plain, rendered("--size 96x64 --from 0,0,-1 --look-at 0,0,4 --fov 80 --up 0,-1,0"));
  const std::string framed = "render scene.ply ";
  expect_refused(framed + "--view 1", "--view: found 1, expected 0 to 0");
  expect_refused(framed + "--orbit 4 --view 4", "--view: found 4, expected 0 to 3");
  expect_refused(framed + "--cameras cameras.json --orbit 4", "expected a file or a framing");
  expect_refused(framed + "--ignore-distortion", "--ignore-distortion: found no --cameras");
  expect_refused(framed + "--up 0,0,0", "--up: found '0,0,0'");
  expect_refused(framed + "--from 1,1,1 --look-at 1,1,1", "or nowhere");
  expect_refused(framed + "--size 96", "--size: found '96', expected WxH");
  for (const char* place : {"1,2", "1,2,3,4", "1,,2", "a,b,c", "nan,0,0", "1e300,0,0"})
    expect_refused(framed + "--from " + place, "--from: found '");
  for (const char* fov : {"0", "-1", "171", "wide"}) expect_refused(framed + "--fov " + fov, "--fov: found '");
  expect_refused(framed + "--orbit 0", "--orbit: found '0'");
}

TEST_F(Cli, CamerasComeInOtherFormats) {
  write("t.json", R"({"camera_angle_x": 1, "frames": [{"transform_matrix":
    [[1,0,0,0],[0,-1,0,0],[0,0,-1,0],[0,0,0,1]]}]})");
  EXPECT_EQ(run("render scene.ply --cameras t.json --size 70x50").code, 0);
  expect_refused("render scene.ply --cameras t.json", "t.json: frames[0]: the file has no size, expected --size WxH");
  fs::create_directories(folder_ / "nothing");
  expect_refused("render scene.ply --cameras nothing", "cameras.bin and cameras.txt");
  const Outcome folder = run("render scene.ply --cameras .");
  EXPECT_EQ(folder.code, 0) << folder.err;
  EXPECT_NE(folder.err.find("note: the cameras of the folder are those of 'cameras.json'"), std::string::npos);
}

// A view that shows nothing says so and why; --strict refuses it; report.json has it.
TEST_F(Cli, WhatIsOddIsSaid) {
  const std::string sim = "sim scene.ply --cameras cameras.json --near 1e6 --no-rtl --no-truth --out odd";
  const Outcome empty = run(sim);
  EXPECT_EQ(empty.code, 0) << empty.err;
  EXPECT_NE(empty.err.find("before the near plane of 1e+06"), std::string::npos) << empty.err;
  EXPECT_EQ(std::count(empty.err.begin(), empty.err.end(), '\n'), 1) << "said twice: " << empty.err;
  const auto findings = nlohmann::json::parse(text("odd/report.json")).at("findings");
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const auto& f) { return f["key"] == "empty_view"; }));
  const Outcome strict = run(sim + " --strict");
  EXPECT_EQ(strict.code, 2);
  EXPECT_NE(strict.err.find("--strict: scene.ply: warning: view "), std::string::npos) << strict.err;
  const Outcome plain = run("sim scene.ply --cameras cameras.json --no-rtl --no-truth --strict --out odd");
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(plain.err, "");
}

TEST_F(Cli, InfoCounts) {
  const Outcome outcome = run("info scene.ply --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["gaussians"], 300);
}

// Of each grid and axis, what share of the Gaussians reaches over a plane; the text and the JSON say the same.
TEST_F(Cli, InfoTellsWhoReachesOverAPlane) {
  const auto margins = nlohmann::json::parse(run("info scene.ply --json").out).at("layers");
  const std::string text = run("info scene.ply").out;
  ASSERT_EQ(margins.size(), 2u);
  for (const auto& margin : margins) {
    std::string line = fmt::format("{} layers: reach over a plane along x, y, z:", margin["grid"].get<int>());
    for (const double share : margin["violators_share"]) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      line += fmt::format(" {:.2f} %", 100 * share);
    }
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
  // More planes are crossed by more.
  for (size_t axis = 0; axis < 3; ++axis)
    EXPECT_GE(margins[1]["violators_share"][axis], margins[0]["violators_share"][axis]);
}

TEST_F(Cli, PackWritesTheImageAndItsHeader) {
  const Outcome outcome = run("pack scene.ply --cameras cameras.json --design dop --out packed");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::ifstream file(folder_ / "packed/scene.h");
  const std::string header{std::istreambuf_iterator<char>(file), {}};
  const std::string size = fmt::format(".size = UINT64_C({}),", fs::file_size(folder_ / "packed/image.bin"));
  EXPECT_NE(header.find(size), std::string::npos) << header;
  EXPECT_NE(header.find("    .window = 64u,\n"), std::string::npos) << header;
  EXPECT_NE(header.find("  .width = 70u,\n  .height = 50u,\n"), std::string::npos) << header;
  Camera narrow = test_camera(70, 50);
  narrow.fx = 20000;
  write_cameras(folder_ / "narrow.json", {narrow});
  expect_refused("pack scene.ply --cameras narrow.json --out no", "the focal length fx is 20000");
  EXPECT_FALSE(fs::exists(folder_ / "no"));
  expect_refused("pack scene.ply --cameras cameras.json --window 0,0 --out no", "--window: found one");
}

TEST_F(Cli, ExplainShowsTheSameAlphaInGoldenAndRtl) {
  const Outcome outcome = run("explain scene.ply --cameras cameras.json --pixel 35,25 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto explained = nlohmann::json::parse(outcome.out);
  ASSERT_FALSE(explained["gaussians"].empty());
  int compared = 0;
  for (const auto& row : explained["gaussians"]) {
    if (row["rtl"].is_null()) continue;
    EXPECT_EQ(row["golden"]["alpha"], row["rtl"]["alpha"]);
    EXPECT_EQ(row["golden"]["weight"], row["rtl"]["weight"]);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST_F(Cli, BadInputIsRefusedInOneLine) {
  expect_refused("sim missing.ply --cameras cameras.json", "missing.ply");
  expect_refused("sim scene.ply --cameras missing.json", "missing.json");
  expect_refused("sim scene.ply --cameras cameras.json --view 7", "--view");
  expect_refused("sim scene.ply --cameras cameras.json --window 9,9", "--window");
  expect_refused("sim scene.ply --cameras cameras.json --set nonsense=3", "nonsense");
  expect_refused("sim scene.ply --cameras cameras.json --set alpha_w=99", "alpha_w");
  expect_refused("sim scene.ply --cameras cameras.json --set alpha_w", "key=value");
  expect_refused("sim scene.ply --cameras cameras.json --set bus_w=64", "bus_w = 64, expected 0, 128, 256 or 512");
  expect_refused("sim scene.ply --cameras cameras.json --design nonsense",
                 "gscore, baseline, dpc, tspp, dop, late, exact, fast");
  expect_refused("sim scene.ply --cameras cameras.json --design ''", "--design: found '', expected a value");
  expect_refused("explain scene.ply --cameras cameras.json --pixel 900,2", "--pixel");
}

TEST_F(Cli, TruncatedAndHostileFilesAreRefused) {
  const std::string whole = text("scene.ply");
  write("cut.ply", whole.substr(0, whole.size() - 100));
  expect_refused("sim cut.ply --cameras cameras.json", "cut.ply");
  write("header.ply", whole.substr(0, 60));
  expect_refused("sim header.ply --cameras cameras.json", "header.ply");
  write("noise.ply", std::string(5000, '\x7f'));
  expect_refused("sim noise.ply --cameras cameras.json", "noise.ply");
  write("cut.json", text("cameras.json").substr(0, 40));
  expect_refused("sim scene.ply --cameras cut.json", "cut.json");
  write("size.json", R"([{"id":0,"img_name":"a","width":-4,"height":50,"position":[0,0,0],)"
                     R"("rotation":[[1,0,0],[0,1,0],[0,0,1]],"fx":50,"fy":50}])");
  expect_refused("sim scene.ply --cameras size.json", "width");
}

}  // namespace
}  // namespace pipegs
