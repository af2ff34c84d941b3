// SPDX-License-Identifier: Apache-2.0
// doors_test: the commands that a page of ten minutes shows do run: those that take seconds, on a small picture.
#include <map>
#include <sstream>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class Doors : public Cli {
 protected:
  // Lines of code of a page that run this command of `build/pipegs`, without their comment.
  static std::vector<std::string> lines_of(const std::string& page, const std::string& command) {
    std::ifstream file(fs::path(PIPEGS_SOURCE_DIR) / "docs" / page);
    const std::string begin = "    build/pipegs ";
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
      std::string words = line.substr(0, line.find(" #"));
      words.erase(words.find_last_not_of(' ') + 1);
      if ((words + " ").starts_with(begin + command + " ")) lines.push_back(words.substr(begin.size()));
    }
    return lines;
  }
};

TEST_F(Doors, WhatThePageOfTheArchitectShowsRuns) {
  struct Shown {
    std::string command, smaller;
    size_t least;
  };
  const Shown kShown[] = {{"config", "", 2}, {"what-if", " --scale 0.1", 2}, {"model", " --scale 0.1", 2}};
  for (const Shown& shown : kShown) {
    const std::vector<std::string> lines = lines_of("architect.md", shown.command);
    EXPECT_GE(lines.size(), shown.least) << shown.command;
    for (const std::string& line : lines) {
      const Outcome outcome = run(line + shown.smaller);
      EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
      EXPECT_NE(outcome.out, "") << line;
    }
  }
}

TEST_F(Doors, WhatThePageOfTheRtlEngineerShowsRuns) {
  write_cameras(folder_ / "cameras.json", {test_camera(100, 100)});
  const std::string small = " scene.ply --cameras cameras.json " + smallest_;
  for (const auto& [command, least] : {std::pair{"sim --no-truth", 2}, std::pair{"explain", 1}}) {
    const std::vector<std::string> lines = lines_of("rtl_engineer.md", command);
    EXPECT_GE(lines.size(), static_cast<size_t>(least)) << command;
    for (const std::string& line : lines) {
      const Outcome outcome = run(line + small);
      EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    }
  }
  EXPECT_TRUE(fs::exists(folder_ / "bad/report.json"));
  EXPECT_TRUE(fs::exists(folder_ / "replay/waves.gtkw"));
}

}  // namespace
}  // namespace pipegs
