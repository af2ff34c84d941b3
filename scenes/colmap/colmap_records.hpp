// SPDX-License-Identifier: Apache-2.0
// colmap_records: what the readers of both kinds of COLMAP's files have in common: a record's fields, taken in order.
//
// Idea    A Fields hands out the next number of a record, out of bytes or out of a line of text, and knows file, record
//         and field for the one line of an error. What a record means is written once, on top of it (colmap.cpp).
// Rule    Nothing is allocated on a count's word: a binary file must have the bytes that its counts promise.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "scenes/input_error.hpp"
#include "scenes/text/number.hpp"

namespace pipegs::colmap {

static_assert(std::endian::native == std::endian::little, "COLMAP's binary files are little-endian");

// Bytes in their order, never beyond the end.
class Bytes {
 public:
  Bytes(const std::string& file, std::string_view bytes) : file_(file), rest_(bytes) {}

  const std::string& file() const { return file_; }
  std::size_t remaining() const { return rest_.size(); }

  template <class T>
  T take(std::string_view where) {
    T value;
    std::memcpy(&value, skip(sizeof(T), where).data(), sizeof(T));
    return value;
  }
  std::string_view skip(std::uint64_t count, std::string_view where) {
    if (count > rest_.size()) {
      throw InputError(file_, where, fmt::format("found {} bytes before the end, expected {}", rest_.size(), count));
    }
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  // A count of things that take at least `least` bytes each.
  std::uint64_t count(std::size_t least, std::string_view where) {
    const auto found = take<std::uint64_t>(where);
    if (found > rest_.size() / least) {
      throw InputError(file_, where,
                       fmt::format("found a count of {}, expected at most {} in the {} bytes that follow", found,
                                   rest_.size() / least, rest_.size()));
    }
    return found;
  }
  std::string text(std::string_view where) {
    const std::size_t length = rest_.find('\0');
    if (length == std::string_view::npos)
      throw InputError(file_, where, "found no end, expected a name that ends in 0");
    const std::string_view taken = skip(length, where);
    skip(1, where);
    return std::string(taken);
  }

 private:
  const std::string& file_;
  std::string_view rest_;
};

// The words of a line in their order.
class Words {
 public:
  Words(const std::string& file, std::string where, std::string_view line)
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

}  // namespace pipegs::colmap
