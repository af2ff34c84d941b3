// SPDX-License-Identifier: Apache-2.0
// gltf_data: see gltf_data.hpp.
#include "scenes/formats/gltf_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"

namespace pipegs {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

struct Component {
  int code;
  std::uint64_t size;
  double most;  // what is 1 when it is normalized
  const char* name;
};
constexpr std::array kComponents = {
    Component{5120, 1, 127, "int8"},     Component{5121, 1, 255, "uint8"},           Component{5122, 2, 32767, "int16"},
    Component{5123, 2, 65535, "uint16"}, Component{5125, 4, 4294967295.0, "uint32"}, Component{5126, 4, 1, "float32"}};

const Component& component_of(int code) {
  return *std::find_if(kComponents.begin(), kComponents.end(), [&](const Component& c) { return c.code == code; });
}

// The chunk of a .glb with its type; empty when there is none.
std::string_view chunk(const InputFile& file, std::uint32_t type) {
  const std::uint64_t end = std::min<std::uint64_t>(file.at<std::uint32_t>(8, "header"), file.size());
  for (std::uint64_t at = 12; at < end;) {
    const auto length = file.at<std::uint32_t>(at, "chunk");
    const auto found = file.at<std::uint32_t>(at + 4, "chunk");
    const auto part = file.part(at + 8, length, "chunk");
    if (found == type) return {reinterpret_cast<const char*>(part.data()), part.size()};
    at += 8 + std::uint64_t{length};
  }
  return {};
}

bool is_binary(const InputFile& file) { return file.starts_with("glTF"); }

JsonNode json_of(const InputFile& file) {
  if (!is_binary(file)) return JsonNode::parse(file.name(), file.text());
  const auto version = file.at<std::uint32_t>(4, "header");
  if (version != 2) throw InputError(file.name(), "header", fmt::format("found glTF version {}, expected 2", version));
  return JsonNode::parse(file.name(), chunk(file, kJsonChunk));
}

int hexadecimal(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

std::string percent_decoded(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hexadecimal(text[i + 1]) : -1;
    const int low = high >= 0 ? hexadecimal(text[i + 2]) : -1;
    out += low >= 0 ? static_cast<char>(16 * high + low) : text[i];
    if (low >= 0) i += 2;
  }
  return out;
}

std::string base64_decoded(const JsonNode& place, std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string out;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) place.refuse("base64");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out += static_cast<char>(bits >> held);
  }
  return out;
}

}  // namespace

double GltfAccessor::value(std::size_t i, int k) const {
  const std::uint8_t* at = bytes + stride * i;
  const auto number = [&]() -> double {
    switch (component) {
      case 5120: return load<std::int8_t>(at + k);
      case 5121: return load<std::uint8_t>(at + k);
      case 5122: return load<std::int16_t>(at + 2 * k);
      case 5123: return load<std::uint16_t>(at + 2 * k);
      case 5125: return load<std::uint32_t>(at + 4 * k);
      default: return load<float>(at + 4 * k);
    }
  }();
  return normalized ? std::max(number / component_of(component).most, -1.0) : number;
}

std::string GltfAccessor::type() const {
  return std::string(component_of(component).name) + (normalized ? ", normalized" : "");
}

GltfData::GltfData(const InputFile& file)
    : file_(file),
      binary_(file.name(), is_binary(file) ? std::string(chunk(file, kBinaryChunk)) : std::string()),
      json_(json_of(file)) {
  bytes_.add(file);
  if (!is_binary(file)) return;
  const auto length = file.at<std::uint32_t>(8, "header");
  behind_ = file.behind(length);
  if (length > file.size())
    throw InputError(file.name(), "header",
                     fmt::format("found a length of {}, but the file has {} bytes", length, file.size()));
}

void GltfData::check_required(const std::vector<std::string>& known) const {
  if (!json_.has("extensionsRequired")) return;
  const JsonNode required = json_["extensionsRequired"];
  for (std::size_t i = 0; i < required.size(); ++i) {
    if (std::find(known.begin(), known.end(), required[i].text()) == known.end())
      required[i].refuse(fmt::format("extensions that are read here, such as {}", known.front()));
  }
}

