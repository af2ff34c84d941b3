// SPDX-License-Identifier: Apache-2.0
// progress.cpp: see progress.hpp.
//
// Idea    A signal's handler asks for an alarm: whoever looks at interrupted() has until then to end the program.
#include "sim/progress.hpp"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

#include "scenes/atomic_file.hpp"
#include "sim/run_program.hpp"

namespace pipegs {
namespace {

constexpr itimerval kGrace{.it_interval = {}, .it_value = {.tv_sec = 1, .tv_usec = 500000}};

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

Progress::Progress(std::string stage)
    : stage_(std::move(stage)), start_(Clock::now()), last_(start_), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) write_to_terminal("\r\033[K");
}

void Progress::update(double share, const std::string& rate) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double passed = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0 ? passed * (1 - share) / share : 0;
  write_to_terminal(fmt::format("\r\033[K{:<10} {:5.1f} %  {:>10}  {:.0f} s left", stage_, 100 * share, rate, left));
  shown_ = true;
}

}  // namespace pipegs
