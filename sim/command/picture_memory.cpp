// SPDX-License-Identifier: Apache-2.0
// picture_memory.cpp: see picture_memory.hpp.
#include "sim/command/picture_memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kNoLimit = std::numeric_limits<uint64_t>::max();

// The number that a file holds; nothing when there is none ("max", or no such file).
std::optional<uint64_t> number_in(const char* path) {
  std::ifstream file(path);
  uint64_t number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

uint64_t free_in_computer() {
  std::ifstream file("/proc/meminfo");
  uint64_t kilobytes = 0;
  for (std::string word; file >> word;) {
    if (word == "MemAvailable:" && file >> kilobytes) return kilobytes * 1024;
  }
  return kNoLimit;
}

uint64_t free_in_container() {
  const auto limit = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
  return limit && used ? *limit - std::min(*limit, *used) : kNoLimit;
}

uint64_t free_in_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  const uint64_t used = number_in("/proc/self/statm").value_or(0) * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<uint64_t>(limit.rlim_cur, used);
}

}  // namespace

uint64_t free_memory() { return std::min({free_in_computer(), free_in_container(), free_in_process()}); }

void check_picture_memory(const Camera& camera, const SimulateOptions& options, const PixelBytes& bytes) {
  const auto width = static_cast<uint64_t>(camera.width), height = static_cast<uint64_t>(camera.height);
  const PixelRect r = asked_pixels(camera.width, camera.height, options);
  const uint64_t asked = static_cast<uint64_t>(r.x1 - r.x0) * static_cast<uint64_t>(r.y1 - r.y0);
  const uint64_t needed = width * height * bytes.frame + asked * bytes.asked;
  const uint64_t free = free_memory();
  if (needed <= free) return;
  throw InputError(fmt::format("camera {}: {}x{} pixels would take {} bytes ({:.1f} GB) of memory, {:.1f} GB are free",
                               quote(camera.name), camera.width, camera.height, needed,
                               static_cast<double>(needed) / 1e9, static_cast<double>(free) / 1e9));
}

}  // namespace pipegs
