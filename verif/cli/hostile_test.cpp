// SPDX-License-Identifier: Apache-2.0
// hostile_test: files and names that were made to harm: the answer comes at once, in one line that a terminal can show.
//
// Rule    Two seconds and a gigabyte are the most that a small file may take, on a computer that has nothing else to
//         do; here the gigabyte is held by ulimit, and operations are counted by verif/fuzz/linear_test.cpp.
#include <png.h>
#include <sys/resource.h>

#include "cpp_model/float/image.hpp"
#include "scenes/text/quote.hpp"
#include "verif/cli/cli.hpp"
#include "verif/formats/packed_bytes.hpp"

namespace pipegs {
namespace {

class Hostile : public Cli {
 protected:
  // One line of at most 300 characters, none of them a command of a terminal; nothing on standard output.
  void expect_told(const std::string& arguments, const std::string& part) {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments, "ulimit -v 4000000; ");
    expect_one_line(outcome, 2, part);
    EXPECT_EQ(outcome.out, "");
    EXPECT_LE(outcome.err.size(), 300u) << outcome.err;
    EXPECT_EQ(shown(outcome.err, true), outcome.err);
  }
  static std::string repeated(const std::string& item, int count) {
    std::string text = "[" + item;
    for (int i = 1; i < count; ++i) text += "," + item;
    return text + "]";
  }
};

TEST_F(Hostile, AListOfObjectsIsReadAtOnce) {
  write("empty.json", repeated("{}", 80000));
  expect_told("sim --cameras empty.json --no-rtl --out x", "empty.json: [0]: 'width' is missing");
  write("means.json", "{\"means\":" + repeated("{\"a\":[{}]}", 300000) + "}");
  expect_told("info means.json", "means.json: ");
  write("campaign.json", "{\"scenes\":" + repeated("{}", 300000) + "}");
  expect_told("campaign campaign.json --out x", "campaign.json: scenes: found ");
  fs::create_directories(folder_ / "results");
  write("results/report.json", "{\"scene\":" + repeated("{\"a\":{}}", 300000) + "}");
  expect_told("report results", "report.json: scene: found ");
  // Honest ones, 200 000 of them.
  write("many.json", repeated(R"({"img_name":"a","width":64,"height":48,"fx":60,"fy":60,"position":[0,0,-4],)"
                              R"("rotation":[[1,0,0],[0,1,0],[0,0,1]]})",
                              200000));
  const Outcome walk =
      run("sim scene.ply --cameras many.json --views 199998-199999 --no-rtl --no-truth --frames none --out walk");
  EXPECT_EQ(walk.code, 0) << walk.err;
}

TEST_F(Hostile, MoreValuesThanMemoryIsForAreRefused) {
  write("much.json", "{\"means\":" + repeated("{}", 6000000) + "}");
  expect_told("info much.json", "much.json: means[5592402]: found more values than ");
}

TEST_F(Hostile, MessagesHoldNothingThatATerminalTakesForACommand) {
  write("c1.ply", "ply\nformat ascii 1.0\n\xc2\x9b\x33\x31m\xe2\x80\xa8\xe2\x80\xae foo bar\nend_header\n");
  expect_told("info c1.ply", "found '?31m?\?'");
  write("latin1.splat", std::string("dB\x96\xc4\x9b\xf4\xbe\x9b") + std::string(23, '\xc5'));
  expect_told("info latin1.splat", "dB?");
  write("esc.json",
        R"({"version":2,"count":1,"means":{"files":["\u001b]0;a\u0007\u0085",")" + std::string(20000, 'a') + "\"]}}");
  expect_told("info esc.json", "?]0;a??");
  write("long.json", R"({"version":2,"count":1,"means":{"files":[")" + std::string(20000, 'a') + R"(","b"]}})");
  expect_told("info long.json", "aaa");
  expect_told("info " + std::string(3000, 'a'), " ... ");
  // Names that stand in tables.
  write("names.json", R"([{"img_name":"\u001b[31mred\nline\u202e","width":64,"height":48,"fx":60,"fy":60,)"
                      R"("position":[0,0,-4],"rotation":[[1,0,0],[0,1,0],[0,0,1]]}])");
  const Outcome sim = run("sim scene.ply --cameras names.json --no-rtl --no-truth --out o");
  EXPECT_EQ(sim.code, 0) << sim.err;
  EXPECT_NE(sim.out.find("?[31mred?line?"), std::string::npos) << sim.out;
  EXPECT_EQ(shown(sim.out, true), sim.out);
}

TEST_F(Hostile, ArgumentsAreTextsOfOneLine) {
  for (const char* option : {"--size", "--cameras", "--config", "--set", "--design"})
    expect_told("sim --no-rtl --no-truth --out x " + std::string(option) + " ''", option + std::string(": found ''"));
  expect_told("sim scene.ply --no-rtl --no-truth --size= --out x", "--size: found ''");
  expect_told("info ''", "found ''");
  EXPECT_FALSE(fs::exists(folder_ / "x"));
  expect_told("sim" + view_ + "--no-rtl --no-truth --out \"$(printf 'a\\nb')\"",
              "expected one line without control characters");
  expect_told("info \"$(printf 'a\\033b')\"", "'a?b'");
}

