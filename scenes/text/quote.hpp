// SPDX-License-Identifier: Apache-2.0
// quote: text out of a file or an option, as a message may show it.
//
// Idea    A hostile file may hold a megabyte in one word, line breaks, terminal codes. A message shows at most
//         kLongestQuotation bytes of it, and `?` for each control character, so that it stays one line in any log.
#pragma once

#include <string>
#include <string_view>

namespace pipegs {

inline constexpr std::size_t kLongestQuotation = 60;

inline std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

inline std::string quote(std::string_view text) {
  std::string out = "'";
  out += text.substr(0, kLongestQuotation);
  if (text.size() > kLongestQuotation) out += "...";
  out += "'";
  return one_line(std::move(out));
}

}  // namespace pipegs
