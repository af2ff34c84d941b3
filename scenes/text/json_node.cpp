// SPDX-License-Identifier: Apache-2.0
// json_node: see json_node.hpp.
#include "scenes/text/json_node.hpp"

#include <fmt/format.h>

#include <utility>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {

struct JsonNode::Document {
  std::string file;
  nlohmann::json json;
};

JsonNode::JsonNode(std::shared_ptr<const Document> document, const nlohmann::json& json, std::string where)
    : document_(std::move(document)), json_(&json), where_(std::move(where)) {}

const std::string& JsonNode::file() const { return document_->file; }

JsonNode JsonNode::parse(const std::string& file, std::string_view text) {
  if (text.size() > kMostJsonBytes)
    throw InputError(file, "", fmt::format("found {} bytes, expected JSON of at most {}", text.size(), kMostJsonBytes));
  auto document = std::make_shared<const Document>(Document{file, parse_json<nlohmann::json>(file, text)});
  const nlohmann::json& whole = document->json;
  return {std::move(document), whole, ""};
}

void JsonNode::fail(const std::string& what) const { throw InputError(file(), where_, what); }

void JsonNode::refuse(const std::string& expected) const {
  fail(fmt::format("found {}, expected {}", quote(json_text(*json_)), expected));
}

bool JsonNode::has(const char* key) const { return json_->is_object() && json_->contains(key); }

bool JsonNode::is_array() const { return json_->is_array(); }

bool JsonNode::is_null() const { return json_->is_null(); }

JsonNode JsonNode::operator[](const char* key) const {
  if (!json_->is_object()) refuse("an object");
  const auto found = json_->find(key);
  if (found == json_->end()) fail(fmt::format("{} is missing", quote(key)));
  return {document_, *found, where_.empty() ? key : fmt::format("{}.{}", where_, key)};
}

JsonNode JsonNode::operator[](std::size_t index) const {
  if (index >= size()) fail(fmt::format("found {} elements, expected more than {}", size(), index));
  return {document_, (*json_)[index], fmt::format("{}[{}]", where_, index)};
}

std::size_t JsonNode::size() const {
  if (!json_->is_array()) refuse("an array");
  return json_->size();
}

std::vector<std::string> JsonNode::keys() const {
  if (!json_->is_object()) refuse("an object");
  std::vector<std::string> keys;
  for (const auto& [key, value] : json_->items()) keys.push_back(key);
  return keys;
}

std::uint64_t JsonNode::integer(std::uint64_t low, std::uint64_t high) const {
  try {
    return json_integer<std::uint64_t>(*json_, low, high);
  } catch (const NumberError& error) { fail(error.what()); }
}

int JsonNode::whole(int low, int high) const {
  try {
    return json_integer(*json_, low, high);
  } catch (const NumberError& error) { fail(error.what()); }
}

double JsonNode::real(const RealRange& range) const {
  try {
    return json_real(*json_, range);
  } catch (const NumberError& error) { fail(error.what()); }
}

std::string JsonNode::text() const {
  if (!json_->is_string()) refuse("a text");
  return json_->get<std::string>();
}

bool JsonNode::boolean() const {
  if (!json_->is_boolean()) refuse("true or false");
  return json_->get<bool>();
}

std::vector<double> JsonNode::reals(std::size_t count) const {
  if (size() != count) fail(fmt::format("found {} numbers, expected {}", size(), count));
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back((*this)[i].real());
  return values;
}

}  // namespace pipegs
