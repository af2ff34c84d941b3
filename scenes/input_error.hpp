// SPDX-License-Identifier: Apache-2.0
// input_error: what every reader throws when a file or an option is not what it should be.
//
// Idea    The message is one line that a user can act on without a debugger:
//           "file: element/line, field: what was found, what was expected"
//         Programming errors (a caller's broken promise) are std::invalid_argument instead.
// Rule    What quote.hpp says: whatever a hostile file contains, the message is one line that a log can hold.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "scenes/text/quote.hpp"

namespace pipegs {

class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  // "<file>: <where>: <what>", or "<file>: <what>" when `where` is empty.
  InputError(std::string_view file, std::string_view where, std::string_view what);
};

}  // namespace pipegs
