// SPDX-License-Identifier: Apache-2.0
// replay.hpp: the command line that repeats a run, made from the arguments that were given.
//
// Idea    The parser knows every option that stood on the line and its text; an option that a command gains later is
//         in the replay without a thought. What the replay sets itself is named instead.
#pragma once

#include <set>
#include <string>

#include "sim/command/options.hpp"

namespace pipegs {

// A word as a shell takes it.
std::string shell_word(const std::string& text);

// The program, as a shell takes it.
std::string program_of(const CLI::App& command);

// "PROGRAM COMMAND" and all that was given but the options in `without` ("--out"), whose values are others.
std::string given_again(const CLI::App& command, const std::set<std::string>& without);
// The same line for the command `sister` beside it, with what that one takes, too.
std::string given_to(const std::string& sister, const CLI::App& command, const std::set<std::string>& without);

}  // namespace pipegs
