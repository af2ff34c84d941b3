// SPDX-License-Identifier: Apache-2.0
// input_error: composes the one-line messages of input_error.hpp.
//
// Idea    Join, then replace whatever would break the line.
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

std::string compose(std::string_view file, std::string_view where, std::string_view what) {
  std::string text(file);
  text += ": ";
  if (!where.empty()) {
    text += where;
    text += ": ";
  }
  text += what;
  return one_line(std::move(text));
}

}  // namespace

InputError::InputError(std::string_view file, std::string_view where, std::string_view what)
    : std::runtime_error(compose(file, where, what)) {}

}  // namespace pipegs
