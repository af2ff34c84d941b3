// SPDX-License-Identifier: Apache-2.0
// signals_test: a program that is told to end ends within two seconds, with 130 and nothing half-written; disks that
// are full, caches that are cut, users who may only read.
#include <unistd.h>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class Signals : public Cli {
 protected:
  // Sends the signal `after` seconds after the start; the code is 130 and nothing is left but files that are whole.
  void expect_ended(const std::string& arguments, const std::string& signal, double after) {
    SCOPED_TRACE(arguments + ", " + signal);
    const Outcome outcome = signalled(arguments, signal, after);
    EXPECT_EQ(outcome.code, 130) << outcome.out << outcome.err;
    EXPECT_LT(std::stoi(text("took")), slack_) << "ms";
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    for (int i = 0; i < 40 && !running_here().empty(); ++i) usleep(50000);  // a program that is killed takes a while
    EXPECT_EQ(running_here(), std::vector<std::string>{});
    for (const std::string& name : left_behind()) EXPECT_EQ(name.find(".pipegs."), std::string::npos) << name;
    fs::remove(folder_ / "took");
    fs::remove_all(folder_ / "x");
  }
  // The program after a signal; on a computer on which it had ended by then, the signal comes earlier.
  Outcome signalled(const std::string& arguments, const std::string& signal, double after) {
    const Outcome outcome =
        shell("'" PIPEGS_BINARY "' " + arguments + " & p=$!; sleep " + std::to_string(after) + "; kill -" + signal +
              " $p; t=$(date +%s%N); wait $p; c=$?; echo $((($(date +%s%N) - t) / 1000000)) > took; exit $c");
    if (after < 0.01 || outcome.err.find("No such process") == std::string::npos) return outcome;
    fs::remove_all(folder_ / "x");
    return signalled(arguments, signal, after / 2);
  }
  // Programs that were started here.
  std::vector<std::string> running_here() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::error_code error;
      if (fs::read_symlink(entry.path() / "cwd", error) == folder_) found.push_back(entry.path());
    }
    return found;
  }
  // Two seconds on a computer that has nothing else to do; this one runs other tests beside.
  const int slack_ = 10000;
};

TEST_F(Signals, EveryCommandEndsAtOnce) {
  write_ply(folder_ / "scene.ply", random_scene(1, 300000, 3));
  write_cameras(folder_ / "cameras.json", {test_camera(1900, 1100)});
  const std::string view = " scene.ply --cameras cameras.json ";
  for (const std::string& arguments :
       std::vector<std::string>{"info" + view.substr(0, 11), "convert scene.ply --out x", "pack" + view + "--out x",
                                "render" + view + "--model truth --out x", "effects" + view, "model" + view,
                                "sim" + view + "--no-rtl --out x", "sim" + view + "--views 0-0 --no-rtl --out x"})
    expect_ended(arguments, "TERM", 0.3);
  for (const char* signal : {"INT", "HUP"}) expect_ended("render" + view + "--model truth --out x", signal, 0.3);
}

