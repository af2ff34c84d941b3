// SPDX-License-Identifier: Apache-2.0
// free_memory: see free_memory.hpp.
#include "scenes/free_memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "scenes/input_error.hpp"
#include "scenes/scene.hpp"
#include "scenes/sh_basis.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

// The number that a file holds; nothing when there is none ("max", or no such file).
std::optional<std::uint64_t> number_in(const char* path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

std::uint64_t free_in_computer() {
  std::ifstream file("/proc/meminfo");
  std::uint64_t kilobytes = 0;
  for (std::string word; file >> word;) {
    if (word == "MemAvailable:" && file >> kilobytes) return kilobytes * 1024;
  }
  return kNoLimit;
}

std::uint64_t free_in_container() {
  const auto limit = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
  return limit && used ? *limit - std::min(*limit, *used) : kNoLimit;
}

std::uint64_t free_in_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  const std::uint64_t used =
      number_in("/proc/self/statm").value_or(0) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}

}  // namespace

std::uint64_t free_memory() { return std::min({free_in_computer(), free_in_container(), free_in_process()}); }

std::uint64_t scene_bytes(std::uint64_t gaussians, int sh_degree) {
  return gaussians * (sizeof(Gaussian) + 3 * sizeof(float) * static_cast<std::uint64_t>(sh_rest_count(sh_degree)));
}

void check_scene_memory(std::uint64_t gaussians, int sh_degree) {
  constexpr std::uint64_t kSmall = std::uint64_t{1} << 24;  // not worth a look
  const std::uint64_t needed = scene_bytes(gaussians, sh_degree);
  if (needed <= kSmall) return;
  const std::uint64_t free = free_memory();
  if (needed <= free) return;
  throw InputError(fmt::format("scene: {} Gaussians would take {:.1f} GB of memory, {:.1f} GB are free", gaussians,
                               static_cast<double>(needed) / 1e9, static_cast<double>(free) / 1e9));
}

}  // namespace pipegs
