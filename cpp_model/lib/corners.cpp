// SPDX-License-Identifier: Apache-2.0
// corners.cpp: see corners.hpp.
#include "cpp_model/lib/corners.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace pipegs {

namespace {

bool legal(const Config& config) {
  try {
    config_check(config);
    return true;
  } catch (const ConfigError&) { return false; }
}

}  // namespace

Config config_corner(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<uint64_t>(n)); };
  Config config;
  std::vector<ConfigEntry> entries = config_entries(config);
  std::erase_if(entries, [](const ConfigEntry& entry) { return entry.member == nullptr; });
  for (int round = 0; round < 2; ++round) {
    for (size_t i = entries.size(); i > 1; --i) std::swap(entries[i - 1], entries[random() % i]);
    for (const ConfigEntry& entry : entries) {
      const int between = entry.low + below(entry.high - entry.low + 1), choice = below(3);
      const int value = choice == 0 ? entry.low : choice == 1 ? entry.high : between;
      // A count that must be a power of two is seldom one by chance.
      for (const int tried : {value, std::max(entry.low, power_floor(value))}) {
        Config next = config;
        next.*entry.member = tried;
        if (!legal(next)) continue;
        config = next;
        break;
      }
    }
  }
  return config;
}

std::string config_arguments(const Config& config) {
  std::string text = config_difference(config);
  std::replace(text.begin(), text.end(), ',', ' ');
  return text == "default" ? "" : text;
}

}  // namespace pipegs