// Who started it with nohup wants it to go on.
TEST_F(Signals, AHangupThatIsIgnoredStaysSo) {
  const Outcome outcome = shell("trap '' HUP; '" PIPEGS_BINARY
                                "' render scene.ply --cameras cameras.json --model truth --out x & p=$!; "
                                "kill -HUP $p; wait $p");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

// The build's processes end, too, and no further design point begins.
TEST_F(Signals, ABuildEndsWithTheProgram) {
  const std::string rare = "--set units=1 --set alpha_lines=64 --set records=32 ",
                    view = " scene.ply --cameras cameras.json ";
  for (const char* signal : {"INT", "TERM", "HUP"})
    expect_ended("ladder" + view + rare + "--designs late,dop --no-truth --out x", signal, 2);
}

TEST_F(Signals, WavesThatTheDiskDoesNotTakeAreNotThere) {
  const std::string sim =
      "sim scene.ply --cameras cameras.json " + smallest_ + "--window 0,0 --no-truth --waves --out ";
  ASSERT_EQ(run(sim + "whole").code, 0);
  const auto bytes = fs::file_size(folder_ / "whole/waves.fst");
  ASSERT_GT(bytes, 40000u);
  fs::remove_all(folder_ / "whole");
  const Outcome full = run(sim + "cut", "trap '' XFSZ; ulimit -f 16; ");
  expect_one_line(full, 3, "the waves cannot be written: File too large");
  for (const std::string& name : left_behind()) EXPECT_EQ(name.find("waves"), std::string::npos) << name;
  EXPECT_FALSE(fs::exists(folder_ / "cut/report.json"));
}

TEST_F(Signals, AMessageThatCannotBeWrittenChangesNoExitCode) {
  for (const char* closed : {"2>&-", "2>/dev/full", "2>&- <&-"}) {
    EXPECT_EQ(shell("'" PIPEGS_BINARY "' info nothing " + std::string(closed)).code, 2) << closed;
    EXPECT_EQ(shell("'" PIPEGS_BINARY "' info scene.ply " + std::string(closed)).code, 0) << closed;
  }
  for (const char* closed : {">&-", ">/dev/full"}) {
    for (const char* command : {"info scene.ply", "--help", "info --help", "--version"})
      EXPECT_EQ(shell("'" PIPEGS_BINARY "' " + std::string(command) + " " + closed).code, 3) << command << closed;
  }
}

// A library that is not as it was built, here a file that says it were one.
TEST_F(Signals, ALibraryIsWhatItsSumSays) {
  const std::string fresh =
      "'" PIPEGS_SOURCE_DIR "/sim/rtl/build_rtl.sh' \"$(dirname '" PIPEGS_BINARY "')\" lib +fresh";
  EXPECT_EQ(shell(fresh).code, 1);
  fs::create_directories(folder_ / "lib");
  write("lib/librtl.so", std::string(100000, 'a'));
  EXPECT_EQ(shell(fresh).code, 1) << "without a sum";
  ASSERT_EQ(shell("cksum < lib/librtl.so > lib/librtl.sum").code, 0);
  EXPECT_EQ(shell(fresh).code, 0);
  const auto made = fs::last_write_time(folder_ / "lib/librtl.so");
  for (const std::string& bytes : {std::string(4096, 'a'), std::string(99999, 'a') + "b"}) {
    write("lib/librtl.so", bytes);
    fs::last_write_time(folder_ / "lib/librtl.so", made);
    EXPECT_EQ(shell(fresh).code, 1) << bytes.size();
  }
  EXPECT_EQ(left_behind().size(), 3u) << "it only looks";
}

TEST_F(Signals, WhoMayOnlyReadUsesWhatIsBuilt) {
  if (shell("setpriv --reuid=65534 --clear-groups test -x '" PIPEGS_BINARY "'").code != 0)
    GTEST_SKIP() << "not root, or nobody may not read the build";
  const std::string sim =
      "sim '" + folder_.string() + "/scene.ply' --cameras '" + folder_.string() + "/cameras.json' --no-truth ";
  ASSERT_EQ(run(sim + smallest_ + "--out mine").code, 0);
  fs::permissions(folder_, fs::perms::all);
  const Outcome other =
      shell("setpriv --reuid=65534 --clear-groups '" PIPEGS_BINARY "' " + sim + smallest_ + "--out other");
  EXPECT_EQ(other.code, 0) << other.err;
  const Outcome unbuilt = shell("setpriv --reuid=65534 --clear-groups '" PIPEGS_BINARY "' " + sim +
                                "--design dop --set units=1 --set alpha_lines=128 --set records=48 --out no");
  EXPECT_EQ(unbuilt.code, 3);
  EXPECT_NE(unbuilt.err.find("nothing can be written in"), std::string::npos) << unbuilt.err;
}

// Links under every name that could be guessed: the file behind them stays.
TEST_F(Signals, NoLinkIsFollowed) {
  write("victim.txt", "precious\n");
  fs::create_directories(folder_ / "o");
  for (pid_t next = getpid(); next < getpid() + 3000; ++next) {
    for (const std::string& name :
         {".pipegs." + std::to_string(next), "report.json.tmp." + std::to_string(next) + ".0"})
      fs::create_symlink("../victim.txt", folder_ / "o" / name);
  }
  fs::create_symlink("../victim.txt", folder_ / "o/frame.exr");
  EXPECT_EQ(run("sim scene.ply --cameras cameras.json --no-rtl --no-truth --out o").code, 0);
  EXPECT_EQ(text("victim.txt"), "precious\n");
}

TEST_F(Signals, NamesAreTriedBeforeTheWork) {
  for (const int length : {230, 241, 255}) {
    const std::string name(static_cast<std::size_t>(length), 'x');
    EXPECT_EQ(run("convert scene.ply --out " + name).code, 0) << length;
    EXPECT_TRUE(fs::exists(folder_ / name / "scene.ply"));
  }
  fs::create_symlink("/no/such/folder", folder_ / "dangling");
  expect_one_line(run("sim missing.ply --no-rtl --no-truth --out dangling"), 2, "is a link to nothing");
  expect_one_line(run("render missing.ply --out dangling/below"), 2, "is a link to nothing");
}

}  // namespace
}  // namespace pipegs
