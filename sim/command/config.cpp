// SPDX-License-Identifier: Apache-2.0
// config.cpp: `pipegs config`: the keys of cpp_model/config.def: value in a machine, range, unit, meaning; one of them
// in full.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

struct ConfigArguments {
  MachineArguments machine;
  std::string key;
  bool all = false;
  StudyOutput output;
};

bool is_key(const ConfigEntry& entry) { return entry.member != nullptr; }

std::string range_of(const ConfigEntry& entry) { return fmt::format("{} to {}", entry.low, entry.high); }

// The entries that follow from this key: whose value another of its values changes in a machine that is legal.
std::vector<std::string> moved_by(const ConfigEntry& key, const Config& config) {
  const std::vector<ConfigEntry> now = config_entries(config);
  std::vector<bool> moved(now.size());
  const int step = std::max(1, (key.high - key.low) / 64);
  for (int value = key.low; value < key.high + step; value += step) {
    Config other = config;
    other.*key.member = std::min(value, key.high);
    try {
      config_check(other);
    } catch (const ConfigError&) { continue; }
    const std::vector<ConfigEntry> then = config_entries(other);
    for (size_t i = 0; i < now.size(); ++i) moved[i] = moved[i] || (!is_key(now[i]) && then[i].value != now[i].value);
  }
  std::vector<std::string> names;
  for (size_t i = 0; i < now.size(); ++i) {
    if (moved[i]) names.emplace_back(now[i].name);
  }
  return names;
}

// The keys from which this entry follows.
std::vector<std::string> movers_of(const ConfigEntry& entry, const Config& config) {
  std::vector<std::string> keys;
  for (const ConfigEntry& key : config_entries(config)) {
    if (!is_key(key)) continue;
    const std::vector<std::string> moved = moved_by(key, config);
    if (std::find(moved.begin(), moved.end(), entry.name) != moved.end()) keys.emplace_back(key.name);
  }
  return keys;
}

Json entry_json(const ConfigEntry& entry) {
  Json json = {{"key", entry.name},
               {"in_systemverilog", entry.camel_name},
               {"may_be_set", is_key(entry)},
               {"value", entry.value}};
  json["low"] = is_key(entry) ? Json(entry.low) : Json(nullptr);
  json["high"] = is_key(entry) ? Json(entry.high) : Json(nullptr);
  json["unit"] = entry.unit;
  json["meaning"] = entry.what;
  return json;
}

Table keys_table(const Config& config, const std::string& machine, bool all) {
  Table table{.columns = {{.key = "key", .heading = "key", .word = true},
                          {.key = "value", .heading = machine},
                          {.key = "default", .heading = "default"},
                          {.key = "range", .heading = "range", .word = true},
                          {.key = "unit", .heading = "unit", .word = true},
                          {.key = "meaning", .heading = "meaning", .word = true, .wrapped = true}}};
  const Config standard;
  size_t others = 0;
  for (const ConfigEntry& entry : config_entries(config)) {
    others += !is_key(entry);
    if (!is_key(entry) && !all) continue;
    table.rows.push_back({text_cell(std::string(entry.name)), number_cell(entry.value),
                          number_cell(config_value(standard, entry.name)),
                          text_cell(is_key(entry) ? range_of(entry) : "-"), text_cell(std::string(entry.unit)),
                          text_cell(std::string(entry.what))});
  }
  table.notes.push_back("default: of config.def, the paper's machine `dop`; a key in full: pipegs config KEY");
  if (all) table.notes.push_back("range -: no key, follows from the others or is the same in every machine");
  else table.notes.push_back(fmt::format("{} more entries follow from these: --all", others));
  return table;
}

// What is known of one entry, a line each.
Table entry_table(const ConfigEntry& entry, const Config& config, const std::string& machine, Json& json) {
  Table table{.columns = {{.key = "what", .word = true}, {.key = "text", .word = true, .wrapped = true}}};
  const auto add = [&](const std::string& what, const std::string& text) {
    table.rows.push_back({text_cell(what), text_cell(text)});
  };
  add("key", std::string(entry.name));
  add("meaning", std::string(entry.what));
  add("value", fmt::format("{} in {}", entry.value, machine));
  if (is_key(entry)) add("range", range_of(entry));
  if (!entry.unit.empty()) add("unit", std::string(entry.unit));
  add("default", fmt::format("{}", config_value(Config{}, entry.name)));
  std::vector<std::string> points;
  for (const DesignPoint& point : design_points()) {
    const int value = config_value(point.config, entry.name);
    points.push_back(fmt::format("{} {}", point.name, value));
    json["design_points"][std::string(point.name)] = value;
  }
  add("design points", fmt::format("{}", fmt::join(points, ", ")));
  add("SystemVerilog", fmt::format("pipegs_pkg::{}", entry.camel_name));
  const std::vector<std::string> others = is_key(entry) ? moved_by(entry, config) : movers_of(entry, config);
  json[is_key(entry) ? "moves" : "follows_from"] = others;
  add(is_key(entry) ? "moves" : "follows from",
      others.empty() ? "nothing" : fmt::format("{}", fmt::join(others, ", ")));
  return table;
}

// By its name in C++ or in SystemVerilog.
ConfigEntry find_entry(const Config& config, const std::string& name) {
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.camel_name == name) return entry;
  }
  return config_entry("KEY", config, name);
}

int show_config(const ConfigArguments& arguments) {
  const Config config = arguments.machine.machine();
  const std::string machine = machine_name(config);
  std::optional<ConfigEntry> entry;
  if (!arguments.key.empty()) entry = find_entry(config, arguments.key);
  arguments.output.check();
  const bool named = find_design_point(arguments.machine.design_point).config == config;
  const std::string name = named ? arguments.machine.design_point : "value";
  Json json = {{"machine", machine}};
  Table table;
  if (entry) {
    json.update(entry_json(*entry));
    table = entry_table(*entry, config, machine, json);
  } else {
    table = keys_table(config, name, arguments.all);
    for (const ConfigEntry& one : config_entries(config)) {
      if (is_key(one) || arguments.all) json["entries"].push_back(entry_json(one));
    }
  }
  arguments.output.write({.title = "The configuration",
                          .head = fmt::format("cpp_model/config.def, values of {}", machine),
                          .tables = {table},
                          .machines = {{name, config}}},
                         json);
  return kExitOk;
}

}  // namespace

void add_config(CLI::App& app, Run& run) {
  CLI::App& command = add_command(app, "config", "every key of a machine: value, range, meaning",
                                  footer("pipegs config alpha_w --design exact", "listed"));
  static ConfigArguments arguments;
  add_text(command, "KEY", arguments.key, "one entry of cpp_model/config.def, which is then shown in full");
  arguments.machine.add(command);
  add_flag(command, "--all", arguments.all, "the entries, too, that follow from the keys");
  arguments.output.add(command);
  when_chosen(command, run, [] { return show_config(arguments); });
}

}  // namespace pipegs
