// SPDX-License-Identifier: Apache-2.0
// document.cpp: see document.hpp.
#include "sim/report/html/document.hpp"

#include <fmt/format.h>
#include <webp/encode.h>
#include <zlib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace pipegs {
namespace {

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib cannot deflate a part of a page");
  out.resize(size);
  return out;
}

void check(const std::string& name, int width, int height, int channels, size_t count) {
  const auto places = static_cast<size_t>(width) * static_cast<size_t>(height);
  if (width < 1 || height < 1 || std::max(width, height) > HtmlDocument::kLongestSide ||
      count != places * static_cast<size_t>(channels))
    throw std::invalid_argument(fmt::format("plane {}: {} numbers for {}x{}x{}", name, count, width, height, channels));
}

std::string block(const std::string& type, const std::string& id, const std::string& text) {
  return fmt::format("<script type=\"{}\" id=\"{}\">{}</script>\n", type, id, text);
}

// JSON that ends no element, whatever its strings hold.
std::string safe(const nlohmann::ordered_json& data) {
  std::string text = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  for (size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6) text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    const size_t n = std::min<size_t>(3, bytes.size() - i);
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += k <= n ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

HtmlDocument::HtmlDocument(const std::string& kind, const std::string& title, const std::string& command)
    : data({{"kind", kind}, {"title", title}, {"command", command}, {"planes", nlohmann::ordered_json::object()}}) {}

void HtmlDocument::add(const std::string& name, int width, int height, const char* kind,
                       const std::vector<uint8_t>& rgb) {
  uint8_t* coded = nullptr;
  const size_t size = WebPEncodeLosslessRGB(rgb.data(), width, height, 3 * width, &coded);
  const std::unique_ptr<uint8_t, decltype(&WebPFree)> freed(coded, WebPFree);
  if (size == 0) throw std::runtime_error("WebP cannot take a part of a page");
  data["planes"][name] = {{"width", width}, {"height", height}, {"kind", kind}};
  planes_ += block("text/plain", "plane:" + name, base64({reinterpret_cast<const char*>(coded), size}));
}

void HtmlDocument::add_plane(const std::string& name, int width, int height, int channels,
                             const std::vector<uint8_t>& values) {
  check(name, width, height, channels, values.size());
  if (channels == 3) return add(name, width, height, "rgb8", values);
  std::vector<uint8_t> rgb(3 * values.size(), 0);
  for (size_t i = 0; i < values.size(); ++i) rgb[3 * i + 1] = values[i];
  add(name, width, height, "u8", rgb);
}

void HtmlDocument::add_plane(const std::string& name, int width, int height, const std::vector<uint16_t>& values) {
  check(name, width, height, 1, values.size());
  std::vector<uint8_t> rgb(3 * values.size(), 0);
  for (size_t i = 0; i < values.size(); ++i) {
    rgb[3 * i] = static_cast<uint8_t>(values[i] >> 8);
    rgb[3 * i + 1] = static_cast<uint8_t>(values[i]);
  }
  add(name, width, height, "u16", rgb);
}

void HtmlDocument::add_file(const std::string& name, const std::string& bytes) {
  planes_ += block("text/plain", "plane:" + name, base64(deflated(bytes)));
}

std::string HtmlDocument::text(const std::string& html_template) const {
  constexpr std::string_view kPlace = "<!--data-->";
  const size_t at = html_template.find(kPlace);
  if (at == std::string::npos) throw std::invalid_argument("a template without a place for data");
  return html_template.substr(0, at) + block("application/json", "data", safe(data)) + planes_ +
         html_template.substr(at + kPlace.size());
}

}  // namespace pipegs
