// SPDX-License-Identifier: Apache-2.0
// machine_kind.cpp: see machine_kind.hpp.
#include "sim/silicon/area/machine_kind.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include "scenes/text/quote.hpp"

namespace pipegs {
namespace {

constexpr double kKindRidge = 1e-6;  // beside a mean of 1: what an offset may cost

// The entries as they stand in config.def, by name; made once.
const std::map<std::string, ConfigEntry>& known_knobs() {
  static const std::map<std::string, ConfigEntry> kKnobs = [] {
    std::map<std::string, ConfigEntry> found;
    for (const ConfigEntry& entry : config_entries(Config{})) {
      if (entry.member != nullptr) found.emplace(entry.name, entry);
    }
    return found;
  }();
  return kKnobs;
}

int knob_value(const Config& config, const ConfigEntry& knob) {
  return knob.member == &Config::fronts ? config.pu_fronts() : config.*knob.member;
}

// What a block sees of a knob: of a number of records, the bits that name one.
int seen(const ConfigEntry& knob, int value) { return knob.member == &Config::records ? clog2(value) : value; }

}  // namespace

Config config_of(const std::string& difference) {
  Config config;
  if (difference != "default") {
    std::set<std::string_view> keys;
    for (std::string_view rest = difference;;) {
      const size_t comma = rest.find(',');
      const std::string_view setting = rest.substr(0, comma), key = setting.substr(0, setting.find('='));
      if (!keys.insert(key).second) throw ConfigError("configuration: found a second " + quote(key) + ", expected one");
      config_set(config, setting);
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  config_check(config);
  return config;
}

MachineKind kind_of(const Config& config) {
  return {config.late, config.order, config.quadratic, config.quads, config.pace};
}

std::vector<double> kind_terms(const Config& config) {
  return {1.0,
          1.0 * config.late,
          1.0 * config.has_lists(),
          1.0 * config.has_watermarks(),
          1.0 * config.quadratic,
          1.0 * config.quads,
          1.0 * (config.pace == 4)};
}

std::vector<double> kind_ridges() {
  return {0, kKindRidge, kKindRidge, kKindRidge, kKindRidge, kKindRidge, kKindRidge};
}

double scaled(const Config& config, const std::string& name) {
  const auto knob = known_knobs().find(name);
  if (knob == known_knobs().end()) throw ConfigError("no entry " + name);
  const int low = seen(knob->second, knob->second.low), high = seen(knob->second, knob->second.high);
  return (2.0 * seen(knob->second, knob_value(config, knob->second)) - low - high) / std::max(1, high - low);
}

bool within(const Config& config, const std::vector<Config>& points) {
  std::vector<Config> kin;
  std::copy_if(points.begin(), points.end(), std::back_inserter(kin), [&](const Config& point) {
    return kind_of(point) == kind_of(config) && point.oriented() == config.oriented();
  });
  return !kin.empty() && std::all_of(known_knobs().begin(), known_knobs().end(), [&](const auto& one) {
    const ConfigEntry& knob = one.second;
    const std::vector<Config>& moved = one.first == "fronts" ? kin : points;
    const auto [low, high] = std::minmax_element(moved.begin(), moved.end(), [&](const Config& a, const Config& b) {
      return knob_value(a, knob) < knob_value(b, knob);
    });
    const int value = knob_value(config, knob);
    return value >= knob_value(*low, knob) && value <= knob_value(*high, knob);
  });
}

}  // namespace pipegs
