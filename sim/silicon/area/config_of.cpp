// SPDX-License-Identifier: Apache-2.0
// config_of.cpp: see config_of.hpp.
#include "sim/silicon/area/config_of.hpp"

#include <set>
#include <string_view>

#include "scenes/text/quote.hpp"

namespace pipegs {

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

}  // namespace pipegs