const InputFile& GltfData::buffer(const JsonNode& index) {
  const std::uint64_t number = index.integer(0, UINT32_MAX);
  if (const auto known = buffers_.find(number); known != buffers_.end()) return known->second;
  const JsonNode entry = json_["buffers"][static_cast<std::size_t>(number)];
  if (!entry.has("uri")) {
    if (number != 0 || !is_binary(file_)) entry.refuse("a buffer with a 'uri'");
    return buffers_.emplace(number, binary_).first->second;
  }
  const JsonNode place = entry["uri"];
  const std::string uri = place.text();
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = uri.find(kMark);
  const bool inside = uri.starts_with("data:") && mark != std::string::npos;
  if (inside) {
    const std::string_view digits = std::string_view(uri).substr(mark + kMark.size());
    return buffers_.emplace(number, InputFile(file_.name(), base64_decoded(place, digits))).first->second;
  }
  auto known = files_.find(uri);
  if (known == files_.end()) known = files_.emplace(uri, file_.beside(percent_decoded(uri))).first;
  bytes_.add(known->second);
  if (entry.has("byteLength") && known->second.size() < entry["byteLength"].integer(0, UINT64_MAX))
    refuse_foreign(known->second.name(), known->second.text(), "a buffer of glTF");
  return buffers_.emplace(number, known->second).first->second;
}

InputFile GltfData::view(const JsonNode& index) {
  const JsonNode entry = json_["bufferViews"][index.integer(0, UINT32_MAX)];
  const InputFile& whole = buffer(entry["buffer"]);
  const std::uint64_t offset = entry.has("byteOffset") ? entry["byteOffset"].integer(0, UINT64_MAX) : 0;
  const auto part = whole.part(offset, entry["byteLength"].integer(0, UINT64_MAX), entry.where());
  return {file_.name(), std::string(part.begin(), part.end())};
}

// A view that one accessor has for itself, and fills as numbers of another size would.
void GltfData::check_component(const JsonNode& entry, std::uint64_t view, std::uint64_t numbers, std::uint64_t room) {
  const JsonNode all = json_["accessors"];
  const bool looked = !users_.empty();
  for (std::size_t i = 0; !looked && i < all.size(); ++i) {
    if (all[i].has("bufferView")) ++users_[all[i]["bufferView"].integer(0, UINT32_MAX)];
  }
  if (users_[view] != 1) return;
  for (const Component& other : kComponents) {
    if (numbers * other.size == room)
      entry["componentType"].refuse(fmt::format("one of {} bytes a number, as its bufferView has them", other.size));
  }
}

GltfAccessor GltfData::accessor(const JsonNode& index, std::uint64_t width) {
  static constexpr std::array kTypes = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  const JsonNode entry = json_["accessors"][index.integer(0, UINT32_MAX)];
  if (entry.has("sparse")) entry.refuse("an accessor that is not sparse");
  if (!entry.has("bufferView")) entry.refuse("an accessor with a 'bufferView'");
  if (entry["type"].text() != kTypes[width]) entry["type"].refuse(kTypes[width]);
  const auto code = static_cast<int>(entry["componentType"].integer(5120, 5126));
  if (code == 5124) entry["componentType"].refuse("5120 to 5123, 5125 or 5126");
  const bool normalized = entry.has("normalized") && entry["normalized"].boolean();
  const JsonNode view = json_["bufferViews"][entry["bufferView"].integer(0, UINT32_MAX)];
  const InputFile& whole = buffer(view["buffer"]);
  const std::uint64_t element = width * component_of(code).size, count = entry["count"].integer(0, UINT32_MAX);
  const std::uint64_t stride = view.has("byteStride") ? view["byteStride"].integer(element, 252) : element;
  const auto offset_of = [](const JsonNode& node) {
    return node.has("byteOffset") ? node["byteOffset"].integer(0, UINT32_MAX) : 0;
  };
  // The last element need not be followed by the rest of its stride.
  const std::uint64_t length = count == 0 ? 0 : stride * (count - 1) + element, first = offset_of(entry);
  const std::uint64_t room = view["byteLength"].integer(0, UINT32_MAX);
  if (first > room || length > room - first) entry.refuse(fmt::format("at most the {} bytes of its bufferView", room));
  if (!view.has("byteStride") && first == 0 && length < room)
    check_component(entry, entry["bufferView"].integer(0, UINT32_MAX), width * count, room);
  return {whole, whole.rows(offset_of(view) + first, length, 1, entry.where()), count, stride, code, normalized};
}

}  // namespace pipegs
