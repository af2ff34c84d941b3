// SPDX-License-Identifier: Apache-2.0
// progress_test: who waits on a terminal reads what for, and no time that is made up; who reads a pipe gets nothing.
//
// Idea    The terminal is a pseudo terminal. A command that must wait finds the folder of its machine locked, as by
//         another build.
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/file.h>

#include <csignal>

#include "cpp_model/config.hpp"
#include "sim/progress.hpp"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

constexpr int kPatience = 20000;  // ms, many times what it takes

// A terminal as standard error of this process.
class Terminal {
 public:
  Terminal() : own_(dup(STDERR_FILENO)) {
    int terminal = -1;
    EXPECT_EQ(openpty(&screen_, &terminal, nullptr, nullptr, nullptr), 0);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
  }
  ~Terminal() {
    dup2(own_, STDERR_FILENO);
    close(own_);
    close(screen_);
  }
  // Whether the screen shows `part` within some time.
  bool shows(const std::string& part) {
    pollfd ready = {.fd = screen_, .events = POLLIN, .revents = 0};
    while (text_.find(part) == std::string::npos) {
      char bytes[4096];
      if (poll(&ready, 1, kPatience) <= 0) return false;
      const ssize_t count = read(screen_, bytes, sizeof bytes);
      if (count <= 0) return false;
      text_.append(bytes, static_cast<size_t>(count));
    }
    return true;
  }
  void forget() { text_.clear(); }
  const std::string& text() const { return text_; }

 private:
  int own_, screen_ = -1;
  std::string text_;
};

TEST(ProgressLine, NoTimeIsLeftBeforeEnoughIsDone) {
  EXPECT_EQ(progress_line("RTL", 0.001, "310 kHz", 5), "RTL  0.1 %  310 kHz  5 s") << "not 4995 s left";
  EXPECT_EQ(progress_line("RTL", 0.5, "310 kHz", 1), "RTL  50.0 %  310 kHz  1 s");
  EXPECT_EQ(progress_line("RTL", 0.25, "310 kHz", 10), "RTL  25.0 %  310 kHz  30 s left");
  EXPECT_EQ(progress_line("packing", 0, "", 3), "packing  3 s") << "nobody knows how far it is";
}

TEST(ProgressLine, ItFitsAScreenAndMovesNoCursor) {
  EXPECT_LE(progress_line(std::string(300, 'x'), 0.5, "", 10).size(), 79u);
  EXPECT_EQ(progress_line("a\x1b[2J", 0, "", 3), "a?[2J  3 s");
}

TEST(Progress, TheInnermostStageShowsThoughItSaysNothing) {
  Terminal terminal;
  const Progress outer("outer wait");
  {
    const Progress inner("inner wait");
    EXPECT_TRUE(terminal.shows("inner wait  1 s")) << terminal.text();
    EXPECT_EQ(terminal.text().find("outer"), std::string::npos) << terminal.text();
  }
  terminal.forget();
  EXPECT_TRUE(terminal.shows("outer wait")) << terminal.text();
}

TEST(Progress, ItIsClearedBeforeOthersWrite) {
  Terminal terminal;
  Progress stage("a stage");
  ASSERT_TRUE(terminal.shows("a stage"));
  terminal.forget();
  Progress::hide();
  EXPECT_TRUE(terminal.shows("\r\x1b[K"));
}

class Waits : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    Config machine;  // that no other test has
    machine.units = 1, machine.alpha_lines = 64, machine.records = 48;
    place_ = fs::path(PIPEGS_BINARY).parent_path() / "rtl" / config_difference(machine);
    fs::remove_all(place_);  // what a test left that was killed
    fs::create_directories(place_);
    lock_ = open((place_ / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    ASSERT_EQ(flock(lock_, LOCK_EX), 0);
  }
  void TearDown() override {
    close(lock_);
    fs::remove_all(place_);
    Cli::TearDown();
  }
  // Starts a command in the folder, on this process's standard error.
  pid_t start(const std::string& arguments) {
    const std::string line = "cd '" + folder_.string() + "' && exec '" PIPEGS_BINARY "' " + arguments + " > out.txt";
    const pid_t program = fork();
    if (program == 0) {
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    return program;
  }

  fs::path place_;
  int lock_ = -1;
};

TEST_F(Waits, ACommandThatBuildsAMachineSaysSo) {
  write("campaign.json", R"({"scenes": [{"name": "one", "scene": "scene.ply", "cameras": "cameras.json"}],
    "engine": "rtl", "designs": ["dop"],
    "configurations": [{"name": "small", "set": ["units=1", "alpha_lines=64", "records=48"]}]})");
  const std::string view = " scene.ply --cameras cameras.json ",
                    machine = "--set units=1 --set alpha_lines=64 --set records=48 ";
  for (const std::string& command :
       {"sim" + view + "--design dop " + machine, "explain" + view + "--pixel 1,1 --design dop " + machine,
        "ladder" + view + machine + "--designs dop", "model" + view + "--check --design dop " + machine,
        std::string("campaign campaign.json --out lines")}) {
    Terminal terminal;
    const pid_t program = start(command);
    ASSERT_GT(program, 0);  // -1 would be everybody
    EXPECT_TRUE(terminal.shows("building the RTL  1 s")) << command << "\n" << terminal.text();
    kill(program, SIGTERM);
    int status = 0;
    waitpid(program, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 130) << terminal.text();
  }
}

}  // namespace
}  // namespace pipegs
