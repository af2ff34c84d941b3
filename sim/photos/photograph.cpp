// SPDX-License-Identifier: Apache-2.0
// photograph: see photograph.hpp.
//
// Idea    Rows first, then columns: a new pixel is a sum of old ones, each with the length of its overlap.
#include "sim/photos/photograph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/photos/jpeg.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kDepthOfPng = 24;  // the byte of the header that holds the bits of a channel

struct Overlap {
  int first;
  std::vector<double> lengths;  // of the old pixels from the first on; their sum is 1
};

// What each of `to` pixels covers of `from`.
std::vector<Overlap> overlaps(int from, int to) {
  std::vector<Overlap> all;
  const double side = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double begin = i * side, end = (i + 1) * side;
    Overlap overlap{static_cast<int>(begin), {}};
    for (int k = overlap.first; k < from && k < end; ++k)
      overlap.lengths.push_back((std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k))) / side);
    all.push_back(std::move(overlap));
  }
  return all;
}

}  // namespace

Rgb8 read_photograph(const std::filesystem::path& path, const Camera& camera) {
  require_regular_file(path, "a photograph");
  unsigned char head[kDepthOfPng + 1] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(head), sizeof head);
  if (head[0] == 0xff && head[1] == 0xd8 && head[2] == 0xff) return read_jpeg(path, camera.width, camera.height);
  if (!(head[0] == 0x89 && head[1] == 'P' && head[2] == 'N' && head[3] == 'G'))
    throw InputError(path.string(), "", "found neither a PNG nor a JPEG, expected a photograph");
  if (head[kDepthOfPng] > 8)
    throw InputError(path.string(), "", fmt::format("found {} bits for a channel, expected 8", head[kDepthOfPng]));
  Rgb8 picture = read_png8(path);
  if (picture.width == camera.width && picture.height == camera.height) return picture;
  throw InputError(
      path.string(), "",
      fmt::format("found {}x{} pixels, expected {}x{}", picture.width, picture.height, camera.width, camera.height));
}

Rgb8 shrunk(const Rgb8& picture, int width, int height) {
  if (width == picture.width && height == picture.height) return picture;
  const std::vector<Overlap> columns = overlaps(picture.width, width), rows = overlaps(picture.height, height);
  Rgb8 out{width, height, {}};
  out.data.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  std::vector<double> line(static_cast<std::size_t>(picture.width) * 3);
  for (const Overlap& row : rows) {
    std::fill(line.begin(), line.end(), 0.0);
    for (std::size_t k = 0; k < row.lengths.size(); ++k) {
      const std::uint8_t* old = picture.data.data() + (static_cast<std::size_t>(row.first) + k) * line.size();
      for (std::size_t i = 0; i < line.size(); ++i) line[i] += row.lengths[k] * old[i];
    }
    for (const Overlap& column : columns) {
      double sum[3] = {};
      for (std::size_t k = 0; k < column.lengths.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += column.lengths[k] * line[(static_cast<std::size_t>(column.first) + k) * 3 + c];
      }
      for (const double value : sum) out.data.push_back(static_cast<std::uint8_t>(std::lround(std::min(value, 255.0))));
    }
  }
  return out;
}

}  // namespace pipegs
