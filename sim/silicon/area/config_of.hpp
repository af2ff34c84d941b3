// SPDX-License-Identifier: Apache-2.0
// config_of.hpp: configurations as the tables of synth/data name them.
#pragma once

#include <string>

#include "cpp_model/config.hpp"

namespace pipegs {

// The configuration that config_difference has named: "default" or key=value,key=value. ConfigError for any other text.
Config config_of(const std::string& difference);

}  // namespace pipegs
