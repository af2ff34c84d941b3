// SPDX-License-Identifier: Apache-2.0
// host_use.hpp: what a run takes of the computer: seconds of processors, most memory.
//
// Idea    Seconds are those of all threads, in the program and in the kernel for it, so that they say the same on a
//         machine that does other work beside. Memory is the largest resident size so far.
#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace pipegs {

// Processor seconds of all threads since the program began.
inline double process_seconds() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(use.ru_utime) + seconds(use.ru_stime);
}

inline uint64_t peak_memory_bytes() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<uint64_t>(use.ru_maxrss) * 1024;  // Linux counts kilobytes
}

}  // namespace pipegs
