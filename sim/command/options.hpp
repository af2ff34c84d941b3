// SPDX-License-Identifier: Apache-2.0
// options.hpp: commands and their options, for CLI11 to parse.
//
// Why     CLI11 would take 010 for 8, a blank before a number, and -1 for 2^64 - 1: numbers are read by the one parser
//         of scenes/text/number.hpp. It would leave out empty elements of a list, a,,b would be a,b, and take the words
//         behind it for more of it, the scene among them: a list is one word, its elements by commas.
// Rule    Each element of a list is there, a name comes once, and the option comes once.
// Errors  CLI::ValidationError: "--view: found '12abc', expected an integer from 0 to 7".
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scenes/text/number.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pipegs {

// A subcommand that was chosen sets `run`.
using Run = std::function<int()>;

// `below` stands below the options.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& what, const std::string& below);
void when_chosen(CLI::App& command, Run& run, Run chosen);
// From the list of commands.
void hide(CLI::App& command);
std::string name_of(const CLI::App& command);
bool is_given(const CLI::App& command, const std::string& option);

// An option that was added, and what else is asked of it.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option shows_default() const;
  Option required() const;
  Option needs(const std::string& other) const;
  Option excludes(const std::string& other) const;
  // The help lists the words, unless they are `told` in its text.
  Option one_of(const std::vector<std::string>& words, bool told = false) const;
  // Refused with what `wrong` says, unless that is empty.
  Option checked(const std::function<std::string(const std::string&)>& wrong) const;

 private:
  CLI::Option* option_;
};

Option add_flag(CLI::App& app, const std::string& name, bool& value, const std::string& what);
Option add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& what);
// One each time that the option comes.
Option add_texts(CLI::App& app, const std::string& name, std::vector<std::string>& values, const std::string& what);

// What `read` takes, which throws NumberError; `shown` is the default.
Option add_read(CLI::App& app, const std::string& name, const std::string& what, const std::string& type,
                std::function<void(const std::string&)> read, std::function<std::string()> shown = {});

// An integer from `low` to `high`; without bounds all that the type holds.
template <std::integral T>
Option add_integer(CLI::App& app, const std::string& name, T& value, const std::string& what,
                   T low = std::numeric_limits<T>::min(), T high = std::numeric_limits<T>::max()) {
  const auto read = [&value, low, high](const std::string& text) { value = parse_integer<T>(text, low, high); };
  return add_read(app, name, what, "INT", read, [&value] { return fmt::to_string(value); });
}

Option add_real(CLI::App& app, const std::string& name, double& value, const std::string& what, const RealRange& range);

Option add_names(CLI::App& app, const std::string& name, std::vector<std::string>& names, const std::string& what);

// One list by commas each time that the option comes.
Option add_lists(CLI::App& app, const std::string& name, std::vector<std::vector<std::string>>& lists,
                 const std::string& what, const std::string& shape);

// Of the rest nothing is set without the option. Column and row:
Option add_place(CLI::App& app, const std::string& name, std::vector<int>& place, const std::string& what);

// Integers from 0 to `most`, as many as `shape` has by commas.
Option add_counts(CLI::App& app, const std::string& name, std::vector<int>& counts, const std::string& what,
                  const std::string& shape, int most);

// Three numbers.
Option add_vector(CLI::App& app, const std::string& name, std::vector<double>& values, const std::string& what,
                  const RealRange& range);

// A rectangle of pixels.
Option add_rectangle(CLI::App& app, const std::string& name, std::vector<int>& rectangle, const std::string& what,
                     int most);

// Red, green and blue of 8 bits, R,G,B or #rrggbb.
Option add_color(CLI::App& app, const std::string& name, std::vector<int>& color, const std::string& what);

// First and last, as 0-9, or all, whose last is -1.
Option add_span(CLI::App& app, const std::string& name, std::vector<int>& span, const std::string& what);

}  // namespace pipegs
