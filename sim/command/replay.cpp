// SPDX-License-Identifier: Apache-2.0
// replay.cpp: see replay.hpp.
#include "sim/command/replay.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace pipegs {
namespace {

// The program and the words that name the command, as a shell takes them.
std::string words_of(const CLI::App& command) {
  const std::string name = shell_word(command.get_name());
  return command.get_parent() == nullptr ? name : words_of(*command.get_parent()) + " " + name;
}

}  // namespace

std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_./=,:+-@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string program_of(const CLI::App& command) {
  return command.get_parent() == nullptr ? shell_word(command.get_name()) : program_of(*command.get_parent());
}

std::string given_again(const CLI::App& command, const std::set<std::string>& without) {
  return given_to(command.get_name(), command, without);
}

std::string given_to(const std::string& sister, const CLI::App& command, const std::set<std::string>& without) {
  const CLI::App& taker = *command.get_parent()->get_subcommand(sister);
  std::string line = words_of(taker);
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || without.contains(option->get_name())) continue;
    if (taker.get_option_no_throw(option->get_name()) == nullptr) continue;
    const std::string name = option->get_positional() ? "" : " " + option->get_name();
    if (option->get_items_expected_max() == 0) {
      line += name;  // a flag
      continue;
    }
    for (const std::string& value : option->results()) line += name + " " + shell_word(value);
  }
  return line;
}

}  // namespace pipegs
