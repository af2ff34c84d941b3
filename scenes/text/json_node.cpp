// SPDX-License-Identifier: Apache-2.0
// json_node: see json_node.hpp.
#include "scenes/text/json_node.hpp"

#include <fmt/format.h>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {

struct JsonNode::Place {
  std::shared_ptr<const Place> around = {};  // none of the document
  const char* key = nullptr;                 // of an object, in the document; of an array
  std::size_t index = 0;
};

struct JsonNode::Document : Place {
  std::string file;
  nlohmann::json json;
};

const std::string& JsonNode::file() const {
  const Place* place = place_.get();
  while (place->around) place = place->around.get();
  return static_cast<const Document&>(*place).file;
}

std::string JsonNode::where() const {
  std::string text;
  for (const Place* place = place_.get(); place->around; place = place->around.get())
    text = (place->key == nullptr   ? fmt::format("[{}]", place->index)
            : place->around->around ? fmt::format(".{}", place->key)
                                    : place->key) +
           text;
  return text;
}

JsonNode JsonNode::parse(const std::string& file, std::string_view text) {
  if (text.size() > kMostJsonBytes)
    throw InputError(file, "", fmt::format("found {} bytes, expected JSON of at most {}", text.size(), kMostJsonBytes));
  const auto document = std::make_shared<const Document>(Document{{}, file, parse_json<nlohmann::json>(file, text)});
  return {document, document->json};
}

void JsonNode::fail(const std::string& what) const { throw InputError(file(), where(), what); }

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
  return {std::make_shared<const Place>(Place{place_, found.key().c_str()}), *found};
}

JsonNode JsonNode::operator[](std::size_t index) const {
  if (index >= size()) fail(fmt::format("found {} elements, expected more than {}", size(), index));
  return {std::make_shared<const Place>(Place{place_, nullptr, index}), (*json_)[index]};
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
