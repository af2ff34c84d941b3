// SPDX-License-Identifier: Apache-2.0
// machine_arguments.hpp: which machine: a design point (`fast` unless one is named), then the lines of --config, then
// the settings.
//
// Errors  ConfigError: one line that names the option, the key and what was expected; of an unknown key the nearest.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/command/options.hpp"
#include "sim/design/design_point.hpp"

namespace pipegs {

struct MachineArguments {
  std::string design_point{kDefaultDesignPoint}, config;
  std::vector<std::string> settings;

  void add_design(CLI::App& app);
  void add_file(CLI::App& app);
  void add_settings(CLI::App& app);
  void add(CLI::App& app);  // all three

  Config machine() const;
};

// The entry of config.def that is called so; when there is none, `place` begins the line that says it.
ConfigEntry config_entry(const std::string& place, const Config& config, std::string_view name);

}  // namespace pipegs
