// SPDX-License-Identifier: Apache-2.0
// json: see json.hpp.
//
// Idea    The library's parser keeps no stack of calls, so any depth can be parsed, but a value of that depth breaks
//         whoever walks through it. Its callback comes at each bracket and key: that is where depth and keys are
//         checked.
#include "scenes/text/json.hpp"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kLongestMessage = 200;  // it quotes the text that it read last, which may be a megabyte

// Where the parser is: a level for each open bracket.
class Place {
 public:
  explicit Place(const std::string& file) : file_(file) {}

  void open(bool object) {
    if (levels_.size() == kMostNested)
      throw InputError(file_, text(), fmt::format("found more than {} brackets inside each other", kMostNested));
    levels_.push_back({object, 0, {}, {}});
  }
  void close() {
    levels_.pop_back();
    value();
  }
  void key(const std::string& name) {
    Level& level = levels_.back();
    if (!level.keys.insert(name).second)
      throw InputError(file_, text(false), fmt::format("found a second {}, expected one", quote(name)));
    level.key = name;
  }
  void value() {
    if (!levels_.empty()) ++levels_.back().index;
  }

 private:
  struct Level {
    bool object;
    std::size_t index;  // of an array's element
    std::string key;    // of an object, the latest
    std::set<std::string> keys;
  };

  // Of the element that is being read, or of the bracket around it.
  std::string text(bool element = true) const {
    std::string text;
    for (std::size_t i = 0; i < levels_.size() - (element ? 0 : 1); ++i) {
      const Level& level = levels_[i];
      text += level.object ? fmt::format("{}{}", text.empty() ? "" : ".", level.key) : fmt::format("[{}]", level.index);
      if (text.size() > kLongestQuotation) return text.substr(0, kLongestQuotation) + "...";
    }
    return text.empty() ? "top level" : text;
  }

  const std::string& file_;
  std::vector<Level> levels_;
};

}  // namespace

template <typename Json>
Json parse_json(const std::string& file, std::string_view text) {
  Place place(file);
  const auto check = [&](int, typename Json::parse_event_t event, Json& parsed) {
    using Event = typename Json::parse_event_t;
    switch (event) {
      case Event::object_start:
      case Event::array_start: place.open(event == Event::object_start); break;
      case Event::object_end:
      case Event::array_end: place.close(); break;
      case Event::key: place.key(parsed.template get_ref<const std::string&>()); break;
      case Event::value: place.value(); break;
    }
    return true;
  };
  try {
    return Json::parse(text.begin(), text.end(), check);
  } catch (const typename Json::exception& error) {  // the library's message names line and column
    const std::string_view what = error.what();
    throw InputError(file, "", fmt::format("not JSON: {}", what.substr(0, kLongestMessage)));
  }
}

std::string valid_utf8(const std::string& text) {
  return nlohmann::json::parse(json_text(nlohmann::json(text))).get<std::string>();
}

template <typename Json>
Json read_json(const std::filesystem::path& path, std::string_view expected) {
  return parse_json<Json>(path.string(), read_text_file(path, expected, kMostJsonBytes));
}

template nlohmann::json parse_json(const std::string&, std::string_view);
template nlohmann::ordered_json parse_json(const std::string&, std::string_view);
template nlohmann::json read_json(const std::filesystem::path&, std::string_view);
template nlohmann::ordered_json read_json(const std::filesystem::path&, std::string_view);

}  // namespace pipegs
