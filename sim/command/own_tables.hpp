// SPDX-License-Identifier: Apache-2.0
// own_tables.hpp: tables of this program's own sources (synth/data): one that is broken or not there is no bad input.
// Who needs them in the end reads them in the beginning.
#pragma once

#include <string>

#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"

namespace pipegs {

// What `read` gives.
template <typename Read>
auto own_tables(const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw OwnFailure(std::string(error.what()) + " (a file of this program's sources: they may have been moved)");
  }
}

}  // namespace pipegs
