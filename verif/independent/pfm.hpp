// SPDX-License-Identifier: Apache-2.0
// pfm.hpp: the pictures that render.py writes.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "cpp_model/float/image.hpp"

namespace pipegs {

// A PFM as render.py writes it: "PF", size, little endian, three float32 channels, bottom row first.
inline Image read_pfm(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  double scale = 0;
  int width = 0, height = 0;
  file >> kind >> width >> height >> scale;
  file.get();
  if (!file || kind != "PF" || scale != -1.0) throw std::runtime_error(path.string() + " is no little-endian PFM");
  Image image(width, height);
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      float rgb[3];
      if (!file.read(reinterpret_cast<char*>(rgb), sizeof rgb)) throw std::runtime_error(path.string() + " ends early");
      image.rgb[image.at(x, y)] = {rgb[0], rgb[1], rgb[2]};
    }
  }
  return image;
}

}  // namespace pipegs
