// SPDX-License-Identifier: Apache-2.0
// byte_reader: the fields of a binary file, taken in order, never beyond its end.
//
// Idea    A reader knows its file and gets the element and field, so what is missing is named in one line.
// Rule    Little-endian, as the files are. Nothing is allocated on a count's word: count() holds it against the bytes
//         that follow.
// Errors  InputError: "file: where: found 3 bytes before the end, expected 8".
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "scenes/input_error.hpp"

namespace pipegs {

static_assert(std::endian::native == std::endian::little, "the files are little-endian, and copied as they are");

class ByteReader {
 public:
  ByteReader(const std::string& file, std::string_view bytes) : file_(file), rest_(bytes) {}

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

}  // namespace pipegs
