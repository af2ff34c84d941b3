// SPDX-License-Identifier: Apache-2.0
// png_size: width and height of a PNG, of its first 24 bytes.
//
// Layout  8 bytes of signature, 4 of length, "IHDR", width and height, each 4 bytes, the high one first.
#include <array>
#include <fstream>
#include <string_view>

#include "scenes/cameras/forms.hpp"

namespace pipegs {

bool png_size(const std::filesystem::path& path, int& width, int& height) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::array<char, 24> head{};
  if (!std::ifstream(path, std::ios::binary).read(head.data(), head.size())) return false;
  const std::string_view text(head.data(), head.size());
  if (!text.starts_with("\x89PNG\r\n\x1a\n") || text.substr(12, 4) != "IHDR") return false;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(text[at + i]);
    return value;
  };
  const std::uint32_t columns = number(16), rows = number(20);
  if (columns < 1 || columns > kMaxImageSide || rows < 1 || rows > kMaxImageSide) return false;
  width = static_cast<int>(columns);
  height = static_cast<int>(rows);
  return true;
}

}  // namespace pipegs
