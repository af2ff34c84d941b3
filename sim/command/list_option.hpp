// SPDX-License-Identifier: Apache-2.0
// list_option.hpp: options whose value is a list in one word, its elements by commas: names, numbers, a place, a
// colour; a span.
//
// Why     The parser of the command line would leave out empty elements: a,,b would be a,b. And it would take the words
//         behind the list for more of it, the scene among them.
// Rule    Each element is there, a name comes once, and the option comes once.
// Errors  CLI::ValidationError: "--designs: found 'dop,,late', expected elements by commas, none of them empty".
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "sim/command/number_option.hpp"

namespace pipegs {

namespace list_option_detail {

inline std::vector<std::string> elements_of(const std::string& name, const std::string& list) {
  std::vector<std::string> elements = {""};
  for (const char c : list) {
    if (c == ',') elements.emplace_back();
    else elements.back() += c;
  }
  for (const std::string& element : elements) {
    if (element.empty()) {
      throw CLI::ValidationError(name,
                                 fmt::format("found {}, expected elements by commas, none of them empty", quote(list)));
    }
  }
  return elements;
}

inline std::string joined(const auto& elements) { return fmt::format("{}", fmt::join(elements, ",")); }

// As many elements as the shape has, such as X,Y,Z; `read` gets each with its place.
template <class Value>
CLI::Option* add_shape(CLI::App& app, const std::string& name, std::vector<Value>& values, const std::string& what,
                       const std::string& shape, std::function<Value(const std::string&, size_t)> read) {
  return number_option_detail::add<std::vector<Value>>(
      app, name, what, shape, values,
      [name, shape, read = std::move(read)](const std::string& list) {
        const std::vector<std::string> found = elements_of(name, list);
        if (found.size() != elements_of(name, shape).size())
          throw CLI::ValidationError(name, fmt::format("found {}, expected {}", quote(list), shape));
        std::vector<Value> values;
        for (size_t i = 0; i < found.size(); ++i) values.push_back(read(found[i], i));
        return values;
      },
      [] { return ""; });
}

}  // namespace list_option_detail

inline CLI::Option* add_names(CLI::App& app, const std::string& name, std::vector<std::string>& names,
                              const std::string& what) {
  return number_option_detail::add<std::vector<std::string>>(
      app, name, what, "NAMES", names,
      [name](const std::string& list) {
        const std::vector<std::string> found = list_option_detail::elements_of(name, list);
        for (auto element = found.begin(); element != found.end(); ++element) {
          if (std::find(found.begin(), element, *element) != element)
            throw CLI::ValidationError(name, fmt::format("found a second {}, expected one", quote(*element)));
        }
        return found;
      },
      [&names] { return list_option_detail::joined(names); });
}

// Column and row; nothing is set without the option.
inline CLI::Option* add_place(CLI::App& app, const std::string& name, std::vector<int>& place,
                              const std::string& what) {
  return list_option_detail::add_shape<int>(app, name, place, what, "COLUMN,ROW", [](const std::string& text, size_t) {
    return parse_integer<int>(text, 0);
  });
}

// Three numbers; nothing is set without the option.
inline CLI::Option* add_vector(CLI::App& app, const std::string& name, std::vector<double>& values,
                               const std::string& what, const RealRange& range) {
  return list_option_detail::add_shape<double>(
      app, name, values, what, "X,Y,Z", [range](const std::string& text, size_t) { return parse_real(text, range); });
}

// A rectangle of pixels; nothing is set without the option.
inline CLI::Option* add_rectangle(CLI::App& app, const std::string& name, std::vector<int>& rectangle,
                                  const std::string& what, int most) {
  return list_option_detail::add_shape<int>(
      app, name, rectangle, what, "X,Y,W,H",
      [most](const std::string& text, size_t i) { return parse_integer<int>(text, i < 2 ? 0 : 1, most); });
}

// Red, green and blue of 8 bits, R,G,B or #rrggbb; nothing is set without the option.
inline CLI::Option* add_color(CLI::App& app, const std::string& name, std::vector<int>& color,
                              const std::string& what) {
  return number_option_detail::add<std::vector<int>>(
      app, name, what, "COLOUR", color,
      [name](const std::string& text) {
        std::vector<int> color;
        if (text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == text.npos) {
          for (const size_t at : {1, 3, 5}) color.push_back(std::stoi(text.substr(at, 2), nullptr, 16));
          return color;
        }
        const std::vector<std::string> found = list_option_detail::elements_of(name, text);
        if (found.size() != 3)
          throw CLI::ValidationError(name,
                                     fmt::format("found {}, expected R,G,B of 0 to 255, or #rrggbb", quote(text)));
        for (const std::string& element : found) color.push_back(parse_integer<int>(element, 0, 255));
        return color;
      },
      [] { return ""; });
}

// First and last, as 0-9, or all, whose last is -1; nothing is set without the option.
inline CLI::Option* add_span(CLI::App& app, const std::string& name, std::vector<int>& span, const std::string& what) {
  return number_option_detail::add<std::vector<int>>(
      app, name, what, "FIRST-LAST", span,
      [name](const std::string& text) {
        if (text == "all") return std::vector<int>{0, -1};
        const size_t dash = text.find('-');
        if (dash == std::string::npos)
          throw CLI::ValidationError(name, fmt::format("found {}, expected FIRST-LAST or all", quote(text)));
        const int first = parse_integer<int>(text.substr(0, dash), 0);
        return std::vector<int>{first, parse_integer<int>(text.substr(dash + 1), first)};
      },
      [] { return ""; });
}

}  // namespace pipegs
