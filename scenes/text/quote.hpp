// SPDX-License-Identifier: Apache-2.0
// quote: text out of a file or an option, as a message or a terminal may show it.
//
// Idea    A hostile file may hold a megabyte in one word, line breaks, codes that move a terminal's cursor or turn its
//         writing around, bytes that are no UTF-8. Each of these is shown as `?`; all else is left as it is.
// Rule    A message is one line of at most kLongestMessage characters, what it quotes kLongestQuotation bytes; where it
//         is longer its middle is left out, since it begins with the place and ends with the cause.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pipegs {

inline constexpr std::size_t kLongestQuotation = 60, kLongestMessage = 290;

namespace quote_detail {

// Bytes of the character at the front of `text`; 0 when there is none: no UTF-8, or not all of it.
inline std::size_t character(std::string_view text, std::uint32_t& value) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = at(0);
  const std::size_t bytes = first < 0x80   ? 1
                            : first < 0xc2 ? 0
                            : first < 0xe0 ? 2
                            : first < 0xf0 ? 3
                            : first < 0xf5 ? 4
                                           : 0;
  if (bytes == 0 || bytes > text.size()) return 0;
  value = bytes == 1 ? first : first & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((at(i) & 0xc0) != 0x80) return 0;
    value = value << 6 | (at(i) & 0x3fu);
  }
  const bool too_long = (bytes == 3 && value < 0x800) || (bytes == 4 && value < 0x10000);
  const bool surrogate = value >= 0xd800 && value < 0xe000;
  return too_long || surrogate || value > 0x10ffff ? 0 : bytes;
}

// Bytes at the end of `text` that begin a character and may go on.
inline std::size_t begun(std::string_view text) {
  for (std::size_t bytes = 1; bytes < 4 && bytes <= text.size(); ++bytes) {
    const auto first = static_cast<unsigned char>(text[text.size() - bytes]);
    if ((first & 0xc0) == 0x80) continue;
    return first >= 0xc2 && bytes < (first < 0xe0 ? 2u : first < 0xf0 ? 3u : 4u) ? bytes : 0;
  }
  return 0;
}

// Whether a terminal takes the character for anything but writing: controls, separators of lines, directions, marks
// that nobody sees.
inline bool is_command(std::uint32_t value) {
  const auto within = [value](std::uint32_t low, std::uint32_t high) { return value >= low && value <= high; };
  return value < 0x20 || within(0x7f, 0x9f) || value == 0x61c || value == 0x200b || within(0x200e, 0x200f) ||
         within(0x2028, 0x202e) || within(0x2060, 0x206f) || value == 0xfeff || within(0xfff9, 0xfffb) ||
         within(0xe0000, 0xe007f);
}

}  // namespace quote_detail

// As a terminal may show it; with `lines` line feeds and tabs stay.
inline std::string shown(std::string_view text, bool lines = false) {
  std::string out;
  while (!text.empty()) {
    std::uint32_t value = 0;
    const std::size_t bytes = quote_detail::character(text, value);
    const bool kept = bytes > 0 && (!quote_detail::is_command(value) || (lines && (value == '\n' || value == '\t')));
    if (kept) out += text.substr(0, bytes);
    else out += '?';
    text.remove_prefix(bytes > 0 ? bytes : 1);
  }
  return out;
}

inline std::string one_line(std::string_view text) { return shown(text); }

// Without a line break or another control character of ASCII: what a name may be that stands in a line of commands.
inline bool is_one_line(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

// At most so many bytes of `text`, no character of it cut, with `...` for what is left out of its middle.
inline std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const auto begins = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xc0) != 0x80; };
  std::size_t head = (most - 5) / 2, tail = text.size() - (most - 5 - head);
  while (!begins(head)) --head;
  while (tail < text.size() && !begins(tail)) ++tail;
  return text.substr(0, head) + " ... " + text.substr(tail);
}

// One line that a log or a terminal takes whole.
inline std::string message_line(std::string_view text) { return shortened(one_line(text), kLongestMessage); }

inline std::string quote(std::string_view text) {
  std::size_t end = text.size();
  if (end > kLongestQuotation) {
    end = kLongestQuotation;
    while (end > kLongestQuotation - 4 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  }
  return "'" + one_line(text.substr(0, end)) + (end < text.size() ? "...'" : "'");
}

}  // namespace pipegs
