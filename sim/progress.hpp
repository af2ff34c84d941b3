// SPDX-License-Identifier: Apache-2.0
// progress.hpp: one line on the terminal that says how far a long stage is: stage, percent, rate, time left.
//
// Quiet when standard error is not a terminal. SIGINT, SIGTERM and SIGHUP turn `interrupted()` true: the stages that
// look at it stop in an orderly way. Whatever still runs a second and a half later, or when a second signal comes, ends
// there: files that are not complete are taken away (atomic_file.hpp), exit code 130.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace pipegs {

class Progress {
 public:
  explicit Progress(std::string stage);
  ~Progress();  // clears the line
  // `share` of the work done, 0 to 1; `rate` is free text such as "310 kHz". Safe from several threads.
  void update(double share, const std::string& rate = "");

 private:
  using Clock = std::chrono::steady_clock;
  std::string stage_;
  Clock::time_point start_, last_;
  bool terminal_, shown_ = false;
  std::mutex mutex_;
};

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
