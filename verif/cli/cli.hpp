// SPDX-License-Identifier: Apache-2.0
// cli.hpp: the fixture of the command line's tests: a folder with a small scene, and `pipegs` run in it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {

namespace fs = std::filesystem;

struct Outcome {
  int code;
  std::string out, err;
};

class Cli : public testing::Test {
 protected:
  // Of the machines that tests build the one that compiles soonest, for whoever needs another variant of one: waves.
  const std::string smallest_ = "--design dop --set units=1 --set pace=4 --set alpha_lines=64 --set records=16 ";

  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("pipegs_cli_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    write_ply(folder_ / "scene.ply", random_scene(1, 300, 1));
    write_cameras(folder_ / "cameras.json", {test_camera(70, 50)});
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments, const std::string& environment = "") {
    return shell(environment + "'" PIPEGS_BINARY "' " + arguments);
  }
  Outcome shell(const std::string& line) {
    const int status = std::system(("cd '" + folder_.string() + "' && { " + line + "\n} > out.txt 2> err.txt").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text("out.txt"), text("err.txt")};
  }
  std::string text(const std::string& name) {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(const std::string& name, const std::string& contents) {
    std::ofstream(folder_ / name, std::ios::binary) << contents;
  }

  // This exit code, and one line that holds `part`.
  static void expect_one_line(const Outcome& outcome, int code, const std::string& part) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << "'" << part << "' is not in: " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  // Exit 2, one line that holds `part`, no picture.
  void expect_refused(const std::string& arguments, const std::string& part) {
    SCOPED_TRACE(arguments);
    expect_one_line(run(arguments + (arguments.starts_with("sim") ? " --out pictures" : "")), 2, part);
    EXPECT_FALSE(fs::exists(folder_ / "pictures")) << "something was left behind";
  }
  // All that lies in the folder, but what every test puts there.
  std::vector<std::string> left_behind() const {
    std::vector<std::string> names;
    for (const auto& file : fs::recursive_directory_iterator(folder_)) {
      const std::string name = fs::relative(file.path(), folder_).string();
      if (name != "scene.ply" && name != "cameras.json" && name != "out.txt" && name != "err.txt")
        names.push_back(name);
    }
    return names;
  }

  fs::path folder_;
};

}  // namespace pipegs
