// SPDX-License-Identifier: Apache-2.0
// config.hpp: the configuration of the machine as a struct, from config.def.
//
// A Config is a plain value: the golden model takes it as an argument and works for every legal one. `set` changes one
// entry by name ("alpha_w", "12") and throws ConfigError, naming the legal range, when it cannot. Derived widths are
// member functions, so they follow whatever is set; fixed depths are constant ones, so they may size an array.
//
// Paper   Table 2 (counts), Sec. 5.1 (grid).        RTL  rtl/pipegs_pkg.sv, printed by cpp_model/package_sv.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cpp_model/pu/stages.hpp"

namespace pipegs {

struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr int clog2(int n) {
  int bits = 0;
  while ((1 << bits) < n) ++bits;
  return bits;
}

// The largest power of two that is not above n.
constexpr int power_floor(int n) {
  int power = 1;
  while (2 * power <= n) power *= 2;
  return power;
}

inline constexpr int kMostUnits = 8;  // of a kind: each has its counters in the register map

struct Config {
#define PIPEGS_CONFIG(name, Name, value, low, high, unit, what) int name = value;
#define PIPEGS_DERIVED(name, Name, expression, what)
#define PIPEGS_FIXED(name, Name, value, what)
#include "cpp_model/config.def"
#undef PIPEGS_CONFIG
#undef PIPEGS_DERIVED
#undef PIPEGS_FIXED

#define PIPEGS_CONFIG(name, Name, value, low, high, unit, what)
#define PIPEGS_DERIVED(name_, Name, expression, what) \
  int name_() const {                                 \
    [[maybe_unused]] const Config& c = *this;         \
    return expression;                                \
  }
#define PIPEGS_FIXED(name, Name, value, what) \
  static constexpr int name() { return value; }
#include "cpp_model/config.def"
#undef PIPEGS_CONFIG
#undef PIPEGS_DERIVED
#undef PIPEGS_FIXED

  bool operator==(const Config&) const = default;
};

struct ConfigEntry {
  std::string_view name;        // as in --set and in C++
  std::string_view camel_name;  // as in SystemVerilog
  int Config::*member;          // null for a derived or fixed entry
  int value;                    // in the Config asked about
  int low, high;                // legal range; 0, 0 for a derived or fixed entry
  std::string_view unit, what;
};

std::vector<ConfigEntry> config_entries(const Config& config);

// Value of an entry of any kind, by its C++ name; throws ConfigError for an unknown one.
int config_value(const Config& config, std::string_view name);

// Sets `assignment` = "key=value"; throws ConfigError with one clear line.
void config_set(Config& config, std::string_view assignment);

// Throws ConfigError when entries that depend on each other do not fit (counts not a power of two, ...).
void config_check(const Config& config);

// Short stable text of what differs from the default, for file names and reports: "units=1,alpha_w=10" or "default".
std::string config_difference(const Config& config);

}  // namespace pipegs
