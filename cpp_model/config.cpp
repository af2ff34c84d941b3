// SPDX-License-Identifier: Apache-2.0
// config.cpp: see config.hpp.
#include "cpp_model/config.hpp"

#include <tuple>

#include "scenes/text/number.hpp"

namespace pipegs {

std::vector<ConfigEntry> config_entries(const Config& c) {
  return {
#define PIPEGS_CONFIG(name, Name, value, low, high, unit, what) \
  {#name, #Name, &Config::name, c.name, low, high, unit, what},
#define PIPEGS_DERIVED(name, Name, expression, what) {#name, #Name, nullptr, c.name(), 0, 0, "", what},
#define PIPEGS_FIXED(name, Name, value, what) {#name, #Name, nullptr, value, 0, 0, "", what},
#define PIPEGS_FLAG(name, Name, expression, what) {#name, #Name, nullptr, c.name(), 0, 0, "flag", what},
#include "cpp_model/config.def"
#undef PIPEGS_CONFIG
#undef PIPEGS_DERIVED
#undef PIPEGS_FIXED
  };
}

int config_value(const Config& config, std::string_view name) {
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.name == name) return entry.value;
  }
  throw ConfigError("unknown configuration key " + quote(name));
}

void config_set(Config& config, std::string_view assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) { throw ConfigError("--set " + quote(assignment) + ": expected key=value"); }
  const std::string_view key = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  std::string known;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member == nullptr) continue;
    if (entry.name != key) {
      known += (known.empty() ? "" : ", ") + std::string(entry.name);
      continue;
    }
    try {
      config.*entry.member = parse_integer(text, entry.low, entry.high);
    } catch (const NumberError& error) { throw ConfigError("--set " + std::string(key) + ": " + error.what()); }
    return;
  }
  throw ConfigError("--set: unknown key " + quote(key) + "; known: " + known);
}

namespace {

// Of the record Node of records.def: two of them fill a line of memory.
int node_bits(const Config& config) {
  return 3 * (config.world_w + config.half_w() + 2 * config.hull_w()) + 2 * config.exp_w() + config.scale_w() +
         config.slot_w() + config.children_w();
}

}  // namespace

void config_check(const Config& config) {
  const auto power_of_two = [](int n) { return (n & (n - 1)) == 0; };
  for (const auto& [name, value] : {std::pair{"units", config.units},
                                    {"fronts", config.fronts},
                                    {"window", config.window},
                                    {"pixel_w", config.pixel_w},
                                    {"pace", config.pace},
                                    {"chunk", config.chunk},
                                    {"grid", config.grid},
                                    {"nearest_nodes", config.nearest_nodes}}) {
    if (!power_of_two(value)) {
      throw ConfigError(std::string("configuration: ") + name + " = " + std::to_string(value) +
                        ", expected a power of two");
    }
  }
  if (config.bus_w != 0 && config.bus_w != 128 && config.bus_w != 256 && config.bus_w != 512) {
    throw ConfigError("configuration: bus_w = " + std::to_string(config.bus_w) + ", expected 0, 128, 256 or 512");
  }
  if (config.quadratic && !config.late) throw ConfigError("configuration: quadratic = 1 needs late = 1");
  if (config.quads && (!config.late || config.quadratic)) {
    throw ConfigError("configuration: quads = 1 needs late = 1 and quadratic = 0");
  }
  if (config.units > config.regions()) {
    throw ConfigError("configuration: units = " + std::to_string(config.units) + ", expected with window = " +
                      std::to_string(config.window) + " at most its regions = " + std::to_string(config.regions()));
  }
  if (config.window == 128 && (!config.quads || config.order == 1)) {
    throw ConfigError("configuration: window = 128 needs quads = 1 and order 0 or 2");
  }
  if (config.bucket_bits > config.depth_w - config.exp_w()) {
    throw ConfigError("configuration: bucket_bits must not exceed depth_w - " + std::to_string(config.exp_w()));
  }
  if (config.order == 2 && !config.late) throw ConfigError("configuration: order = 2 needs late = 1");
  if (config.order == 2 && config.bucket_bits == 0) {
    throw ConfigError("configuration: order = 2 needs bucket_bits of at least 1");
  }
  // A window on trial (dopu_load) keeps its cells waiting, and at most half a queue of groups: neither may fill it.
  if (const int cells = config.grid * config.grid * config.grid;
      config.has_walks() && config.nearest_nodes < 2 * cells) {
    throw ConfigError("configuration: nearest_nodes = " + std::to_string(config.nearest_nodes) +
                      ", expected with window = 128 at least 2 grid^3 = " + std::to_string(2 * cells));
  }
  if (!config.layered && config.order != 0) throw ConfigError("configuration: layered = 0 needs order = 0");
  if (config.tight_cull && config.order == 1) throw ConfigError("configuration: tight_cull = 1 needs order 0 or 2");
  if (config.occlusion && config.order != 2) throw ConfigError("configuration: occlusion = 1 needs order = 2");
  if (config.lod && (config.order != 2 || config.bucket_bits < Config::error_bits())) {
    throw ConfigError("configuration: lod = 1 needs order = 2 and bucket_bits of at least " +
                      std::to_string(Config::error_bits()));
  }
  if (config.tight_boxes && config.order != 2) throw ConfigError("configuration: tight_boxes = 1 needs order = 2");
  if (const int bits = node_bits(config), most = config.memory_w() / 2; bits > most) {
    throw ConfigError("configuration: a node has " + std::to_string(bits) + " bits, expected at most " +
                      std::to_string(most) + ": world_w or scale_m_w must be smaller");
  }
  if (config.record != 48 && config.record != 96) {
    throw ConfigError("configuration: record = " + std::to_string(config.record) + ", expected 48 or 96");
  }
  for (const auto& [name, value, least] : {std::tuple{"pos_w", config.pos_w, Config::offset_code_w()},
                                           {"base_w", config.base_w, Config::base_code_w() + 2},
                                           {"sh_m_w", config.sh_m_w, 11}}) {
    if (config.coded() && value < least) {
      throw ConfigError("configuration: " + std::string(name) + " = " + std::to_string(value) +
                        ", expected with record = 48 at least " + std::to_string(least));
    }
  }
  if (config.coded() && config.quat_w > 16) {  // the root of pu_decode is no better, and the cull counts on unit length
    throw ConfigError("configuration: quat_w = " + std::to_string(config.quat_w) +
                      ", expected with record = 48 at most 16");
  }
  if (config.pace == 4 && config.tile_test == 2) throw ConfigError("configuration: pace = 4 needs tile_test 0 or 1");
  if (config.power_f > config.coeff_f) throw ConfigError("configuration: power_f must not exceed coeff_f");
}

std::string config_difference(const Config& config) {
  const Config standard;
  std::string text;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member == nullptr || standard.*entry.member == entry.value) continue;
    text += (text.empty() ? "" : ",") + std::string(entry.name) + "=" + std::to_string(entry.value);
  }
  return text.empty() ? "default" : text;
}

}  // namespace pipegs
