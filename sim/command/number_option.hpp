// SPDX-License-Identifier: Apache-2.0
// number_option.hpp: options whose values are numbers, read by the one parser of scenes/text/number.hpp.
//
// Why     The parser of the command line would take 010 for 8, a blank before a number, and -1 for 2^64 - 1.
// Errors  CLI::ValidationError: "--view: found '12abc', expected an integer from 0 to 7".
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <concepts>
#include <functional>
#include <limits>
#include <string>

#include "scenes/text/number.hpp"

namespace pipegs {

namespace number_option_detail {

template <class Read>
auto checked(const std::string& name, const Read& read) {
  try {
    return read();
  } catch (const NumberError& error) { throw CLI::ValidationError(name, error.what()); }
}

template <class Value>
CLI::Option* add(CLI::App& app, const std::string& name, const std::string& what, const std::string& type, Value& value,
                 std::function<Value(const std::string&)> read, std::function<std::string()> shown) {
  return app
      .add_option(
          name,
          [&value, name, read = std::move(read)](const CLI::results_t& texts) {
            value = checked(name, [&] { return read(texts.at(0)); });
            return true;
          },
          what, false, std::move(shown))
      ->type_name(type);
}

}  // namespace number_option_detail

// An integer from `low` to `high`; without bounds all that the type holds.
template <std::integral T>
CLI::Option* add_integer(CLI::App& app, const std::string& name, T& value, const std::string& what,
                         T low = std::numeric_limits<T>::min(), T high = std::numeric_limits<T>::max()) {
  return number_option_detail::add<T>(
      app, name, what, "INT", value, [low, high](const std::string& text) { return parse_integer<T>(text, low, high); },
      [&value] { return fmt::format("{}", value); });
}

inline CLI::Option* add_real(CLI::App& app, const std::string& name, double& value, const std::string& what,
                             const RealRange& range) {
  return number_option_detail::add<double>(
      app, name, what, "NUMBER", value, [range](const std::string& text) { return parse_real(text, range); },
      [&value] { return fmt::format("{}", value); });
}

}  // namespace pipegs
