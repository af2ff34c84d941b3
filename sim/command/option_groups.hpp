// SPDX-License-Identifier: Apache-2.0
// option_groups.hpp: the groups in which options stand in a help: Scene, Camera, Machine, Memory, Output. An option
// that several commands have stands in the same one everywhere; what a command alone has stands in its Options.
#pragma once

#include "sim/command/options.hpp"

namespace pipegs {

// Of all commands below `app`.
void group_options(CLI::App& app);

}  // namespace pipegs
