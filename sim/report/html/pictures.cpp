// SPDX-License-Identifier: Apache-2.0
// pictures.cpp: see pictures.hpp.
#include "sim/report/html/pictures.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace pipegs {
namespace {

constexpr size_t kMostBytes = 3000000;

}  // namespace

Rgb8 smaller(const Rgb8& picture, int step) {
  Rgb8 small{.width = (picture.width + step - 1) / step, .height = (picture.height + step - 1) / step, .data = {}};
  const auto row = static_cast<size_t>(picture.width);
  for (int y = 0; y < picture.height; y += step) {
    for (int x = 0; x < picture.width; x += step) {
      const int right = std::min(x + step, picture.width), low = std::min(y + step, picture.height);
      const int pixels = (right - x) * (low - y);
      for (size_t channel = 0; channel < 3; ++channel) {
        int sum = pixels / 2;
        for (int v = y; v < low; ++v) {
          for (int u = x; u < right; ++u)
            sum += picture.data[3 * (static_cast<size_t>(v) * row + static_cast<size_t>(u)) + channel];
        }
        small.data.push_back(static_cast<uint8_t>(sum / pixels));
      }
    }
  }
  return small;
}

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
      small.push_back({one.caption, one.id, png_bytes(smaller(*one.picture, step))});
      bytes += small.back().png.size();
    }
    if (bytes <= kMostBytes) break;
  }
  return small;
}

}  // namespace pipegs
