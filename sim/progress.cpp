// SPDX-License-Identifier: Apache-2.0
// progress.cpp: see progress.hpp.
#include "sim/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace pipegs {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

}  // namespace

void watch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) {
      if (g_interrupted) std::_Exit(130);  // the second one does not wait
      g_interrupted = 1;
    });
  }
}

bool interrupted() { return g_interrupted != 0; }

Progress::Progress(std::string stage)
    : stage_(std::move(stage)), start_(Clock::now()), last_(start_), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::update(double share, const std::string& rate) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double passed = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0 ? passed * (1 - share) / share : 0;
  fmt::print(stderr, "\r\033[K{:<10} {:5.1f} %  {:>10}  {:.0f} s left", stage_, 100 * share, rate, left);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace pipegs
