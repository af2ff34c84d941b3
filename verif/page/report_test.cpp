// SPDX-License-Identifier: Apache-2.0
// report_test: `pipegs report` of files that are anybody's: broken, foreign and hostile ones are told in one line.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class Report : public Cli {
 protected:
  static Json good() {
    return {
        {"scene", {{"name", "s"}, {"gaussians", 3}}},          {"camera", {{"name", "c"}, {"width", 4}, {"height", 5}}},
        {"config", {{"units", 2}, {"memory", "ideal"}}},       {"cycles", 7},
        {"memory", {{"bytes_read", 1}, {"bytes_written", 2}}}, {"psnr_total_db", 60.5}};
  }
  // The only file of a folder, so there is nothing to show.
  void expect_wrong(const std::string& name, const std::string& contents, const std::string& part) {
    SCOPED_TRACE(name + ": " + contents.substr(0, 200));
    fs::remove_all(folder_ / "results");
    fs::create_directories(folder_ / "results");
    write("results/" + name, contents);
    const Outcome outcome = run("report results");
    expect_one_line(outcome, 2, part);
    EXPECT_FALSE(fs::exists(folder_ / "results/report.html"));
  }
};

TEST_F(Report, AFolderWithoutResultsIsRefused) {
  expect_one_line(run("report missing"), 2, "missing: found no folder");
  expect_one_line(run("report scene.ply"), 2, "scene.ply: found a file");
  fs::create_directories(folder_ / "empty/below");
  expect_one_line(run("report empty"), 2, "empty: found no result, expected report.json");
  expect_one_line(run("report"), 2, "DIR");
  EXPECT_EQ(left_behind().size(), 2u);
}

TEST_F(Report, FilesOfOthersAreNamedWithTheirReason) {
  expect_wrong("report.json", "", "report.json: ");
  expect_wrong("report.json", "{\"scene\":", "report.json: ");
  expect_wrong("report.json", "[]", "expected an object");
  expect_wrong("report.json", "{}", "'scene' is missing");
  expect_wrong("report.json", std::string(100000, '['), "brackets inside each other");
  expect_wrong("report.json", std::string("\xff\xfe{}"), "report.json: ");
  expect_wrong("train.json", "{\"input\": 3}", "input: found");
  expect_wrong("sequence.json", R"({"scene": "s", "views": []})", "expected at least one frame");
  expect_wrong("sequence.json", R"({"scene": "s", "views": {"0": 1}})", "views: found");
}

TEST_F(Report, EveryFieldIsHeldAgainstWhatItMayBe) {
  const Json wrong = {nullptr, true, -1, 1.5, 1e300, "text", Json::array({1}), {{"a", 1}}};
  for (const char* place :
       {"/scene/name", "/scene/gaussians", "/camera/width", "/config/units", "/config/memory", "/cycles",
        "/memory/bytes_read", "/memory", "/psnr_total_db", "/scene", "/camera", "/config"}) {
    const Json::json_pointer pointer(place);
    size_t refused = 0;
    for (const Json& value : wrong) {
      if (value.type() == good()[pointer].type()) continue;
      Json report = good();
      report[pointer] = value;
      fs::remove_all(folder_ / "results");
      fs::create_directories(folder_ / "results");
      write("results/report.json", report.dump());
      // What was not run is null, and any number may be decibels; without npm the page cannot be made.
      const Outcome read = run("report results");
      EXPECT_TRUE(read.code == 0 || read.code == 2 || read.code == 3) << place << " " << value << read.err;
      refused += read.code == 2;
    }
    EXPECT_GE(refused, 4u) << place;
  }
}

}  // namespace
}  // namespace pipegs
