// SPDX-License-Identifier: Apache-2.0
// progress.cpp: see progress.hpp.
//
// Idea    A signal's handler asks for an alarm: whoever looks at interrupted() has until then to end the program. A
//         thread of the outermost stage draws the line of the innermost one again, so that a stage which never says
//         how far it is shows its name and the seconds, too.
#include "sim/progress.hpp"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "scenes/atomic_file.hpp"
#include "scenes/text/quote.hpp"
#include "sim/run_program.hpp"

namespace pipegs {
namespace {

constexpr itimerval kGrace{.it_interval = {}, .it_value = {.tv_sec = 1, .tv_usec = 500000}};

using namespace std::chrono_literals;

constexpr auto kBetweenLines = 100ms, kBetweenTicks = 500ms, kSilence = 1000ms;
constexpr double kLeastSeconds = 2, kLeastShare = 0.05;  // before time is said to be left
constexpr size_t kColumns = 79;                          // a line that wraps could not be cleared

volatile std::sig_atomic_t g_interrupted = 0;
bool g_terminal = false;

void write_to_terminal(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<size_t>(written));
  }
}

void end_now(int) {
  kill_programs();
  abandon_files();
  if (g_terminal) write_to_terminal("\r\033[K");
  write_to_terminal("pipegs: interrupted\n");
  std::_Exit(130);
}

void note(int signal) {
  if (g_interrupted != 0) end_now(signal);  // the second one does not wait
  g_interrupted = 1;
  setitimer(ITIMER_REAL, &kGrace, nullptr);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void watch_interrupts() {
  g_terminal = isatty(STDERR_FILENO) != 0;
  handle(SIGALRM, end_now);
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, note);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) handle(SIGHUP, note);  // else it is nohup's
}

bool interrupted() { return g_interrupted != 0; }

std::string progress_line(const std::string& stage, double share, const std::string& rate, double seconds) {
  std::string line = stage;
  if (share > 0) line += fmt::format("  {:.1f} %", 100 * share);
  if (!rate.empty()) line += "  " + rate;
  // What the first percents took says nothing of the rest.
  const bool foreseen = seconds >= kLeastSeconds && share >= kLeastShare;
  line += foreseen ? fmt::format("  {:.0f} s left", seconds * (1 - share) / share) : fmt::format("  {:.0f} s", seconds);
  return shortened(one_line(line), kColumns);
}

// The stages that run, the innermost last, and the thread that draws while there are any.
class Progress::Stages {
 public:
  static Stages& all() {
    static Stages stages;
    return stages;
  }
  void begin(Progress& stage) {
    const std::lock_guard lock(mutex_);
    if (running_.empty()) clock_ = std::jthread([this](const std::stop_token& stop) { draw(stop); });
    running_.push_back(&stage);
  }
  void end(Progress& stage) {
    std::jthread last;  // ends when nobody holds the lock
    const std::lock_guard lock(mutex_);
    clear();
    std::erase(running_, &stage);
    if (running_.empty()) last = std::move(clock_);
  }
  void update(Progress& stage, double share, const std::string& rate) {
    const std::lock_guard lock(mutex_);
    stage.share_ = share, stage.rate_ = rate;
    if (running_.back() == &stage && Clock::now() - drawn_ >= kBetweenLines) show(stage);
  }
  void hide() {
    const std::lock_guard lock(mutex_);
    clear();
  }

 private:
  void draw(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      wake_.wait_for(lock, stop, kBetweenLines, [] { return false; });
      if (running_.empty() || Clock::now() - drawn_ < kBetweenTicks) continue;
      if (Clock::now() - running_.back()->start_ >= kSilence) show(*running_.back());
    }
  }
  void show(const Progress& stage) {
    drawn_ = Clock::now();
    const double seconds = std::chrono::duration<double>(drawn_ - stage.start_).count();
    write_to_terminal("\r\033[K" + progress_line(stage.stage_, stage.share_, stage.rate_, seconds));
    shown_ = true;
  }
  void clear() {
    if (shown_) write_to_terminal("\r\033[K");
    shown_ = false;
  }

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Progress*> running_;
  Clock::time_point drawn_ = Clock::now();
  bool shown_ = false;
  std::jthread clock_;
};

Progress::Progress(std::string stage)
    : stage_(std::move(stage)), start_(Clock::now()), terminal_(isatty(STDERR_FILENO) != 0) {
  if (terminal_) Stages::all().begin(*this);
}

Progress::~Progress() {
  if (terminal_) Stages::all().end(*this);
}

void Progress::update(double share, const std::string& rate) {
  if (terminal_) Stages::all().update(*this, share, rate);
}

void Progress::hide() { Stages::all().hide(); }

}  // namespace pipegs
