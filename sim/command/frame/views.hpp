// SPDX-License-Identifier: Apache-2.0
// views.hpp: `pipegs sim --views 0-9`: views one after the other in one machine, without a reset between them.
#pragma once

#include <string>
#include <vector>

#include "sim/command/command.hpp"

namespace pipegs {

struct ViewsArguments {
  int first = 0, last = 0;  // of the cameras of the file
  std::string out;          // folder; each view has one of its own in it
  bool json = false;
  std::string replay;  // the command that runs the same again with waves
};

// Runs them twice, each frame queued behind the one before and each when the machine is empty, compares all, writes the
// pictures and sequence.json, prints what a frame took both ways. Returns the exit code.
int simulate_views(const ViewArguments& view, const ViewsArguments& views, const SimulateOptions& options);

}  // namespace pipegs
