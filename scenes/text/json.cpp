// SPDX-License-Identifier: Apache-2.0
// json: see json.hpp.
//
// Idea    The library's parser tells of each bracket, key and value as it comes; the value is built here, where depth,
//         keys and memory are checked. Its own way to look in between, a callback, walks through all elements before
//         whenever one ends: a list of objects would take time with the square of its length.
//         NaN and Infinity, which Python writes, are read as texts.
#include "scenes/text/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <type_traits>
#include <vector>

#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kLongestSyntax = 200;  // it quotes the text that it read last, which may be a megabyte

// What a value takes of the memory, about; a container and a key of an object take more.
constexpr std::uint64_t kValueBytes = 32, kContainerBytes = 64, kKeyBytes = 80;

// Builds the value, a level for each open bracket.
template <typename Json>
class Builder final : public nlohmann::json_sax<Json> {
 public:
  using Text = typename Json::string_t;

  Builder(const std::string& file, std::string_view whole) : file_(file), whole_(whole) {}
  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(typename Json::number_integer_t value) override { return add(value); }
  bool number_unsigned(typename Json::number_unsigned_t value) override { return add(value); }
  bool number_float(typename Json::number_float_t value, const Text&) override { return add(value); }
  bool string(Text& value) override {
    charge(value.size());
    return add(std::move(value));
  }
  bool binary(typename Json::binary_t&) override { return false; }  // no JSON has it
  bool start_object(std::size_t) override { return open(Json::value_t::object); }
  bool start_array(std::size_t) override { return open(Json::value_t::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(Text& name) override {
    charge(kKeyBytes + name.size());
    Level& level = levels_.back();
    bool known;
    if constexpr (kOrdered) known = !level.keys.insert(name).second;
    else known = level.json->contains(name);
    if (known) throw InputError(file_, text(false), fmt::format("found a second {}, expected one", quote(name)));
    level.key = std::move(name);
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const typename Json::exception& error) override {
    const std::string_view what = error.what();  // names line and column
    refuse_foreign(file_, whole_, "JSON");
    throw InputError(file_, "", fmt::format("not JSON: {}", what.substr(0, kLongestSyntax)));
  }

 private:
  static constexpr bool kOrdered = std::is_same_v<Json, nlohmann::ordered_json>;

  struct Level {
    Json* json;
    std::string key;             // of an object, the latest
    std::set<std::string> keys;  // of an ordered object, which would look through all of them
  };

  template <typename Value>
  bool add(Value&& value) {
    place(std::forward<Value>(value));
    return true;
  }
  // The new element of the innermost bracket. A key is new there: it goes to the end, unseen by an ordered object,
  // which would look through all keys before it.
  template <typename Value>
  Json& place(Value&& value) {
    charge(kValueBytes);
    if (levels_.empty()) return root_ = Json(std::forward<Value>(value));
    Json& around = *levels_.back().json;
    if (around.is_array()) {
      auto& elements = around.template get_ref<typename Json::array_t&>();
      elements.emplace_back(std::forward<Value>(value));
      return elements.back();
    }
    auto& object = around.template get_ref<typename Json::object_t&>();
    if constexpr (kOrdered) {
      using Entries = typename Json::object_t::Container;
      static_cast<Entries&>(object).emplace_back(levels_.back().key, Json(std::forward<Value>(value)));
      return object.back().second;
    } else {
      return object.emplace(levels_.back().key, Json(std::forward<Value>(value))).first->second;
    }
  }
  bool open(typename Json::value_t kind) {
    charge(kContainerBytes);
    if (levels_.size() == kMostNested)
      throw InputError(file_, text(), fmt::format("found more than {} brackets inside each other", kMostNested));
    levels_.push_back({&place(kind), {}, {}});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }
  void charge(std::uint64_t bytes) {
    memory_ += bytes;
    if (memory_ > kMostJsonMemory)
      throw InputError(file_, text(), fmt::format("found more values than {} bytes of memory hold", kMostJsonMemory));
  }

  // Of the element that is being read, or of the bracket around it.
  std::string text(bool element = true) const {
    std::string text;
    for (std::size_t i = 0; i < levels_.size() - (element || levels_.empty() ? 0 : 1); ++i) {
      const Level& level = levels_[i];
      text += level.json->is_object() ? fmt::format("{}{}", text.empty() ? "" : ".", level.key)
                                      : fmt::format("[{}]", level.json->size() - (i + 1 < levels_.size() ? 1 : 0));
      if (text.size() > kLongestQuotation) return text.substr(0, kLongestQuotation) + "...";
    }
    return text.empty() ? "top level" : text;
  }

  const std::string& file_;
  std::string_view whole_;
  Json root_;
  std::vector<Level> levels_;
  std::uint64_t memory_ = 0;
};

// What Python writes for numbers that JSON has not, as texts; nothing where there is none. What a reader does not need
// may be one, and where it needs a number it names what it found.
std::optional<std::string> without_python_numbers(std::string_view text) {
  if (text.find("NaN") == text.npos && text.find("Infinity") == text.npos) return std::nullopt;
  std::string out;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quoted && text[i] == '\\' && i + 1 < text.size()) {
      out += text.substr(i++, 2);
      continue;
    }
    if (text[i] == '"') quoted = !quoted;
    std::size_t word = 0;
    for (const std::string_view number : {"NaN", "-Infinity", "Infinity"}) {
      if (!quoted && text.substr(i).starts_with(number)) word = std::max(word, number.size());
    }
    if (word == 0) {
      out += text[i];
    } else {
      out += '"';
      out += text.substr(i, word);
      out += '"';
      i += word - 1;
    }
  }
  return out;
}

}  // namespace

template <typename Json>
Json parse_json(const std::string& file, std::string_view text) {
  const std::optional<std::string> plain = without_python_numbers(text);
  if (plain) text = *plain;
  Builder<Json> builder(file, text);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
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
