// SPDX-License-Identifier: Apache-2.0
// config.hpp: the configuration that a test's module was built with: the SET arguments of its line in CMakeLists.txt.
#pragma once

#include <sstream>
#include <string>

#include "cpp_model/config.hpp"

namespace pipegs {

inline Config test_config() {
  Config config;
  std::istringstream text(PIPEGS_SET);
  for (std::string assignment; text >> assignment;) config_set(config, assignment);
  config_check(config);
  return config;
}

}  // namespace pipegs