// A point of a campaign is one line; what no line can hold is refused, wherever it comes from.
TEST_F(Hostile, NoNameMakesASecondCommand) {
  const std::string evil = "a\ntouch PWNED\nb.ply";
  fs::copy_file(folder_ / "scene.ply", folder_ / evil);
  const auto campaign = [](const std::string& scene) {
    return Json{{"scenes", {{{"name", "s"}, {"scene", scene}, {"size", "64x48"}}}}, {"designs", {"dop"}}}.dump();
  };
  write("c.json", campaign(evil));
  expect_told("campaign c.json --out out", "scenes[0].scene: found ");
  write("c.json", campaign("scene.ply"));
  expect_told("campaign c.json --out \"$(printf 'o\\ntouch PWNED\\n')\"", "control characters");
  // The folder in which it runs, whose name nobody writes.
  fs::create_directories(folder_ / "f\ntouch PWNED\n");
  fs::copy_file(folder_ / "scene.ply", folder_ / "f\ntouch PWNED\n/scene.ply");
  write("f\ntouch PWNED\n/c.json", campaign("scene.ply"));
  const Outcome inside = shell("cd f*PWNED* && '" PIPEGS_BINARY "' campaign c.json --out out");
  EXPECT_EQ(inside.code, 2) << inside.err;
  EXPECT_EQ(std::count(inside.err.begin(), inside.err.end(), '\n'), 1) << inside.err;
  for (const std::string& name : left_behind()) EXPECT_EQ(name.find("lines.txt"), std::string::npos) << name;
}

// A black picture of so many pixels, which takes a thousandth of them as a file.
void write_black(const fs::path& path, int side) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png.height = static_cast<png_uint_32>(side);
  png.format = PNG_FORMAT_GRAY;
  const std::vector<unsigned char> black(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  ASSERT_NE(png_image_write_to_file(&png, path.c_str(), 0, black.data(), 0, nullptr), 0);
}

TEST_F(Hostile, AReportHoldsNoPictureWhole) {
  const Json report = {
      {"scene", {{"name", "s"}, {"gaussians", 3}}},          {"camera", {{"name", "c"}, {"width", 4}, {"height", 5}}},
      {"config", {{"units", 2}, {"memory", "ideal"}}},       {"cycles", 7},
      {"memory", {{"bytes_read", 1}, {"bytes_written", 2}}}, {"psnr_total_db", 60.5}};
  for (int i = 0; i < 12; ++i) {
    const std::string name = "results/r" + std::to_string(i) + (i == 0 ? "\x1b[31m" : "");
    fs::create_directories(folder_ / name);
    write(name + "/report.json", report.dump());
    if (i == 0) write(name + "/frame.png", "no picture");
    else if (i == 1) write_black(folder_ / name / "frame.png", 6000);
    else fs::copy_file(folder_ / "results/r1/frame.png", folder_ / name / "frame.png");
  }
  const Outcome outcome = run("report results", "ulimit -v 1500000; ");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("12 results in "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("left out: results/r2/frame.png: found 6000x6000 pixels"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(shown(outcome.out, true), outcome.out);
}

// One texture under six names counts once.
TEST_F(Hostile, BytesThatAreNamedOftenCountOnce) {
  const int side = 1000;
  const std::string texture = webp(side, side, std::vector<std::uint8_t>(4 * side * side, 128));
  fs::create_directories(folder_ / "sog");
  const std::string padding(static_cast<std::size_t>(side) * side * 28 / 192, '\0');
  Json meta = {{"version", 2}, {"count", side * side}};
  meta["means"] = {{"mins", {-1, -1, -1}}, {"maxs", {1, 1, 1}}};
  for (const char* key : {"scales", "sh0"}) meta[key]["codebook"] = std::vector<double>(256);
  int number = 0;
  for (const auto& [key, files] : {std::pair{"means", 2}, {"scales", 1}, {"quats", 1}, {"sh0", 1}}) {
    for (int i = 0; i < files; ++i) {
      const std::string name = "t" + std::to_string(number++) + ".webp";
      write("sog/" + name, texture + padding);
      meta[key]["files"].push_back(name);
    }
  }
  write("sog/meta.json", meta.dump());
  expect_told("info sog", "at most 32 times as many");
  for (const char* key : {"means", "scales", "quats", "sh0"}) {
    for (auto& name : meta[key]["files"]) name = "t0.webp";
  }
  write("sog/meta.json", meta.dump());
  expect_told("info sog", "at most 32 times as many");
}

}  // namespace
}  // namespace pipegs
