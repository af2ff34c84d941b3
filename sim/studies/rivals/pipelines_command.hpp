// SPDX-License-Identifier: Apache-2.0
// pipelines_command.hpp: `pipegs rivals --pipelines`: the paper's Fig. 1 from one view.
#pragma once

#include <string>

#include "sim/command/command.hpp"

namespace pipegs {

// Models of other machines, then `dop` and the machine of --design and --set through the RTL. No picture when `svg` is
// empty. Returns the exit code.
int draw_pipelines(const ViewArguments& view, const MemoryArguments& memory, const std::string& svg, bool json);

}  // namespace pipegs
