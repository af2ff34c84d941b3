// SPDX-License-Identifier: Apache-2.0
// progress.hpp: one line on the terminal that says what is waited for: stage, percent, rate, seconds; time left once
// enough is done.
//
// Every wait of two seconds lies in a stage: that of the command, and inside it what it does now; the innermost shows.
// Quiet when standard error is not a terminal. SIGINT, SIGTERM and SIGHUP turn `interrupted()` true: the stages that
// look at it stop in an orderly way. Whatever still runs a second and a half later, or when a second signal comes, ends
// there: files that are not complete are taken away (atomic_file.hpp), exit code 130.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace pipegs {

class Progress {
 public:
  explicit Progress(std::string stage);
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  // `share` of the work done, 0 to 1; `rate` is free text such as "310 kHz". Safe from several threads.
  void update(double share, const std::string& rate = "");
  // Clears the line that is shown; it comes again. Whoever writes to the terminal calls it before.
  static void hide();

 private:
  using Clock = std::chrono::steady_clock;
  class Stages;
  std::string stage_, rate_;
  double share_ = 0;
  Clock::time_point start_;
  bool terminal_;
};

// The line, `seconds` after the stage's begin.
std::string progress_line(const std::string& stage, double share, const std::string& rate, double seconds);

// Installs the handler of the signals; call once at start.
void watch_interrupts();
bool interrupted();

// Seconds since construction.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace pipegs
