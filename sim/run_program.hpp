// SPDX-License-Identifier: Apache-2.0
// run_program.hpp: another program that is waited for: a build of the RTL, of a page's template.
//
// Idea    It gets a process group of its own, so that Control-C reaches this program alone, and the handling of signals
//         that every program begins with. When this one is told to end, the whole group is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pipegs {

// Its exit code, or -1 when it did not run or did not end by itself. What it says goes to `log`, or nowhere. Throws
// std::runtime_error when this program is interrupted.
int run_program(const std::vector<std::string>& words, const std::filesystem::path& log = "/dev/null");

// Those that run are ended at once. A signal's handler may call it.
void kill_programs();

}  // namespace pipegs
