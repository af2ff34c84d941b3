// SPDX-License-Identifier: Apache-2.0
// neighbours.cpp: see neighbours.hpp.
#include "sim/studies/shapes/neighbours.hpp"

#include <algorithm>

namespace pipegs {
namespace {

bool belongs(const Config& config, const ShapeEntry& entry) {
  if (entry.member == &Config::nearest_nodes || entry.member == &Config::mark_chunks) return config.has_watermarks();
  if (entry.member == &Config::bus_w) return config.bus_w != 0;
  return entry.member != &Config::window || config.window >= 64;
}

bool legal(const Config& config) {
  try {
    config_check(config);
  } catch (const ConfigError&) { return false; }
  return true;
}

}  // namespace

const std::vector<ShapeEntry>& shape_entries() {
  static const std::vector<ShapeEntry> kEntries = {
      {"units", &Config::units, {1, 2, 4}},
      {"fronts", &Config::fronts, {1, 2, 4}},
      {"window", &Config::window, {64, 128}},
      {"tests", &Config::tests, {1, 2}},
      {"records", &Config::records, {704, 1024, 1408, 2048, 2816}},
      {"bucket_bits", &Config::bucket_bits, {3, 4, 5, 6}},
      {"nearest_nodes", &Config::nearest_nodes, {256, 512, 1024, 2048}},
      {"mark_chunks", &Config::mark_chunks, {4, 7, 8, 12}},
      {"bus_w", &Config::bus_w, {128, 256, 512}},
  };
  return kEntries;
}

Config with_shape(const Config& config, const ShapeEntry& entry, int value) {
  Config changed = config;
  changed.*entry.member = value;
  changed.fronts = changed.pu_fronts();
  return belongs(config, entry) && legal(changed) ? changed : config;
}

std::vector<Neighbour> neighbours(const Config& config) {
  std::vector<Neighbour> found;
  Config self = config;
  self.fronts = self.pu_fronts();
  for (const ShapeEntry& entry : shape_entries()) {
    for (const int value : entry.values) {
      const Config changed = with_shape(self, entry, value);
      const bool known = changed == self || std::any_of(found.begin(), found.end(), [&](const Neighbour& other) {
                           return other.config == changed;
                         });
      if (!known) found.push_back({changed, &entry, value});
    }
  }
  return found;
}

}  // namespace pipegs
