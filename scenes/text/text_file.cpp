// SPDX-License-Identifier: Apache-2.0
// text_file: see text_file.hpp.
#include "scenes/text/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"

namespace pipegs {
namespace {

const char* kind_of(std::filesystem::file_type type) {
  using Type = std::filesystem::file_type;
  switch (type) {
    case Type::not_found: return "no file";
    case Type::directory: return "a folder";
    case Type::fifo: return "a pipe";
    case Type::socket: return "a socket";
    case Type::character:
    case Type::block: return "a device";
    default: return "something that cannot be read";
  }
}

}  // namespace

void require_regular_file(const std::filesystem::path& path, std::string_view expected) {
  std::error_code error;
  const std::filesystem::file_type type = std::filesystem::status(path, error).type();
  if (type == std::filesystem::file_type::regular) return;
  throw InputError(path.string(), "", fmt::format("cannot open: found {}, expected {}", kind_of(type), expected));
}

std::string read_text_file(const std::filesystem::path& path, std::string_view expected, std::uint64_t most_bytes) {
  require_regular_file(path, expected);
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file)
    throw InputError(path.string(), "", fmt::format("cannot open for reading, expected {}", expected));
  if (bytes > most_bytes) {
    throw InputError(path.string(), "",
                     fmt::format("found {} bytes, expected {} of at most {}", bytes, expected, most_bytes));
  }
  std::string text(static_cast<std::size_t>(bytes), '\0');
  file.read(text.data(), static_cast<std::streamsize>(bytes));
  if (file.gcount() != static_cast<std::streamsize>(bytes)) {
    throw InputError(path.string(), "", "the file ended while being read");
  }
  return text;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  text = without_mark(text);
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
  return lines;
}

}  // namespace pipegs
