// SPDX-License-Identifier: Apache-2.0
// input_error: composes the one-line messages of input_error.hpp.
//
// Idea    Join, then replace whatever would break the line. A long name is shortened alone: the cause stays.
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kLongestPlace = 100;

std::string compose(std::string_view file, std::string_view where, std::string_view what) {
  std::string text = shortened(std::string(file), kLongestPlace);
  text += ": ";
  if (!where.empty()) {
    text += shortened(std::string(where), kLongestPlace);
    text += ": ";
  }
  text += what;
  return message_line(text);
}

}  // namespace

InputError::InputError(std::string_view file, std::string_view where, std::string_view what)
    : std::runtime_error(compose(file, where, what)) {}

}  // namespace pipegs
