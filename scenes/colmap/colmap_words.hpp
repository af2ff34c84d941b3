// SPDX-License-Identifier: Apache-2.0
// colmap_words: the fields of a line of COLMAP's text files, taken in order.
//
// Errors  InputError with the line and the field: "images.txt: line 7, rotation: found 'x', expected a number".
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>

#include "scenes/input_error.hpp"
#include "scenes/text/number.hpp"

namespace pipegs {

// The words of a line in their order.
class ColmapWords {
 public:
  ColmapWords(const std::string& file, std::string where, std::string_view line)
      : file_(file), where_(std::move(where)), rest_(line) {}

  bool empty() const { return rest_.find_first_not_of(" \t") == std::string_view::npos; }
  std::string_view word(std::string_view field) {
    const std::size_t begin = rest_.find_first_not_of(" \t");
    if (begin == std::string_view::npos) fail(field, "found the end of the line, expected a value");
    const std::size_t end = std::min(rest_.find_first_of(" \t", begin), rest_.size());
    const std::string_view taken = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return taken;
  }
  // All that is left, without the blanks round it.
  std::string_view tail(std::string_view field) {
    if (empty()) fail(field, "found the end of the line, expected a name");
    const std::size_t begin = rest_.find_first_not_of(" \t"), end = rest_.find_last_not_of(" \t");
    return rest_.substr(begin, end + 1 - begin);
  }
  template <std::integral T>
  T integer(std::string_view field, T low = std::numeric_limits<T>::min(), T high = std::numeric_limits<T>::max()) {
    const std::string_view taken = word(field);
    try {
      return parse_integer<T>(taken, low, high);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  double real(std::string_view field) {
    const std::string_view taken = word(field);
    try {
      return parse_real(taken);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  [[noreturn]] void fail(std::string_view field, std::string_view what) const {
    throw InputError(file_, fmt::format("{}, {}", where_, field), what);
  }

 private:
  const std::string& file_;
  std::string where_;
  std::string_view rest_;
};

}  // namespace pipegs
