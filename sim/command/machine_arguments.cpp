// SPDX-License-Identifier: Apache-2.0
// machine_arguments.cpp: see machine_arguments.hpp.
#include "sim/command/machine_arguments.hpp"

#include <fmt/format.h>

#include <set>

#include "scenes/text/nearest.hpp"
#include "sim/design/config_file.hpp"

namespace pipegs {

void MachineArguments::add_design(CLI::App& app) {
  add_text(app, "--design", design_point, fmt::format("design point: {} (--set comes after it)", design_point_names()))
      .shows_default();
}

void MachineArguments::add_file(CLI::App& app) {
  add_text(app, "--config", config, "file with a configuration entry in each line, key=value; # begins a comment");
}

void MachineArguments::add_settings(CLI::App& app) {
  add_texts(app, "--set", settings, "configuration entry, key=value; may be repeated");
}

void MachineArguments::add(CLI::App& app) {
  add_design(app);
  add_file(app);
  add_settings(app);
}

Config MachineArguments::machine() const {
  Config machine = find_design_point(design_point).config;
  if (!config.empty()) apply_config_file(config, machine);
  std::set<std::string> keys;
  for (const std::string& setting : settings) {
    const std::string key = setting.substr(0, setting.find('='));
    if (key.size() < setting.size() && config_entry("--set", machine, key).member == nullptr)
      throw ConfigError(
          fmt::format("--set: {} follows from other keys, expected one of those: `pipegs config {}` "
                      "names them",
                      quote(key), key));
    apply_setting(setting, machine);
    if (!keys.insert(key).second) throw ConfigError(fmt::format("--set: found a second {}, expected one", quote(key)));
  }
  config_check(machine);
  return machine;
}

ConfigEntry config_entry(const std::string& place, const Config& config, std::string_view name) {
  std::vector<std::string> known;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.name == name) return entry;
    known.emplace_back(entry.name);
  }
  throw ConfigError(fmt::format("{}: unknown key {}; nearest: {} (`pipegs config` lists all)", place, quote(name),
                                nearest_word(name, known)));
}

}  // namespace pipegs
