// SPDX-License-Identifier: Apache-2.0
// outputs_test: what cannot be written is told before anything is computed, and nothing is left behind; a broken
// picture to compare with is told as early.
//
// Idea    The scene of these commands does not exist: that the output is refused, not the scene, shows what is tried
//         first.
#include <sys/stat.h>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class Outputs : public Cli {
 protected:
  const std::string none_ = " missing.ply --cameras cameras.json ";

  // Every option that names what is written: a folder or a file.
  const std::vector<std::string> folders_ = {"sim" + none_ + "--out ",
                                             "render" + none_ + "--out ",
                                             "ladder" + none_ + "--out ",
                                             "accuracy" + none_ + "--out ",
                                             "accuracy" + none_ + "--store ",
                                             "silicon" + none_ + "--out ",
                                             "silicon" + none_ + "--store ",
                                             "what-if" + none_ + "--set units=2 --out ",
                                             "config --out ",
                                             "study profile" + none_ + "--out ",
                                             "study tradeoff" + none_ + "--out ",
                                             "study tradeoff" + none_ + "--store ",
                                             "study shapes" + none_ + "--out ",
                                             "study shapes" + none_ + "--store ",
                                             "study rivals" + none_ + "--out ",
                                             "study budget --count 10 --out ",
                                             "study stress --count 1 --no-rtl --out ",
                                             "pack" + none_ + "--out ",
                                             "convert missing.ply --out ",
                                             "train" + none_ + "--out ",
                                             "point" + none_ + "--store ",
                                             "campaign missing.json --out "};

  void expect_unwritable(const std::string& arguments, const std::string& part) {
    SCOPED_TRACE(arguments);
    expect_one_line(run(arguments), 2, "cannot be written: " + part);
  }
};

TEST_F(Outputs, AFolderThatIsAFileIsRefused) {
  for (const std::string& command : folders_) {
    expect_unwritable(command + "scene.ply", "'scene.ply");
    expect_unwritable(command + "scene.ply/below", "'scene.ply' is a file, expected a folder");
  }
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

TEST_F(Outputs, AFolderInWhichNothingCanBeMadeIsRefused) {
  for (const std::string& command : folders_) expect_unwritable(command + "/proc/pictures", "nothing can be made in");
  const std::string longest(300, 'a');
  expect_unwritable(folders_.front() + longest, "found a name of 300 bytes, expected at most 255");
}

// The name of one of the files in --out is taken by a folder.
TEST_F(Outputs, AFileWhoseNameIsTakenIsRefused) {
  for (const char* taken :
       {"frame.exr", "frame.png", "report.json", "dop/report.json", "accuracy.json", "budget.json", "cameras.json"}) {
    SCOPED_TRACE(taken);
    fs::remove_all(folder_ / "taken");
    const std::string name = taken;
    fs::create_directories(folder_ / "taken" / name);
    const std::string command = name == "dop/report.json" ? "ladder" + none_ + "--designs dop"
                                : name == "accuracy.json" ? "accuracy" + none_
                                : name == "budget.json"   ? std::string("study budget --count 10")
                                : name == "cameras.json"  ? std::string("study stress --no-rtl")
                                                          : "sim" + none_;
    expect_unwritable(command + " --out taken", "'taken/" + name);
  }
}

TEST_F(Outputs, FoldersThatAreMissingAreMade) {
  const std::string view = " scene.ply --cameras cameras.json ";
  for (const std::string& arguments :
       {"sim" + view + "--no-rtl --no-truth --out a/b", "render" + view + "--out c/d",
        std::string("convert scene.ply --out g/h"), std::string("study budget --count 10 --out i"),
        "sim" + view + smallest_ + "--window 0,0 --no-truth --out k/l --waves"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
  }
  for (const char* name : {"a/b/report.json", "c/d/frame.png", "g/h/scene.ply", "i/budget.json", "k/l/waves.fst"})
    EXPECT_TRUE(fs::is_regular_file(folder_ / name)) << name;
}

TEST_F(Outputs, WhatIsReadAtTheEndIsReadFirst) {
  const std::string view = "render scene.ply --cameras cameras.json --out pictures ";
  expect_refused(view + "--compare scene.ply", "scene.ply: cannot read");
  ASSERT_EQ(run("render scene.ply --cameras cameras.json --design dop --window 1,0 --out small").code, 0);
  expect_refused(view + "--compare small/frame.png", "found 6x50 pixels, expected 70x50");
}

TEST_F(Outputs, APictureToCompareWithIsAFileThatHoldsItsPixels) {
  const std::string compare = "render scene.ply --cameras cameras.json --out pictures --compare ";
  expect_refused(compare + "missing.png", "found no file, expected a .png file");
  expect_refused(compare + ".", "found a folder");
  expect_refused(compare + "/dev/zero", "found a device");
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  expect_refused(compare + "pipe", "found a pipe");
  ASSERT_EQ(run("render scene.ply --cameras cameras.json --out whole").code, 0);
  std::string png = text("whole/frame.png");
  write("short.png", png.substr(0, png.size() / 2));
  expect_refused(compare + "short.png", "short.png: cannot read");
  // A header of 16384x16384 pixels, 805 MB, before the data of 70x50.
  static constexpr unsigned char kHuge[] = {0, 0, 0x40, 0, 0, 0, 0x40, 0, 8, 2, 0, 0, 0, 0x26, 0xaa, 0x87, 0xd3};
  png.replace(16, sizeof kHuge, reinterpret_cast<const char*>(kHuge), sizeof kHuge);
  write("huge.png", png);
  expect_refused(compare + "huge.png", "found 16384x16384 pixels, expected ");
}

}  // namespace
}  // namespace pipegs
