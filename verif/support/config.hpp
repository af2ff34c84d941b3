// SPDX-License-Identifier: Apache-2.0
// config.hpp: the configuration that a test's module was built with: the SET arguments of its line in CMakeLists.txt;
// and others, for tests of models alone.
#pragma once

#include <sstream>
#include <string>

#include "cpp_model/config.hpp"

namespace pipegs {

// The default configuration with these assignments.
inline Config config_with(const std::string& assignments) {
  Config config;
  std::istringstream text(assignments);
  for (std::string assignment; text >> assignment;) config_set(config, assignment);
  config_check(config);
  return config;
}

#ifdef PIPEGS_SET
inline Config test_config() { return config_with(PIPEGS_SET); }
#endif

}  // namespace pipegs
