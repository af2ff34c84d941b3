// SPDX-License-Identifier: Apache-2.0
// own_failure: what is thrown when neither the input nor the machine is at fault, but the program or its computer.
//
// Idea    Four things can end a run early, and each has a type, because each has an exit code (sim/command/main.cpp):
//           RtlFault                              the machine differs from what it must do      1
//           InputError, ConfigError, FrameError   a file or an option is not what it should be  2
//           OwnFailure, RtlBuildError             a disk is full, a machine does not build      3
//           std::logic_error                      a broken promise between functions: a bug     3
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace pipegs {

class OwnFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// OwnFailure unless a file of this program's sources is where they lay when it was built. Who will need one in the end
// asks in the beginning.
inline void require_own_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw OwnFailure(file.string() + " is not there: this program's sources have been moved since it was built");
}

}  // namespace pipegs
