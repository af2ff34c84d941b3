// SPDX-License-Identifier: Apache-2.0
// pictures.cpp: see pictures.hpp.
#include "sim/report/html/pictures.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "sim/photos/photograph.hpp"

namespace pipegs {
namespace {

constexpr size_t kMostBytes = 3000000;

}  // namespace

std::string png_bytes(const Rgb8& picture) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("pipegs_picture_{}.png", getpid());
  write_png8(path, picture);
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::remove(path);
  return bytes;
}

std::vector<SmallPicture> small_pictures(const std::vector<NamedPicture>& pictures) {
  std::vector<SmallPicture> small;
  for (int width = 640; width >= 40; width /= 2) {
    small.clear();
    size_t bytes = 0;
    for (const NamedPicture& one : pictures) {
      const int step = std::max(1, (one.picture->width + width - 1) / width);
      const int columns = (one.picture->width + step - 1) / step, rows = (one.picture->height + step - 1) / step;
      small.push_back({one.caption, one.id, png_bytes(shrunk(*one.picture, columns, rows))});
      bytes += small.back().png.size();
    }
    if (bytes <= kMostBytes) break;
  }
  return small;
}

}  // namespace pipegs
