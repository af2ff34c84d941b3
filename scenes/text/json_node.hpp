// SPDX-License-Identifier: Apache-2.0
// json_node: a place in a JSON text that is read field by field, and knows its name for errors.
//
// Idea    Who reads a format of nested objects asks for a key, an index, a number in a range; a node knows the file and
//         the way to itself, so every error says "file: meshes[0].primitives[0].mode: found ..., expected ...". The way
//         is kept as steps, not as text: a tree of a million nodes has few errors.
// Use     const JsonNode meta = JsonNode::parse(file, text);  meta["means"]["mins"].reals(3)
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/text/number.hpp"

namespace pipegs {

class JsonNode {
 public:
  // InputError unless the text is JSON of at most kMostJsonBytes.
  static JsonNode parse(const std::string& file, std::string_view text);

  bool has(const char* key) const;  // false for what is no object
  bool is_array() const;
  bool is_null() const;
  JsonNode operator[](const char* key) const;
  JsonNode operator[](std::size_t index) const;
  std::size_t size() const;               // of an array
  std::vector<std::string> keys() const;  // of an object
  const std::string& file() const;
  std::string where() const;

  std::uint64_t integer(std::uint64_t low, std::uint64_t high) const;
  int whole(int low, int high) const;
  double real(const RealRange& range = kFinite) const;
  std::string text() const;
  bool boolean() const;
  std::vector<double> reals(std::size_t count) const;

  // InputError of this place.
  [[noreturn]] void fail(const std::string& what) const;
  // "found (this value), expected ...".
  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  struct Place;     // a step, and the place from which it goes
  struct Document;  // the first place
  JsonNode(std::shared_ptr<const Place> place, const nlohmann::json& json) : place_(std::move(place)), json_(&json) {}

  std::shared_ptr<const Place> place_;
  const nlohmann::json* json_;
};

}  // namespace pipegs
