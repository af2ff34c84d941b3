// SPDX-License-Identifier: Apache-2.0
// svg.cpp: see svg.hpp.
#include "sim/report/svg.hpp"

#include <fmt/format.h>

#include <array>

namespace pipegs {

std::string svg_head(double width, double height) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"pipegs-chart\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" "
      "font-family=\"system-ui, sans-serif\" font-size=\"11\">\n"
      "<style>.pipegs-chart {{ color: #1b1f24; }} @media (prefers-color-scheme: dark) {{ .pipegs-chart {{ color: "
      "#e6e9ee; }} }}</style>\n",
      width, height);
}

std::string svg_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

std::string svg_text(double x, double y, const std::string& anchor, const std::string& words, const std::string& more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"currentColor\"{}>{}</text>\n", x, y,
                     anchor, more, svg_escaped(words));
}

const char* svg_color(std::size_t number) {
  constexpr std::array<const char*, 8> kColors = {"#4c8fd6", "#e0873a", "#45a173", "#c05fb4",
                                                  "#b39a2d", "#8a8f98", "#d65c5c", "#3fa9b5"};
  return kColors[number % kColors.size()];
}

}  // namespace pipegs
