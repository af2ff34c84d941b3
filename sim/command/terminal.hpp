// SPDX-License-Identifier: Apache-2.0
// terminal.hpp: the one way to standard output and standard error: what a terminal would take for a command is `?`.
//
// Idea    Names of scenes, cameras and folders stand in tables and messages, and come from files that others made. So
//         both streams are others that pass on what quote.hpp lets pass; who prints need not think of it.
// Rule    A message that cannot be written changes no exit code; standard output that cannot be does (main.cpp).
#pragma once

namespace pipegs {

// Call once at start.
void guard_terminal();

}  // namespace pipegs
