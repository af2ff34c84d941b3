// SPDX-License-Identifier: Apache-2.0
// document.hpp: one HTML file that needs no other: a template, JSON for its script, and planes of numbers.
//
// Format  JSON in an element of its own. A plane is a picture in lossless WebP, as base64: three numbers of a place are
//         its red, green and blue, one is its green, one of two bytes has its high byte in red. Of all ways tried
//         it is the smallest and the quickest to open. Files are deflated. Read by sim/report/page/data.mjs.
// Errors  std::invalid_argument: numbers of another count than the plane's places. A side is at most kLongestSide.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pipegs {

class HtmlDocument {
 public:
  // `kind` is the page's, `command` makes it again.
  HtmlDocument(const std::string& kind, const std::string& title, const std::string& command);

  nlohmann::ordered_json data;

  static constexpr int kLongestSide = 16383;  // of WebP

  // Row by row, `channels` (1 or 3) numbers for each place.
  void add_plane(const std::string& name, int width, int height, int channels, const std::vector<uint8_t>& values);
  void add_plane(const std::string& name, int width, int height, const std::vector<uint16_t>& values);
  // A file as it is, deflated.
  void add_file(const std::string& name, const std::string& bytes);

  // The whole file.
  std::string text(const std::string& html_template) const;

 private:
  void add(const std::string& name, int width, int height, const char* kind, const std::vector<uint8_t>& rgb);

  std::string planes_;
};

std::string base64(const std::string& bytes);

}  // namespace pipegs
