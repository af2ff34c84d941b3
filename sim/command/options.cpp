// SPDX-License-Identifier: Apache-2.0
// options.cpp: see options.hpp.
#include "sim/command/options.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace pipegs {
namespace {

std::vector<std::string> elements_of(const std::string& name, const std::string& list) {
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

std::string empty(const std::string& text) { return text.empty() ? "found '', expected a value" : ""; }

// As many elements as the shape has, such as X,Y,Z; `read` gets each with its place.
template <class Value>
Option add_shape(CLI::App& app, const std::string& name, std::vector<Value>& values, const std::string& what,
                 const std::string& shape, const std::function<Value(const std::string&, size_t)>& read) {
  return add_read(app, name, what, shape, [&values, name, shape, read](const std::string& list) {
    const std::vector<std::string> found = elements_of(name, list);
    if (found.size() != elements_of(name, shape).size())
      throw CLI::ValidationError(name, fmt::format("found {}, expected {}", quote(list), shape));
    values.clear();
    for (size_t i = 0; i < found.size(); ++i) values.push_back(read(found[i], i));
  });
}

}  // namespace

CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& what, const std::string& below) {
  return *app.add_subcommand(name, what)->footer(below);
}

void when_chosen(CLI::App& command, Run& run, Run chosen) {
  command.callback([&run, chosen = std::move(chosen)] { run = chosen; });
}

void hide(CLI::App& command) { command.group(""); }

std::string name_of(const CLI::App& command) { return command.get_name(); }

bool is_given(const CLI::App& command, const std::string& option) { return command.count(option) > 0; }

Option Option::shows_default() const { return Option(option_->capture_default_str()); }

Option Option::required() const { return Option(option_->required()); }

Option Option::needs(const std::string& other) const { return Option(option_->needs(other)); }

Option Option::excludes(const std::string& other) const { return Option(option_->excludes(other)); }

Option Option::one_of(const std::vector<std::string>& words, bool told) const {
  CLI::Validator among = CLI::IsMember(words);
  if (told) among.description("");
  return Option(option_->check(among));
}

Option Option::checked(const std::function<std::string(const std::string&)>& wrong) const {
  return Option(option_->check(CLI::Validator(wrong, "")));
}

Option add_flag(CLI::App& app, const std::string& name, bool& value, const std::string& what) {
  return Option(app.add_flag(name, value, what));
}

Option add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& what) {
  return Option(app.add_option(name, value, what)).checked(empty);
}

Option add_texts(CLI::App& app, const std::string& name, std::vector<std::string>& values, const std::string& what) {
  return Option(app.add_option(name, values, what)->allow_extra_args(false)).checked(empty);
}

Option add_read(CLI::App& app, const std::string& name, const std::string& what, const std::string& type,
                std::function<void(const std::string&)> read, std::function<std::string()> shown) {
  const auto checked = [name, read = std::move(read)](const CLI::results_t& texts) {
    try {
      read(texts.at(0));
    } catch (const NumberError& error) { throw CLI::ValidationError(name, error.what()); }
    return true;
  };
  return Option(app.add_option(name, checked, what, false, std::move(shown))->type_name(type));
}

Option add_real(CLI::App& app, const std::string& name, double& value, const std::string& what,
                const RealRange& range) {
  const auto read = [&value, range](const std::string& text) { value = parse_real(text, range); };
  return add_read(app, name, what, "NUMBER", read, [&value] { return fmt::to_string(value); });
}

Option add_names(CLI::App& app, const std::string& name, std::vector<std::string>& names, const std::string& what) {
  const auto read = [&names, name](const std::string& list) {
    names = elements_of(name, list);
    for (auto element = names.begin(); element != names.end(); ++element) {
      if (std::find(names.begin(), element, *element) != element)
        throw CLI::ValidationError(name, fmt::format("found a second {}, expected one", quote(*element)));
    }
  };
  return add_read(app, name, what, "NAMES", read, [&names] { return fmt::format("{}", fmt::join(names, ",")); });
}

Option add_lists(CLI::App& app, const std::string& name, std::vector<std::vector<std::string>>& lists,
                 const std::string& what, const std::string& shape) {
  const auto read = [&lists, name](const CLI::results_t& texts) {
    for (const std::string& text : texts) lists.push_back(elements_of(name, text));
    return true;
  };
  return Option(app.add_option(name, read, what)
                    ->type_name(shape)
                    ->expected(1, CLI::detail::expected_max_vector_size)
                    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
                    ->allow_extra_args(false));
}

Option add_place(CLI::App& app, const std::string& name, std::vector<int>& place, const std::string& what) {
  return add_shape<int>(app, name, place, what, "COLUMN,ROW",
                        [](const std::string& text, size_t) { return parse_integer<int>(text, 0); });
}

Option add_counts(CLI::App& app, const std::string& name, std::vector<int>& counts, const std::string& what,
                  const std::string& shape, int most) {
  return add_shape<int>(app, name, counts, what, shape,
                        [most](const std::string& text, size_t) { return parse_integer<int>(text, 0, most); });
}

Option add_vector(CLI::App& app, const std::string& name, std::vector<double>& values, const std::string& what,
                  const RealRange& range) {
  return add_shape<double>(app, name, values, what, "X,Y,Z",
                           [range](const std::string& text, size_t) { return parse_real(text, range); });
}

Option add_rectangle(CLI::App& app, const std::string& name, std::vector<int>& rectangle, const std::string& what,
                     int most) {
  return add_shape<int>(app, name, rectangle, what, "X,Y,W,H", [most](const std::string& text, size_t i) {
    return parse_integer<int>(text, i < 2 ? 0 : 1, most);
  });
}

Option add_color(CLI::App& app, const std::string& name, std::vector<int>& color, const std::string& what) {
  return add_read(app, name, what, "COLOUR", [&color, name](const std::string& text) {
    color.clear();
    if (text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == text.npos) {
      for (const size_t at : {1, 3, 5}) color.push_back(std::stoi(text.substr(at, 2), nullptr, 16));
      return;
    }
    const std::vector<std::string> found = elements_of(name, text);
    if (found.size() != 3)
      throw CLI::ValidationError(name, fmt::format("found {}, expected R,G,B of 0 to 255, or #rrggbb", quote(text)));
    for (const std::string& element : found) color.push_back(parse_integer<int>(element, 0, 255));
  });
}

Option add_span(CLI::App& app, const std::string& name, std::vector<int>& span, const std::string& what) {
  return add_read(app, name, what, "FIRST-LAST", [&span, name](const std::string& text) {
    const size_t dash = text.find('-');
    if (text == "all") {
      span = {0, -1};
      return;
    }
    if (dash == std::string::npos)
      throw CLI::ValidationError(name, fmt::format("found {}, expected FIRST-LAST or all", quote(text)));
    const int first = parse_integer<int>(text.substr(0, dash), 0);
    span = {first, parse_integer<int>(text.substr(dash + 1), first)};
  });
}

}  // namespace pipegs
